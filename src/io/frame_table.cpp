#include "phrame/io/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "phrame/algebra/error.hpp"
#include "phrame/io/json_text.hpp"

namespace phrame {
namespace {

void add_columns(std::vector<std::string>& columns, std::string_view vector) {
  for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{}{}", vector, axis));
}

void add_values(std::vector<double>& row, const Vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}

/// Throws Undecided where a number was rounded to infinity, which is no answer.
void require_finite(const std::vector<double>& row, const std::vector<std::string>& columns,
                    const Rational& t) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isfinite(row[k]))
      throw Undecided(fmt::format("frame_table: at t = {}, {} is beyond the range of doubles",
                                  abbreviated(to_string(t)), columns[k]));
}

std::pair<const char*, const char*> vector_names(TabulatedFrame frame) {
  switch (frame) {
    case TabulatedFrame::rmf:
      return {"f2", "f3"};
    case TabulatedFrame::erf:
      return {"e2", "e3"};
    case TabulatedFrame::frenet:
      return {"n", "b"};
  }
  return {"", ""};
}

}  // namespace

FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at) {
  FrameTable table;
  table.columns = {"t", "x", "y", "z"};
  add_columns(table.columns, "e1");
  for (const TabulatedFrame frame : frames) {
    const auto [second, third] = vector_names(frame);
    add_columns(table.columns, second);
    add_columns(table.columns, third);
  }
  const Vector<Polynomial> r = position(curve);
  const Frames of_curve(curve);
  std::optional<RmfAngle> angle;
  if (std::find(frames.begin(), frames.end(), TabulatedFrame::rmf) != frames.end())
    angle.emplace(curve, Reference::erf);
  for (const Rational& t : at) {
    const Frame<Rational> erf = of_curve.euler_rodrigues(t);
    std::vector<double> row{round_to_double(Real(t))};
    add_values(row, round_to_double(evaluate(r, t)));
    add_values(row, round_to_double(erf.e1));
    const auto add_frame = [&](const auto& frame) {
      add_values(row, round_to_double(frame.e2));
      add_values(row, round_to_double(frame.e3));
    };
    for (const TabulatedFrame frame : frames) {
      if (frame == TabulatedFrame::erf) add_frame(erf);
      if (frame == TabulatedFrame::rmf) add_frame(of_curve.rotation_minimizing(*angle, t));
      if (frame == TabulatedFrame::frenet) add_frame(of_curve.frenet(t));
    }
    require_finite(row, table.columns, t);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string to_csv(const FrameTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string to_json(const FrameTable& table) {
  const JsonOutput json = {
      {"phrame", "frames/1"}, {"columns", table.columns}, {"rows", table.rows}};
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
