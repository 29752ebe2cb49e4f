#include "phrame/ph/frame/compiled_angle.hpp"

#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/angle_piece.hpp"

namespace phrame {
namespace {

/// As angle_piece() has it.
RootQuotient rate_of(const RationalFunction& rate) {
  return {rate.numerator(), rate.denominator(), Polynomial{1}};
}

}  // namespace

PiecewisePolynomial compiled_angle(const RmfAngle& angle, const FrameAngle& start_angle,
                                   double from, double to, const DoubleShape& shape) {
  const Real start = to_real(start_angle);
  const auto theta = [&](double t, long more) {
    return add(angle.enclose(exact_rational(t), more), start.enclose(more), more);
  };
  const RootQuotient rate = rate_of(angle.rate());
  return {from, to, shape,
          [&](double low, double high) { return angle_piece(low, high, 0, rate, theta, shape); }};
}

namespace {

/// θ + start at a double. A straight segment may have the angle 0 because others and the start
/// cancel: value() sees that. It costs as much as all segments before, so that it is asked only
/// where a ball does not say enough.
auto theta_of(const PathAngle& angle, const FrameAngle& start) {
  return [angle, start](double t, long more) {
    const PathParameter at = locate(angle.path(), exact_rational(t));
    if (more > angle_bits) return angle.value(at, start).enclose(more);
    return angle.enclose(at, start, more);
  };
}

}  // namespace

PiecewisePolynomial compiled_angle(const PathAngle& angle, const FrameAngle& start_angle,
                                   const DoubleShape& shape) {
  const auto theta = theta_of(angle, start_angle);
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const RmfAngle& segment = angle.segment(static_cast<std::size_t>(joint));
    return angle_piece(low, high, joint, rate_of(segment.rate()), theta, shape);
  };
  return PiecewisePolynomial::on_units(angle.path().segments().size(), shape, make);
}

PiecewisePolynomial compiled_angle(const PathAngle& angle, std::size_t segment,
                                   const FrameAngle& start_angle, const DoubleShape& shape) {
  const auto theta = theta_of(angle, start_angle);
  const RootQuotient rate = rate_of(angle.segment(segment).rate());
  const auto joint = static_cast<double>(segment);
  return {joint, joint + 1, shape, [&](double low, double high) {
            return angle_piece(low, high, joint, rate, theta, shape);
          }};
}

CompiledAngle::CompiledAngle(const RmfAngle& angle, double from, double to,
                             const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(compiled_angle(angle, start_angle, from, to, compensated_shape(1))) {}

CompiledAngle::CompiledAngle(std::function<Real(const Rational&)> angle,
                             PiecewisePolynomial polynomials)
    : angle_(std::move(angle)), polynomials_(std::move(polynomials)) {}

CompiledAngle::CompiledAngle(const PathAngle& angle, const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(compiled_angle(angle, start_angle, compensated_shape(1))) {}

CompiledAngle::CompiledAngle(const PathAngle& angle, std::size_t segment,
                             const FrameAngle& start_angle)
    : angle_([angle, start_angle](const Rational& t) { return angle.value(t, start_angle); }),
      polynomials_(compiled_angle(angle, segment, start_angle, compensated_shape(1))) {}

std::optional<double> CompiledAngle::rounded(double t) const {
  polynomials_.require_inside(t, "compiled angle");
  return rounding_to_nearest([&] {
    const PolynomialPiece& piece = polynomials_.at(t);
    const double y = piece.y(t);
    const auto [value] =
        evaluate_compensated<1>(piece.coefficients.data(), polynomials_.shape(), y);
    return common_double(value, piece.error + piece.error_per_y * std::abs(y));
  });
}

double CompiledAngle::operator()(double t) {
  if (const auto found = rounded(t)) return *found;
  ++exact_values_;
  return round_to_double(angle_(exact_rational(t)));
}

}  // namespace phrame
