#include "phrame/io/read/pose_columns.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Does this hold for the numbers of every row that has all of them, and is there one?
template <class Holds>
bool holds_in_rows(const NumberTable& table, std::size_t from, std::size_t count, Holds holds) {
  bool is_any = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<Rational> numbers;
    try {
      for (std::size_t k = from; k < from + count && !table.is_missing(row, k); ++k)
        numbers.push_back(table.number(row, k));
    } catch (const InputError&) {
      return false;
    }
    if (numbers.size() < count) continue;
    if (!holds(numbers)) return false;
    is_any = true;
  }
  return is_any;
}

bool is_near(const Rational& x, long wanted) { return abs(x - wanted) <= Rational(1, 100); }

bool is_rotation(const std::vector<Rational>& numbers, const std::array<std::size_t, 9>& at) {
  std::array<Vector<Rational>, 3> row;
  for (std::size_t k = 0; k < 9; ++k) row[k / 3][k % 3] = numbers[at[k]];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (!is_near(dot(row[i], row[j]), i == j ? 1 : 0)) return false;
  return dot(cross(row[0], row[1]), row[2]) > 0;
}

/// By rows or by columns, of `height` rows of 4.
PoseColumns layout(std::size_t height, bool is_by_columns) {
  const auto at = [&](std::size_t i, std::size_t j) {
    return is_by_columns ? height * j + i : 4 * i + j;
  };
  PoseColumns columns{{at(0, 3), at(1, 3), at(2, 3)}, {}, {}};
  for (std::size_t k = 0; k < 9; ++k) columns.rotation[k] = at(k / 3, k % 3);
  columns.what = std::string(height == 3 ? "3 × 4" : "4 × 4") + " matrices, " +
                 (is_by_columns ? "column by column" : "row by row");
  return columns;
}

}  // namespace

std::optional<PoseColumns> matrix_columns(const NumberTable& table) {
  const std::size_t count = table.columns();
  if (count != 12 && count != 16) return std::nullopt;
  for (const bool is_by_columns : {false, true}) {
    if (count == 12 && is_by_columns) continue;
    const PoseColumns columns = layout(count / 4, is_by_columns);
    const auto ends_well = [&](const std::vector<Rational>& numbers) {
      for (std::size_t k = 0; count == 16 && k < 4; ++k)
        if (numbers[is_by_columns ? 4 * k + 3 : 12 + k] != (k == 3 ? 1 : 0)) return false;
      return is_rotation(numbers, columns.rotation);
    };
    if (holds_in_rows(table, 0, count, ends_well)) return columns;
  }
  return std::nullopt;
}

bool is_unit_quaternion(const NumberTable& table, std::size_t first_column) {
  return holds_in_rows(table, first_column, 4, [](const std::vector<Rational>& q) {
    return is_near(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1);
  });
}

}  // namespace phrame
