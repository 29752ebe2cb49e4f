#pragma once
#include <cmath>
#include <complex>

#include "phrame/algebra/error_free.hpp"

namespace phrame::inline v0 {

/// A complex number within `error` of re + i·im, where the second double of each is at most half an
/// ulp of the first: balls of about 100 bits, for what needs no more and is to be quick.
///
/// What is computed with them holds in rounding to nearest. Overflow makes the error infinite or
/// not a number, never too small; nothing is decided but by comparisons that are false then.
struct NearComplex {
  DoubleDouble re;
  DoubleDouble im;
  double error = 0;
};

// The bounds, with u = 2^−53. A sum of two such pairs of doubles is off by at most 3u²·(|a| + |b|)
// and a product by 8u²·|ab|, each up to a factor 1 + 2^−40 [Joldes, Muller, Popescu
// 2017]. So the parts of a complex product are off by 11u²·(|x₁y₁| + |x₂y₂|), which is at most
// 11u²·|z||w| by the inequality of Cauchy and Schwarz, and the product by √2 times that, less than
// 2^−102·|z||w|. What underflows in it adds less than 2^−1000. Bounds are computed from terms ≥ 0,
// of which each operation rounds by u: `up` covers a hundred of them.

namespace pairs {

inline constexpr double up = 1 + 0x1p-46;
inline constexpr double down = 1 - 0x1p-46;
inline constexpr double rounding = 0x1p-102;
inline constexpr double least = 0x1p-1000;  ///< covers underflow
inline constexpr double least_size = 0x1p-500;

inline DoubleDouble sum(const DoubleDouble& a, const DoubleDouble& b) { return normalized(a + b); }
inline DoubleDouble negative(const DoubleDouble& a) { return {-a.high, -a.low}; }
inline DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  return normalized(a * b);
}

/// Not less than |re + i·im|.
inline double size_above(const NearComplex& z) {
  return std::sqrt(z.re.high * z.re.high + z.im.high * z.im.high) * up + least_size;
}
/// Not more than the absolute value of any number that z may be; perhaps negative.
inline double size_below(const NearComplex& z) {
  return std::sqrt(z.re.high * z.re.high + z.im.high * z.im.high) * down - least_size -
         z.error * up;
}

}  // namespace pairs

inline NearComplex operator+(const NearComplex& z, const NearComplex& w) {
  constexpr double rounding = 0x1p-104;  // 4u²
  return {
      pairs::sum(z.re, w.re), pairs::sum(z.im, w.im),
      (z.error + w.error + rounding * (pairs::size_above(z) + pairs::size_above(w))) * pairs::up};
}

inline NearComplex operator-(const NearComplex& z, const NearComplex& w) {
  return z + NearComplex{pairs::negative(w.re), pairs::negative(w.im), w.error};
}

inline NearComplex operator*(const NearComplex& z, const NearComplex& w) {
  const double a = pairs::size_above(z);
  const double b = pairs::size_above(w);
  return {
      pairs::sum(pairs::product(z.re, w.re), pairs::negative(pairs::product(z.im, w.im))),
      pairs::sum(pairs::product(z.re, w.im), pairs::product(z.im, w.re)),
      (a * w.error + (b + w.error) * z.error + pairs::rounding * a * b) * pairs::up + pairs::least};
}

/// 1/w = q·(1 + r + r²/(1 − r)) with r = 1 − w·q, q the quotient in doubles.
inline NearComplex inverse(const NearComplex& w) {
  const std::complex<double> q = 1.0 / std::complex<double>(w.re.high, w.im.high);
  const NearComplex quotient{{q.real()}, {q.imag()}};
  const NearComplex one{{1}, {}};
  const NearComplex rest = one - w * quotient;
  const double r = pairs::size_above(rest) + rest.error;
  NearComplex result = quotient + quotient * rest;
  result.error += pairs::size_above(quotient) * (r * r) * 2 + pairs::least;
  result.error *= pairs::up;
  if (!(r < 0.25)) result.error = INFINITY;
  return result;
}

inline NearComplex conjugate(const NearComplex& z) {
  return {z.re, pairs::negative(z.im), z.error};
}

}  // namespace phrame
