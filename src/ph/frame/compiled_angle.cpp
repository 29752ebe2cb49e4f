#include "phrame/ph/frame/compiled_angle.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

constexpr long angle_bits = 128;  // of what is known of a piece

/// θ to about 2^−84 of its absolute value or of `scale`, the greater one.
RealBall accurate(const Real::Enclosure& theta, const RealBall& scale) {
  constexpr long most = 1L << 17;
  for (long more = angle_bits; more <= most; more *= 2) {
    const RealBall value = theta(more);
    const RealBall allowed = times_power_of_two(add(absolute(value), scale, angle_bits), -84);
    if (value.radius() == 0 || value.radius() <= allowed.lower()) return value;
  }
  throw Undecided(fmt::format("compiled angle: {} bits do not tell a constant angle from 0", most));
}

/// θ on [low, high], θ′(t) = rate(t − origin) there, from balls around θ(center).
std::optional<PolynomialPiece> angle_piece(
    double low, double high, double origin, const RationalFunction& rate,
    const std::function<RealBall(double center, long bits)>& theta, const DoubleShape& shape) {
  auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const BallPolynomial denominator = on_piece(rate.denominator(), *piece, angle_bits, true);
  const RealBall least_denominator = least(denominator, angle_bits);
  if (sign(least_denominator) <= 0) return std::nullopt;
  const BallPolynomial numerator = per_y(rate.numerator(), *piece, angle_bits);

  const BallPolynomial rate_series =
      divide_series(numerator, denominator, shape.degree, angle_bits);
  const BallPolynomial from_center = antiderivative(rate_series, angle_bits);
  const RealBall size = variation(from_center, angle_bits);
  const RealBall at_center = accurate([&](long more) { return theta(piece->center, more); }, size);
  piece->coefficients = round_coefficients({with_constant(from_center, at_center)}, shape);

  const BallPolynomial p = exact_polynomial(piece->coefficients, shape, 0);
  const BallPolynomial residual = subtract(
      multiply(differentiate(p, angle_bits), denominator, angle_bits), numerator, angle_bits);
  const RealBall remainder =
      divide(integral_bound(residual, angle_bits), least_denominator, angle_bits);
  // Where θ is large its rounding hides what is small beside the second part.
  const double scale = upper_double(size) + upper_double(absolute(at_center)) / 64;
  if (!(upper_double(remainder) <= shape.goal * scale)) return std::nullopt;
  const double off = sum_up(upper_double(remainder), rounding_error(piece->coefficients, shape, 0));
  const double at_zero = upper_double(absolute(subtract(p.coefficient(0), at_center, angle_bits)));
  if (at_center.is_zero())
    piece->error_per_y = off;
  else
    piece->error = sum_up(off, at_zero);
  if (!size.is_zero())
    piece->error = sum_up(piece->error, underflow_error * (1 + upper_double(size)));
  return piece;
}

}  // namespace

PiecewisePolynomial compiled_angle(const RmfAngle& angle, const FrameAngle& start_angle,
                                   double from, double to, const DoubleShape& shape) {
  const Real start = to_real(start_angle);
  const auto theta = [&](double t, long more) {
    return add(angle.enclose(exact_rational(t), more), start.enclose(more), more);
  };
  return {from, to, shape, [&](double low, double high) {
            return angle_piece(low, high, 0, angle.rate(), theta, shape);
          }};
}

// A straight segment may have the angle 0 because others and the start cancel: value() sees that.
PiecewisePolynomial compiled_angle(const PathAngle& angle, const FrameAngle& start_angle,
                                   const DoubleShape& shape) {
  // That the segments before cancel is asked for only where a ball does not say enough: it costs as
  // much as all of them.
  const auto theta = [&](double t, long more) {
    const PathParameter at = locate(angle.path(), exact_rational(t));
    if (more > angle_bits) return angle.value(at, start_angle).enclose(more);
    return angle.enclose(at, start_angle, more);
  };
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const RmfAngle& segment = angle.segment(static_cast<std::size_t>(joint));
    return angle_piece(low, high, joint, segment.rate(), theta, shape);
  };
  return PiecewisePolynomial::on_units(angle.path().segments().size(), shape, make);
}

CompiledAngle::CompiledAngle(const RmfAngle& angle, double from, double to,
                             const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(compiled_angle(angle, start_angle, from, to, compensated_shape(1))) {}

CompiledAngle::CompiledAngle(const PathAngle& angle, const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(compiled_angle(angle, start_angle, compensated_shape(1))) {}

double CompiledAngle::operator()(double t) {
  polynomials_.require_inside(t, "compiled angle");
  const PolynomialPiece& piece = polynomials_.at(t);
  const double y = piece.y(t);
  const auto [value] = evaluate_compensated<1>(piece.coefficients.data(), polynomials_.shape(), y);
  const auto rounded = common_double(value, piece.error + piece.error_per_y * std::abs(y));
  return rounded ? *rounded : exact(t);
}

double CompiledAngle::exact(double t) {
  ++exact_values_;
  return round_to_double(angle_(exact_rational(t)));
}

}  // namespace phrame
