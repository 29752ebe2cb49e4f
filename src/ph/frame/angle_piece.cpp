#include "phrame/ph/frame/angle_piece.hpp"

#include <fmt/format.h>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/piece_guess.hpp"

namespace phrame::inline v0 {
namespace {

/// θ to about 2^−84 of its absolute value or of `scale`, the greater one. To 2^−400 is enough in
/// any case: so the error of a piece may be, where θ is constant, or nearly so, and not told from
/// 0.
RealBall accurate(const Real::Enclosure& theta, const RealBall& scale) {
  constexpr long most = 1L << 14;
  const RealBall least = times_power_of_two(RealBall(1, 2), -400);
  for (long more = angle_bits; more <= most; more *= 2) {
    const RealBall value = theta(more);
    const RealBall allowed = times_power_of_two(add(absolute(value), scale, angle_bits), -84);
    if (value.radius() <= max(allowed, least, angle_bits).lower()) return value;
  }
  throw Undecided(fmt::format("compiled angle: the angle is not found with {} bits", most));
}

/// w near 1/√S on a piece, and a bound of |w − 1/√S| there.
struct InverseRoot {
  BallPolynomial w;
  RealBall error;
};

/// From S on the piece, and a lower bound of it, > 0.
InverseRoot inverse_root(const BallPolynomial& s, const RealBall& least_s, long length) {
  const RealBall least_root = sqrt(least_s, angle_bits);
  const BallPolynomial w = inverse_sqrt_series(s, length, angle_bits);
  const RealBall one(1, angle_bits);
  const RealBall at_center = subtract(
      multiply(w.coefficient(0), sqrt(s.coefficient(0), angle_bits), angle_bits), one, angle_bits);
  const BallPolynomial half_slope =
      multiply(RealBall(Rational(1, 2), angle_bits),
               multiply(differentiate(s, angle_bits), w, angle_bits), angle_bits);
  const BallPolynomial rest =
      add(multiply(s, differentiate(w, angle_bits), angle_bits), half_slope, angle_bits);
  const RealBall off =
      add(absolute(at_center), divide(integral_bound(rest, angle_bits), least_root, angle_bits),
          angle_bits);
  return {w, divide(off, least_root, angle_bits)};
}

}  // namespace

std::optional<PolynomialPiece> rounded_angle_piece(
    PolynomialPiece piece, const BallPolynomial& from_center,
    const std::function<RealBall(const BallPolynomial& p)>& remainder_of,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape) {
  const RealBall size = variation(from_center, angle_bits);
  const RealBall at_center = accurate([&](long more) { return theta(piece.center, more); }, size);
  piece.coefficients = round_coefficients({with_constant(from_center, at_center)}, shape);
  const BallPolynomial p = exact_polynomial(piece.coefficients, shape, 0);
  const RealBall remainder = remainder_of(p);
  // Where θ is large its rounding hides what is small beside the second part.
  const double scale = upper_double(size) + upper_double(absolute(at_center)) / 64;
  if (!(upper_double(remainder) <= shape.goal * scale)) return std::nullopt;
  const double off = sum_up(upper_double(remainder), rounding_error(piece.coefficients, shape, 0));
  const double at_zero = upper_double(absolute(subtract(p.coefficient(0), at_center, angle_bits)));
  if (at_center.is_zero())
    piece.error_per_y = off;
  else
    piece.error = sum_up(off, at_zero);
  if (!size.is_zero())
    piece.error = sum_up(piece.error, underflow_error * (1 + upper_double(size)));
  return piece;
}

std::optional<PolynomialPiece> angle_piece(
    double low, double high, double origin, const RootQuotient& rate,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape) {
  auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const BallPolynomial denominator = on_piece(rate.denominator, *piece, angle_bits, true);
  const RealBall least_denominator = least(denominator, angle_bits);
  if (sign(least_denominator) <= 0) return std::nullopt;
  const BallPolynomial radicand = on_piece(rate.radicand, *piece, angle_bits, true);
  const RealBall least_radicand = least(radicand, angle_bits);
  if (sign(least_radicand) <= 0) return std::nullopt;
  const BallPolynomial over = per_y(rate.numerator, *piece, angle_bits);
  if (seems_too_long(over, denominator, radicand, shape)) return std::nullopt;
  const InverseRoot root = rate.radicand == Polynomial{1}
                               ? InverseRoot{radicand, {}}
                               : inverse_root(radicand, least_radicand, shape.degree + 4);
  const BallPolynomial numerator = root.error.is_zero() ? over : multiply(over, root.w, angle_bits);

  const BallPolynomial rate_series =
      divide_series(numerator, denominator, shape.degree, angle_bits);
  const BallPolynomial from_center = antiderivative(rate_series, angle_bits);
  // The bound of |p′·D − N·w| and of w.
  const auto remainder_of = [&](const BallPolynomial& p) {
    const BallPolynomial residual = subtract(
        multiply(differentiate(p, angle_bits), denominator, angle_bits), numerator, angle_bits);
    // |N| ≤ |N(0)| + variation.
    const RealBall most_over =
        add(absolute(over.coefficient(0)), variation(over, angle_bits), angle_bits);
    const RealBall rest =
        add_product(integral_bound(residual, angle_bits), most_over, root.error, angle_bits);
    return divide(rest, least_denominator, angle_bits);
  };
  return rounded_angle_piece(*piece, from_center, remainder_of, theta, shape);
}

}  // namespace phrame
