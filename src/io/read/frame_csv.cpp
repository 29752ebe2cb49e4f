#include "phrame/io/read/frame_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/frame_layout.hpp"
#include "phrame/io/read/frames_of_table.hpp"

namespace phrame::inline v0 {
namespace {

using ColumnNames = std::vector<std::string>;

}  // namespace

GivenTable frames_of_table(std::unique_ptr<NumberTable> table, const FrameReading& reading,
                           std::size_t at_most) {
  GivenTable result;
  const FrameLayout layout = frame_layout(*table, reading, result);
  if (reading.skips_invalid) table = without_missing(std::move(table), layout.columns());
  result.has_quaternions = layout.has_quaternions();
  result.has_parameters = layout.has_parameters();
  const std::size_t rows = table->rows();
  const std::size_t count = std::min(rows, std::max(at_most, std::size_t{2}));
  result.frames.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = count == rows ? k : k * (rows - 1) / (count - 1);
    result.frames.push_back(layout.frame(*table, row, reading));
    if (auto position = layout.position(*table, row)) result.positions.push_back(*position);
  }
  result.notes.insert(result.notes.begin(), table->notes().begin(), table->notes().end());
  return result;
}

GivenTable read_frames(std::string_view bytes, const FrameReading& reading, std::size_t at_most) {
  return frames_of_table(read_number_table(bytes, {reading.names.empty(), "frames"}), reading,
                         at_most);
}

std::vector<GivenPosition> read_positions(std::string_view bytes, const FrameReading& reading) {
  const auto table = read_number_table(bytes, {});
  const auto number = [&](std::size_t row, std::string_view name) {
    const auto found = std::ranges::find(reading.names, name);
    return table->number(row, static_cast<std::size_t>(found - reading.names.begin()));
  };
  std::vector<GivenPosition> positions;
  for (std::size_t row = 0; row < table->rows(); ++row)
    positions.push_back({number(row, "t"), {number(row, "x"), number(row, "y"), number(row, "z")}});
  return positions;
}

namespace {

/// The orders of the nine numbers of a matrix: by rows or by columns, the tangent at any place.
std::vector<ColumnNames> matrix_names(bool has_position) {
  std::vector<ColumnNames> all;
  for (const bool is_transposed : {true, false})
    for (std::size_t first = 0; first < 3; ++first) {
      std::array<std::string_view, 3> vectors{"e1", "f2", "f3"};
      std::rotate(vectors.begin(), vectors.begin() + (3 - first) % 3, vectors.end());
      ColumnNames names{"t"};
      if (has_position) add_triple(names, "");
      for (std::size_t k = 0; k < 9; ++k)
        names.push_back(fmt::format("{}{}", vectors[is_transposed ? k % 3 : k / 3],
                                    "xyz"[is_transposed ? k / 3 : k % 3]));
      all.push_back(names);
    }
  return all;
}

}  // namespace

std::vector<FrameReading> other_readings(const GivenTable& table, const FrameReading& reading) {
  std::vector<FrameReading> others;
  using Quaternion = FrameReading::Quaternion;
  if (table.has_quaternions || table.has_matrices) {
    for (const bool is_other_order : {false, true})
      if (table.has_quaternions || !is_other_order)
        for (const std::size_t turn : {0U, 2U, 1U})
          for (const bool is_opposite : {false, true})
            for (const bool is_inverse : {false, true}) {
              FrameReading other = reading;
              if (is_other_order)
                other.quaternion =
                    reading.quaternion == Quaternion::xyzw ? Quaternion::wxyz : Quaternion::xyzw;
              other.tangent_axis = (reading.tangent_axis + turn) % 3;
              other.is_axis_reversed = reading.is_axis_reversed != is_opposite;
              other.is_inverse = reading.is_inverse != is_inverse;
              if (other != reading) others.push_back(other);
            }
    const auto changes = [&](const FrameReading& other) {
      return (other.quaternion != reading.quaternion ? 1 : 0) +
             (other.tangent_axis != reading.tangent_axis ? 1 : 0) +
             (other.is_axis_reversed != reading.is_axis_reversed ? 1 : 0) +
             (other.is_inverse != reading.is_inverse ? 1 : 0);
    };
    std::stable_sort(
        others.begin(), others.end(),
        [&](const FrameReading& a, const FrameReading& b) { return changes(a) < changes(b); });
    return others;
  }
  if (table.columns.empty() || table.skipped > 0) return {};
  const std::size_t columns = table.columns.size();
  std::vector<ColumnNames> names;
  if (columns == 10 || columns == 13) names = matrix_names(columns == 13);
  if (columns == 7)
    for (const std::string_view first : {"e1", ""}) {
      names.push_back({"t"});
      add_triple(names.back(), first);
      add_triple(names.back(), "f2");
    }
  for (const ColumnNames& list : names) {
    FrameReading other = reading;
    other.names = list;
    others.push_back(other);
  }
  return others;
}

std::string to_options(const FrameReading& reading) {
  ColumnNames options;
  using Quaternion = FrameReading::Quaternion;
  if (reading.quaternion != Quaternion::named)
    options.push_back(reading.quaternion == Quaternion::xyzw ? "--quaternion xyzw"
                                                             : "--quaternion wxyz");
  if (reading.is_axis_reversed || reading.tangent_axis != 0)
    options.push_back(fmt::format("--tangent-axis{}{}", reading.is_axis_reversed ? "=-" : " ",
                                  "xyz"[reading.tangent_axis]));
  if (reading.is_inverse) options.emplace_back("--inverse");
  if (!reading.names.empty())
    options.push_back(fmt::format("--header {}", fmt::join(reading.names, ",")));
  return fmt::format("{}", fmt::join(options, " "));
}

}  // namespace phrame
