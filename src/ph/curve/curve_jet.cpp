#include "phrame/ph/curve/curve_jet.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/complex_series.hpp"
#include "phrame/ph/curve/formula_program.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long disc_bits = 64;

/// A number that |z| does not exceed, exactly.
RealBall size_above(const ComplexBall& z) {
  const RealBall size = absolute(z, disc_bits);
  return subtract({}, lower_end(subtract({}, size, disc_bits), disc_bits), disc_bits);
}

/// |r′·r′| is at least the least number of it on |z| ≤ 8, where that is > 0: on the inner disc of
/// the jet of twice the size, where r′ by z is half as long.
RealBall least_square(const ExpressionCurve& curve, const Rational& middle, const Rational& half,
                      long length) {
  static_assert(outer_radius == 2 * inner_radius);
  const auto wide = curve_jet(curve, middle, 2 * half, length, disc_bits);
  return wide ? times_power_of_two(lower_end(wide->square().size().lower, disc_bits), -2)
              : RealBall();
}

}  // namespace

std::optional<DiscBounds> bounds_on_disc(const ExpressionCurve& curve, const Rational& middle,
                                         const Rational& half) {
  const Rational radius = half * Rational(outer_radius);
  const RealBall around = widened(RealBall(), RealBall(radius, disc_bits));
  const ComplexBall disc(add(RealBall(middle, disc_bits), around, disc_bits), around);
  const Vector<ComplexSeries> r = curve.series(disc, half, 4, disc_bits);
  DiscBounds bounds;
  for (long order = 1; order <= 3; ++order)
    for (std::size_t k = 0; k < 3; ++k) {
      const RealBall size = size_above(r[k].coefficient(order));
      if (!size.is_finite()) return std::nullopt;
      const long factorial = order == 3 ? 6 : order;
      bounds[static_cast<std::size_t>(order - 1)][k] =
          multiply(RealBall(factorial, disc_bits), size, disc_bits);
    }
  return bounds;
}

CurveJet::CurveJet(const ExpressionCurve& curve, const RealBall& middle, const Rational& half,
                   long length, long bits)
    : r_(curve.series(middle, half, length + 3, bits)),
      middle_(middle),
      half_(half),
      length_(length),
      bits_(bits) {}

CurveJet::CurveJet(const ExpressionCurve& curve, const Rational& middle, const Rational& half,
                   const DiscBounds& bounds, long length, long bits)
    : CurveJet(curve, RealBall(middle, bits), half, length, bits) {
  bounds_ = bounds;  // NOLINT(*-prefer-member-initializer): the constructor is delegated
  least_square_ = [&curve, middle, half, length] {
    return least_square(curve, middle, half, length);
  };
}

const Vector<DiscFunction>& CurveJet::derivative(std::size_t order) const {
  return derivatives_[order - 1].get([this, order] {
    Vector<DiscFunction> of;
    for (std::size_t k = 0; k < 3; ++k) {
      BallPolynomial p = r_[k];
      for (std::size_t n = 0; n < order; ++n) p = differentiate(p, bits_);
      of[k] = {truncated(std::move(p), length_), bounds_[order - 1][k], length_, bits_};
    }
    return of;
  });
}

const Vector<DiscFunction>& CurveJet::first() const { return derivative(1); }
const Vector<DiscFunction>& CurveJet::second() const { return derivative(2); }
const Vector<DiscFunction>& CurveJet::third() const { return derivative(3); }

const DiscFactor& CurveJet::square() const {
  return square_.get([this] { return DiscFactor(dot(first(), first())); });
}

const Vector<DiscFunction>& CurveJet::bend() const {
  return bend_.get([this] { return cross(first(), second()); });
}

const DiscFactor& CurveJet::bend_square() const {
  return bend_square_.get([this] { return DiscFactor(dot(bend(), bend())); });
}

const DiscFunction& CurveJet::volume() const {
  return volume_.get([this] { return dot(bend(), third()); });
}

// On the disc, where r′·r′ has no zero, a branch of its root is analytic.
DiscFunction CurveJet::inverse_speed() const {
  const RealBall bound =
      least_square_ ? divide(RealBall(1, disc_bits), sqrt(least_square_(), disc_bits), disc_bits)
                    : RealBall();
  return {inverse_sqrt_series(square().base().series, length_, bits_), bound, length_, bits_};
}

DiscFunction CurveJet::parameter() const {
  std::vector<RealBall> t{middle_};
  if (length_ > 1) t.emplace_back(half_, bits_);
  const RealBall reach(abs(half_) * Rational(outer_radius), disc_bits);
  return {BallPolynomial(t), add(absolute(middle_), reach, disc_bits), length_, bits_};
}

std::optional<CurveJet> curve_jet(const ExpressionCurve& curve, const Rational& middle,
                                  const Rational& half, long length, long bits) {
  const auto bounds = bounds_on_disc(curve, middle, half);
  if (!bounds) return std::nullopt;
  return CurveJet(curve, middle, half, *bounds, length, bits);
}

}  // namespace phrame
