#pragma once
#include <limits>
#include <vector>

#include "phrame/algebra/piece_groups.hpp"

namespace phrame::inline v0 {

/// Many numbers as NearNumber, part by part.
struct NearNumbers {
  std::vector<double> high;
  std::vector<double> low;
  std::vector<double> error;

  /// So many of which nothing is known, to be asked about at `place`.
  NearNumbers(std::size_t size, double place)
      : high(size, place), low(size), error(size, std::numeric_limits<double>::infinity()) {}
  std::size_t size() const { return high.size(); }
  void set(std::size_t k, const NearNumber& x) {
    high[k] = x.value.high;
    low[k] = x.value.low;
    error[k] = x.error;
  }
};

/// near_values() at several t: number k of the values is that of polynomial k % width at t number
/// k / width. Where there is none the error is infinite.
template <std::size_t width, class T, std::size_t count>
struct WideNearValues {
  std::array<SumOfTwo<T>, width * count> values;
  std::array<T, count> errors;
};

/// The t of a group are doubles, of which nothing else is to be known.
struct OnlyDoubles {};

/// Of those of a group from number k on.
template <std::size_t width, class T, std::size_t count>
[[gnu::always_inline]] inline WideNearValues<width, T, count> near_values(const PieceGroup& group,
                                                                          const DoubleShape& shape,
                                                                          const OnlyDoubles&,
                                                                          std::size_t k) {
  const PolynomialPiece& piece = group.piece;
  std::array<T, count> y;
  group.load(k, y);
  WideNearValues<width, T, count> near{
      compensated_values<width>(piece.coefficients.data(), shape, y), {}};
  for (std::size_t i = 0; i < count; ++i)
    near.errors[i] = piece.error + piece.error_per_y * (y[i] < 0.0 ? -y[i] : y[i]);
  return near;
}

/// The same, where the t of the group are the high parts of these.
template <std::size_t width, class T, std::size_t count>
[[gnu::always_inline]] inline WideNearValues<width, T, count> near_values(const PieceGroup& group,
                                                                          const DoubleShape& shape,
                                                                          const NearNumbers& t,
                                                                          std::size_t k) {
  const PolynomialPiece& piece = group.piece;
  const double* coefficients = piece.coefficients.data();
  std::array<T, count> y;
  std::array<T, count> low;
  std::array<T, count> error;
  group.load(k, y);
  group.load_others(k, t.low, low);
  group.load_others(k, t.error, error);
  WideNearValues<width, T, count> near{compensated_values<width>(coefficients, shape, y), {}};
  const auto slopes = slope_values<width>(coefficients, shape, y);
  for (std::size_t i = 0; i < count; ++i) {
    const T z = low[i] * piece.scale;
    const T r = error[i] * piece.scale;
    const T most_z = (z < 0.0 ? -z : z) + r;
    const T most_y = y[i] < 0.0 ? -y[i] : y[i];
    T size{};
    for (std::size_t j = 0; j < width; ++j) {
      SumOfTwo<T>& value = near.values[i * width + j];
      size += value.high < 0.0 ? -value.high : value.high;
      value = two_sum(value.high, value.low + slopes[i * width + j] * z);
    }
    // As in near_values() of one t; where that is a double the value has the error of the piece.
    const T of_piece = piece.error + piece.error_per_y * (most_y + most_z);
    const T of_t = piece.steepness * (most_z * (2 * slope_error + most_z) + r) + size * 0x1p-104 +
                   underflow_error * (1 + piece.steepness);
    const T inside = piece.steepness == 0 ? of_piece : (of_piece + of_t) * (1 + 0x1p-40);
    const T nothing = T{} + std::numeric_limits<double>::infinity();
    const T beside = ((most_y <= 1 - 0x1p-30) & (most_z <= 0x1p-31)) ? inside : nothing;
    near.errors[i] = most_z == 0.0 ? of_piece : beside;
  }
  return near;
}

}  // namespace phrame
