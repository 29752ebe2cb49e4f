#include "phrame/io/write/frame_table.hpp"

#include <fmt/compile.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/row_format.hpp"

namespace phrame::inline v0 {

namespace {

std::string csv_header(const std::vector<std::string>& columns, std::size_t) {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

void append_csv(std::string& text, const std::vector<double>& row) {
  // Written where it stays: to copy so few characters at a time takes as long as to find them.
  constexpr std::size_t most_of_cell = 32;
  const std::size_t before = text.size();
  text.resize(before + most_of_cell * row.size() + 1);
  char* end = text.data() + before;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) *end++ = ',';
    if (!std::isnan(row[k])) end = fmt::format_to(end, FMT_COMPILE("{}"), row[k]);
  }
  *end++ = '\n';
  text.resize(static_cast<std::size_t>(end - text.data()));
}

std::string npy_header(const std::vector<std::string>& columns, std::size_t rows) {
  std::string header = fmt::format(
      "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns.size());
  constexpr std::size_t before = 10;  // magic, version, length of the header
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFFU);
  bytes += static_cast<char>(header.size() >> 8U);
  return bytes + header;
}

void append_npy(std::string& bytes, const std::vector<double>& row) {
  for (const double x : row) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (unsigned shift = 0; shift < 64; shift += 8)
      bytes += static_cast<char>((bits >> shift) & 0xFFU);
  }
}

std::string all_rows(const RowFormat& format, const FrameTable& table) {
  std::string text = format.header(table.columns, table.rows.size());
  for (const auto& row : table.rows) format.append(text, row);
  return text;
}

}  // namespace

RowFormat csv_rows() { return {csv_header, append_csv}; }
RowFormat npy_rows() { return {npy_header, append_npy}; }

std::string to_csv(const FrameTable& table) {
  if (table.decimals.empty()) return all_rows(csv_rows(), table);
  std::string text = csv_header(table.columns, table.decimals.size());
  for (const auto& row : table.decimals) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string to_npy(const FrameTable& table) { return all_rows(npy_rows(), table); }

namespace {

JsonOutput rows_of(const std::vector<std::vector<std::string>>& decimals) {
  JsonOutput rows = JsonOutput::array();
  for (const auto& row : decimals) {
    JsonOutput cells = JsonOutput::array();
    for (const std::string& cell : row)
      cells.push_back(cell.empty() ? JsonOutput() : JsonOutput(cell));
    rows.push_back(std::move(cells));
  }
  return rows;
}

}  // namespace

std::string to_json(const FrameTable& table) {
  // NaN is written null.
  JsonOutput json = {{"phrame", table.format}, {"columns", table.columns}, {"rows", table.rows}};
  if (!table.decimals.empty()) json["rows"] = rows_of(table.decimals);
  if (table.start) {
    if (const auto* angle = std::get_if<Angle>(&*table.start)) json["theta0"] = to_string(*angle);
    add_start(json, *table.start);
  }
  if (table.up) json["up"] = json_of(*table.up);
  add_nearness(json, table.near);
  return json.dump() + "\n";
}

}  // namespace phrame
