#pragma once
#include "phrame/algebra/error_free.hpp"

namespace phrame::inline v0 {

// Sums and products of numbers that are known to about 2^−100, with what they are off by, in
// rounding to nearest; for numbers between 2^−900 and 2^400, or 0. The errors are rounded to
// nearest, too: raised() makes up for that, after hundreds of operations.

/// x within `error`, with a low part of at most half an ulp of the high one.
inline NearNumber within(const DoubleDouble& x, double error) { return {normalized(x), error}; }

/// |x| as far as it matters for errors.
inline double size_of(const NearNumber& x) { return std::abs(x.value.high); }

inline constexpr double pair_error = 0x1p-99;  ///< of a sum or a product, relative to its terms
inline constexpr double pair_underflow = 0x1p-1050;  ///< and in addition
inline constexpr double raised(double error) { return error * (1 + 0x1p-40) + pair_underflow; }

inline NearNumber operator+(const NearNumber& a, const NearNumber& b) {
  return within(a.value + b.value, a.error + b.error + pair_error * (size_of(a) + size_of(b)));
}

inline NearNumber operator-(const NearNumber& x) {
  return {{-x.value.high, -x.value.low}, x.error};
}
inline NearNumber operator-(const NearNumber& a, const NearNumber& b) { return a + -b; }

inline NearNumber operator*(const NearNumber& a, const NearNumber& b) {
  const double size = size_of(a) * size_of(b);
  return within(a.value * b.value, size_of(a) * b.error + (size_of(b) + b.error) * a.error +
                                       pair_error * size + pair_underflow);
}

/// Between these doubles is a number ≥ 0.
struct NearBounds {
  double lower = 0;
  double upper = 0;
};

inline NearBounds size_bounds(const NearNumber& x) {
  const double error = raised(x.error);
  return {std::fmax(0, size_of(x) * (1 - 0x1p-50) - error * (1 + 0x1p-50)),
          (size_of(x) + error) * (1 + 0x1p-50)};
}

/// Is it certainly > 0?
inline bool is_positive(const NearNumber& x) {
  return x.value.high > 0 && size_bounds(x).lower > 0;
}

/// Not finite where b may be 0.
inline NearBounds quotient(const NearBounds& a, const NearBounds& b) {
  return {a.lower / b.upper * (1 - 0x1p-50), a.upper / b.lower * (1 + 0x1p-50)};
}

inline NearBounds product(const NearBounds& a, const NearBounds& b) {
  return {a.lower * b.lower * (1 - 0x1p-50), a.upper * b.upper * (1 + 0x1p-50)};
}

inline NearBounds root(const NearBounds& x) {
  return {std::sqrt(x.lower) * (1 - 0x1p-50), std::sqrt(x.upper) * (1 + 0x1p-50)};
}

inline NearBounds greater(const NearBounds& a, const NearBounds& b) {
  return {std::fmax(a.lower, b.lower), std::fmax(a.upper, b.upper)};
}

}  // namespace phrame
