#include "phrame/ph/sweep/length_share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long share_bits = 96;

/// |r′| around t, so many terms: r′·H/|H|, where H is along it.
BallPolynomial speed_series(const CurveSeries& path, std::size_t segment, const RealBall& t,
                            long terms) {
  const auto r = path.position(segment, t, terms + 1, share_bits);
  const auto along = along_motion(path, segment, t, r, terms, share_bits);
  BallPolynomial square;
  BallPolynomial product;
  for (std::size_t k = 0; k < 3; ++k) {
    const BallPolynomial rate = differentiate(r[k], share_bits);
    square = add(square, multiply_series(along[k], along[k], terms, share_bits), share_bits);
    product = add(product, multiply_series(rate, along[k], terms, share_bits), share_bits);
  }
  return multiply_series(product, inverse_sqrt_series(square, terms, share_bits), terms,
                         share_bits);
}

double value(const std::vector<double>& coefficients, double x) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

}  // namespace

// With cₖ the Taylor coefficients of |r′| in the middle m, k < n, and C a bound of the n-th one at
// all points of a piece, | |r′| − Σ cₖ(t − m)ᵏ | ≤ C|t − m|ⁿ there [Taylor, Lagrange's remainder],
// of which the integral is at most C·hⁿ⁺¹/(n + 1) from m to both ends, h = half the length.
void LengthShare::add(const CurveSeries& path, std::size_t segment, double from, double to) {
  const double half = (to - from) / 2;
  const double middle = from + half;
  const RealBall all = hull(exact_rational(from), exact_rational(to), share_bits);
  const RealBall last = speed_series(path, segment, all, terms + 1).coefficient(terms);
  const double bound =
      last.is_finite() ? upper_double(absolute(last)) * std::pow(half, terms + 1) : HUGE_VAL;
  const BallPolynomial around =
      speed_series(path, segment, RealBall(exact_rational(middle), share_bits), terms);
  const double speed = approximate(around.coefficient(0));
  if (!(bound <= 0x1p-44 * speed * half)) {
    if (half < 0x1p-22)
      throw Undecided(fmt::format("sweep: near t = {} the curve turns back in a cusp",
                                  static_cast<double>(segment) + from));
    add(path, segment, from, middle);
    add(path, segment, middle, to);
    return;
  }
  Piece piece{from, middle, 0, {0}};
  for (long k = 0; k < terms; ++k)
    piece.coefficients.push_back(approximate(around.coefficient(k)) / static_cast<double>(k + 1));
  piece.before = length_ - value(piece.coefficients, -half);
  length_ = piece.before + value(piece.coefficients, half);
  error_ += 2 * bound;
  segments_[segment].push_back(std::move(piece));
}

LengthShare::LengthShare(const CurveSeries& path) : segments_(path.segments) {
  for (std::size_t k = 0; k < path.segments; ++k) add(path, k, 0, 1);
  // Beside the remainders, sums in doubles, one for each piece.
  std::size_t pieces = 0;
  for (const auto& of_segment : segments_) pieces += of_segment.size();
  error_ = 2 * (error_ / length_ + static_cast<double>(pieces + 20) * 0x1p-52);
}

double LengthShare::operator()(std::size_t segment, double t) const {
  const auto& pieces = segments_[segment];
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), t,
                                      [](double x, const Piece& piece) { return x < piece.from; });
  const Piece& piece = *std::prev(after);
  return (piece.before + value(piece.coefficients, t - piece.middle)) / length_;
}

}  // namespace phrame
