#include "phrame/ph/frame/formula_piece.hpp"

#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/angle_piece.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"
#include "phrame/ph/frame/rotation_series.hpp"

namespace phrame::inline v0 {
namespace {

// A polynomial of degree 16 is near enough where the nearest singularity is at |y| > 24 or so. So z
// = y/2, and what is bounded on |z| ≤ 4 has a Taylor series in y with coefficients like 8^(−k).
constexpr long wide_bits = 1;     ///< y = 2^wide_bits·z
constexpr long piece_terms = 40;  ///< what is left out is about 8^(−terms)
constexpr long piece_bits = 128;  ///< of the series, which Arb multiplies sooner than longer ones

/// The curve around the middle of a piece, by z.
std::optional<CurveJet> jet_of(const ExpressionCurve& curve, const PolynomialPiece& piece) {
  const Rational middle = exact_rational(piece.center) - exact_rational(piece.origin);
  const Rational half = power_of_two(wide_bits) / exact_rational(piece.scale);
  return curve_jet(curve, middle, half, piece_terms, piece_bits);
}

/// A series in z as one in y.
BallPolynomial by_y(const BallPolynomial& p) { return stretched(p, -wide_bits); }

/// bound·8^(−terms)·Σ 8⁻ᵏ, not rounded down.
RealBall tail(const RealBall& bound) {
  return times_power_of_two(multiply(bound, RealBall(2, 64), 64), -(2 + wide_bits) * piece_terms);
}

/// At least |f| on |z| ≤ 4, as the greatest number of the ball.
RealBall most_of(const DiscFunction& f) { return size_bounds(f).upper; }

/// The integral of a rate by z, which has this series and this bound on |z| ≤ 4.
std::optional<PolynomialPiece> rounded_integral_piece(
    const PolynomialPiece& piece, const BallPolynomial& rate, const RealBall& bound,
    const std::function<RealBall(double center, long bits)>& at_center, const DoubleShape& shape) {
  const BallPolynomial from_center = by_y(antiderivative(rate, piece_bits));
  const auto remainder_of = [&](const BallPolynomial& p) {
    return add(variation(subtract(p, from_center, piece_bits), piece_bits), tail(bound),
               angle_bits);
  };
  return rounded_angle_piece(piece, from_center, remainder_of, at_center, shape);
}

}  // namespace

std::optional<PolynomialPiece> formula_angle_piece(
    double low, double high, double origin, const ExpressionCurve& curve, const CurveIntegrand& y,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape) {
  const auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const auto jet = jet_of(curve, *piece);
  if (!jet) return std::nullopt;
  const DiscProduct rate = y(*jet);
  const auto bound = bound_on_inner_disc(rate);
  if (!bound) return std::nullopt;
  return rounded_integral_piece(*piece, series(rate), *bound, theta, shape);
}

std::optional<PolynomialPiece> formula_point_piece(
    double low, double high, double origin, const ExpressionCurve& curve, std::size_t k,
    const std::function<RealBall(double center, long bits)>& at_center, const DoubleShape& shape) {
  const auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const auto jet = jet_of(curve, *piece);
  if (!jet) return std::nullopt;
  const DiscFunction& rate = jet->first()[k];
  return rounded_integral_piece(*piece, rate.series, rate.bound, at_center, shape);
}

std::optional<PolynomialPiece> formula_rotation_piece(
    double low, double high, double origin, const ExpressionCurve& curve,
    const std::function<std::array<RealBall, 4>(double center, long bits)>& at_center,
    const DoubleShape& shape) {
  const auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const auto jet = jet_of(curve, *piece);
  if (!jet) return std::nullopt;
  const DiscFunction& sigma = jet->square().base();
  const DiscFunction twice_sigma = constant_like(sigma, 2) * sigma;
  const RealBall least_sigma = size_bounds(twice_sigma).lower;
  if (sign(least_sigma) <= 0) return std::nullopt;
  const Vector<DiscFunction>& turn = jet->bend();
  RealBall most_turn;
  for (const DiscFunction& f : turn) most_turn = add(most_turn, most_of(f), 64);
  // |B| = 1 at the center, and e < 3.
  const double exponent = upper_double(divide(most_turn, least_sigma, 64)) * 4;
  if (!(exponent < 64)) return std::nullopt;
  const RealBall growth = pow(RealBall(3, 64), static_cast<long>(std::ceil(exponent)), 64);

  QuaternionSeries series = rotation_series(at_center(piece->center, piece_bits),
                                            {turn[0].series, turn[1].series, turn[2].series},
                                            twice_sigma.series, piece_terms, piece_bits);
  for (BallPolynomial& component : series) component = by_y(component);
  const auto remainder_of = [&](const QuaternionSeries& exact) {
    RealBall sum = tail(growth);
    for (std::size_t k = 0; k < 4; ++k)
      sum = add(sum, variation(subtract(exact[k], series[k], piece_bits), piece_bits), frame_bits);
    return sum;
  };
  return rounded_rotation_piece(*piece, series, remainder_of, shape);
}

}  // namespace phrame
