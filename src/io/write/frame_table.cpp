#include "phrame/io/write/frame_table.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame {

std::string to_csv(const FrameTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.decimals) text += fmt::format("{}\n", fmt::join(row, ","));
  if (!table.decimals.empty()) return text;
  for (const auto& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) text += ',';
      if (!std::isnan(row[k])) fmt::format_to(std::back_inserter(text), "{}", row[k]);
    }
    text += '\n';
  }
  return text;
}

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

std::string to_npy(const FrameTable& table) {
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}",
                  table.rows.size(), table.columns.size());
  constexpr std::size_t preamble = 10;  // magic, version, length of the header
  header.append(63 - (preamble + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFFU);
  bytes += static_cast<char>(header.size() >> 8U);
  bytes += header;
  for (const auto& row : table.rows)
    for (const double x : row) {
      const auto bits = std::bit_cast<std::uint64_t>(x);
      for (unsigned shift = 0; shift < 64; shift += 8)
        bytes += static_cast<char>((bits >> shift) & 0xFFU);
    }
  return bytes;
}

}  // namespace phrame
