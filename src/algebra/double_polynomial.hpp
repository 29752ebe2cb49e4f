#pragma once
#include <array>
#include <vector>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/error_free.hpp"

namespace phrame::inline v0 {

/// How `width` polynomials in y, |y| ≤ 1, of the same degree are kept in doubles: the coefficients
/// below y^paired as sums of two doubles, the others as one. In memory they follow as Horner's rule
/// needs them, from the highest to y⁰, of all polynomials together; the second doubles follow the
/// first ones.
struct DoubleShape {
  long width = 1;   ///< so many polynomials
  long degree = 1;  ///< in 1 … 63
  long paired = 1;  ///< in 1 … degree
  /// What a polynomial is to be off by, at most, relative to Σ |coefficients of y, y², …|.
  double goal = 0;

  long size() const { return width * (degree + 1 + paired); }  ///< so many doubles they are
  /// Where the coefficient of yᵏ of the first polynomial is; those of the others follow.
  long position(long k) const;
};

/// @{ For evaluation in doubles, and with compensation.
inline constexpr DoubleShape plain_shape(long width) { return {width, 11, 1, 0x1p-52}; }
inline constexpr DoubleShape compensated_shape(long width) { return {width, 16, 6, 0x1p-78}; }
/// @}

/// The doubles nearest to the middles of the balls; what is beyond the degree is left out.
std::vector<double> round_coefficients(const std::vector<BallPolynomial>& polynomials,
                                       const DoubleShape& shape);
/// The polynomial number `which` that these doubles are, exactly.
BallPolynomial exact_polynomial(const std::vector<double>& coefficients, const DoubleShape& shape,
                                long which);
/// By Horner's rule: from the lowest paired coefficient up in doubles, from there on with the
/// rounding errors summed in a second polynomial [Graillat, Langlois, Louvet, Algorithms for
/// accurate, validated and fast polynomial evaluation, Japan J. Indust. Appl. Math. 26 (2009)].
/// Precondition: |y| ≤ 1, shape.width = width. Width is 1 or 4.
template <std::size_t width>
std::array<DoubleDouble, width> evaluate_compensated(const double* coefficients,
                                                     const DoubleShape& shape, double y);

/// One step of it: s ← s·y + first, and what that is off by, and second, into c.
template <class T>
[[gnu::always_inline]] inline void compensated_step(T& s, T& c, const SplitFactor<T>& y,
                                                    double first, double second) {
  const SumOfTwo<T> product = two_product(split_factor(s), y);
  const SumOfTwo<T> sum = two_sum(product.high, T{} + first);
  s = sum.high;
  c = c * y.value + ((product.low + sum.low) + second);
}

/// The same in T, double or Wide<n>, for several y: number k is the value of polynomial k % width
/// at y[k / width].
template <std::size_t width, class T, std::size_t count, std::size_t... k>
[[gnu::always_inline]] inline std::array<SumOfTwo<T>, sizeof...(k)> compensated_values(
    const double* coefficients, const DoubleShape& shape, const std::array<T, count>& y,
    std::index_sequence<k...>) {
  const double* a = coefficients;
  T s[] = {T{} + a[k % width]...};
  a += width;
  for (long power = shape.degree - 1; power >= shape.paired; --power, a += width)
    ((s[k] = s[k] * y[k / width] + a[k % width]), ...);
  const SplitFactor<T> factors[] = {split_factor(y[k / width])...};
  T c[sizeof...(k)] = {};
  for (long power = shape.paired - 1; power >= 0; --power, a += 2 * width)
    (compensated_step(s[k], c[k], factors[k], a[k % width], a[width + k % width]), ...);
  return {two_sum(s[k], c[k])...};
}
template <std::size_t width, class T, std::size_t count>
[[gnu::always_inline]] inline std::array<SumOfTwo<T>, width * count> compensated_values(
    const double* coefficients, const DoubleShape& shape, const std::array<T, count>& y) {
  return compensated_values<width>(coefficients, shape, y,
                                   std::make_index_sequence<width * count>());
}

/// Their derivatives by y, by Horner's rule in doubles: off by at most slope_error·steepness().
template <std::size_t width>
std::array<double, width> evaluate_slope(const double* coefficients, const DoubleShape& shape,
                                         double y);
/// The same in T, double or Wide<n>, for several y, as compensated_values().
template <std::size_t width, class T, std::size_t count>
[[gnu::always_inline]] inline std::array<T, width * count> slope_values(
    const double* coefficients, const DoubleShape& shape, const std::array<T, count>& y) {
  const double* a = coefficients;
  std::array<T, width * count> s{};
  for (long k = shape.degree; k > 0; a += k < shape.paired ? 2 * width : width, --k)
    for (std::size_t i = 0; i < width * count; ++i)
      s[i] = s[i] * y[i / width] + static_cast<double>(k) * a[i % width];
  return s;
}
inline constexpr double slope_error = 0x1p-45;
/// Σ k²|coefficient of yᵏ| of all of them, not rounded down: a bound of first and second
/// derivatives on |y| ≤ 1.
double steepness(const std::vector<double>& coefficients, const DoubleShape& shape);

/// A bound of what evaluate_compensated is off by on |y| ≤ 1 for polynomial number `which`, but for
/// underflow; where p(0) = 0 the error is that times |y|. With paired = 1 it is of Horner's rule in
/// doubles too: first + (second + y·(…)), where first and second are those of y⁰, with and without
/// fused multiplication and addition.
double rounding_error(const std::vector<double>& coefficients, const DoubleShape& shape,
                      long which);
/// a + b for bounds a, b ≥ 0, not rounded down.
inline double sum_up(double a, double b) { return (a + b) * (1 + 0x1p-51); }
/// What underflow adds, at most, in y too; relative to 1 + Σ |coefficients|.
inline constexpr double underflow_error = 0x1p-1060;

}  // namespace phrame
