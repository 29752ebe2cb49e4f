#include "phrame/ph/frame/angle_polynomials.hpp"

#include <cmath>

#include "phrame/integrate/lowest_root_quotient.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/frame/integral_piece.hpp"

namespace phrame::inline v0 {
namespace {

/// As angle_piece() has it.
RootQuotient rate_of(const RationalFunction& rate) {
  return {rate.numerator(), rate.denominator(), Polynomial{1}};
}

/// θ + start at a double. A straight segment may have the angle 0 because others and the start
/// cancel: value() sees that. It costs as much as all segments before, so that it is asked only
/// where a ball does not say enough.
auto theta_of(const PathAngle& angle, const StartAngle& start) {
  return [angle, start](double t, long more) {
    const PathParameter at = locate(angle.path(), exact_rational(t));
    if (more > angle_bits) return angle.value(at, start).enclose(more);
    return angle.enclose(at, start, more);
  };
}

/// θ′ of a segment.
PieceRate rate_of(const PathAngle& angle, std::size_t k) {
  if (angle.is_zero()) return RootQuotient{};
  if (const RmfAngle* closed = angle.closed_form(k)) return rate_of(closed->rate());
  const bool is_up = angle.reference() == Reference::up;
  const Segment& segment = angle.path().segments()[k];
  if (const RationalCurve* curve = rational_curve(segment))
    return in_lowest_terms(is_up ? up_frame_turning(*curve, angle.up()) : frenet_turning(*curve));
  const CurveIntegrand rate = is_up ? up_frame_rate(angle.up()) : torsion_rate();
  return orientation(segment) > 0 ? negative(rate) : rate;
}

/// The piece on [low, high] of segment k, whose rate that is.
std::optional<PolynomialPiece> piece_of(const PathAngle& angle, std::size_t k,
                                        const PieceRate& rate, double low, double high,
                                        const StartAngle& start, const DoubleShape& shape) {
  return integral_piece(k, angle.path().segments()[k], rate, low, high, theta_of(angle, start),
                        shape);
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

PiecewisePolynomial compiled_angle(const PathAngle& angle, const StartAngle& start_angle,
                                   const DoubleShape& shape) {
  std::vector<PieceRate> rates;
  for (std::size_t k = 0; k < angle.path().segments().size(); ++k)
    rates.push_back(rate_of(angle, k));
  const auto make = [&](double low, double high) {
    const auto k = static_cast<std::size_t>(std::floor(low));
    return piece_of(angle, k, rates[k], low, high, start_angle, shape);
  };
  return PiecewisePolynomial::on_units(rates.size(), shape, make);
}

PiecewisePolynomial compiled_angle(const PathAngle& angle, std::size_t segment,
                                   const StartAngle& start_angle, const DoubleShape& shape) {
  const PieceRate rate = rate_of(angle, segment);
  const auto joint = static_cast<double>(segment);
  return {joint, joint + 1, shape, [&](double low, double high) {
            return piece_of(angle, segment, rate, low, high, start_angle, shape);
          }};
}

}  // namespace phrame
