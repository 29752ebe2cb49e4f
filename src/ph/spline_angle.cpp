#include "phrame/ph/spline_angle.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/transform.hpp"

// Every segment is a curve on [0, 1], and so is a part of one, reparametrised. Hence θ(t) is one
// integral from 0 to 1, of the sum of all rates, and that logarithms of different segments cancel
// is decided as within one.

namespace phrame {
namespace {

/// F(t) − F(0) without the logarithms.
Rational without_logarithms(const Antiderivative& F, const Rational& t) {
  return F.polynomial(t) - F.polynomial(0) + F.rational(t) - F.rational(0);
}

/// From 1 at t = 0 to z or −z at t = 1, by less than a half turn and not through 0. The argument of
/// its square turns by 2·arg z, up to a multiple of 2π.
GaussianPolynomial path_to(const GaussianRational& z) {
  if (z.im == 0) return {{1}, {}};
  const bool opposite = z.re < 0 || (z.re == 0 && z.im < 0);
  const Rational re = opposite ? Rational(-z.re) : z.re;
  const Rational im = opposite ? Rational(-z.im) : z.im;
  return {Polynomial{1, re - 1}, Polynomial{0, im}};
}

/// The angle that path_to(z)² turns by.
RealBall doubled_argument(const GaussianRational& z, long bits) {
  const GaussianPolynomial path = path_to(z);
  return multiply(RealBall(2, bits), argument(path.re(1), path.im(1), bits), bits);
}

/// The whole k with x ∈ (2k − 1, 2k + 1]. Throws Undecided where the ball around x is too wide.
Integer whole_turns(const RealBall& x, long bits) {
  const RealBall shifted = divide(add(x, RealBall(-1, bits), bits), RealBall(2, bits), bits);
  RealBall ceiling;
  arb_ceil(ceiling.raw(), shifted.raw(), bits);
  flint::Fmpz k;
  if (arb_get_unique_fmpz(k.get(), ceiling.raw()) == 0)
    throw Undecided(fmt::format(
        "holonomy: {} bits of precision do not tell the angle from a multiple of pi", bits));
  return Integer(numerator(to_rational(k.get())));
}

}  // namespace

SplineAngle::SplineAngle(Spline spline, Form form) : spline_(std::move(spline)) {
  for (const Curve& curve : spline_.segments()) angles_.emplace_back(curve, Reference::erf, form);
}

/// θ at the start of the segment.
RealBall SplineAngle::sum_before(std::size_t segment, long bits) {
  std::vector<RealBall>& sums = sums_[bits];
  if (sums.empty()) sums.emplace_back();
  while (sums.size() <= segment)
    sums.push_back(add(sums.back(), angles_[sums.size() - 1].enclose(1, bits), bits));
  return sums[segment];
}

RealBall SplineAngle::enclose(const SplineParameter& at, long bits) {
  for (long more = bits + 32;; more += 64) {
    const RealBall sum =
        add(sum_before(at.segment, more), angles_[at.segment].enclose(at.t, more), more);
    if (sum.is_accurate(bits)) return sum;
  }
}

/// θ without the logarithms.
Rational SplineAngle::rational_part(const SplineParameter& at) const {
  Rational sum = without_logarithms(angles_[at.segment].twist(), at.t);
  for (std::size_t k = 0; k < at.segment; ++k) sum += without_logarithms(angles_[k].twist(), 1);
  return sum;
}

/// F with F(1) − F(0) = θ; what has no logarithm is in the polynomial.
Antiderivative SplineAngle::over_unit_interval(const SplineParameter& at) const {
  Antiderivative sum{Polynomial{0, rational_part(at)}, {}, {}};
  const auto add = [&](const Antiderivative& F) {
    sum.logs.insert(sum.logs.end(), F.logs.begin(), F.logs.end());
  };
  for (std::size_t k = 0; k < at.segment; ++k) add(angles_[k].twist());
  if (at.t == 1)
    add(angles_[at.segment].twist());
  else if (at.t != 0)
    add(integrate(erf_rate(phrame::segment(spline_.segments()[at.segment], 0, at.t).preimage())));
  return sum;
}

Real SplineAngle::value(const Rational& t) { return value(locate(spline_, t)); }

Real SplineAngle::value(const SplineParameter& at) {
  if (at.segment == 0) return angles_[0].value(at.t);
  const auto theta = [this, at](long bits) { return enclose(at, bits); };
  if (!theta(128).contains(rational_part(at))) return Real(theta);
  return Evaluator(over_unit_interval(at)).value(0, 1, {{1}, {}}, theta);
}

std::optional<Real> SplineAngle::holonomy() {
  const auto closing = spline_.closing_turn();
  if (!closing) return std::nullopt;
  const GaussianRational back{closing->re, -closing->im};
  const SplineParameter end{angles_.size() - 1, 1};
  const int side = sign_after_zero(spline_.segments().front().multiplier());  // e₁ = side·tangent
  const auto turned = [this, end, back, side](long bits) {
    const RealBall sum = add(enclose(end, bits + 8), doubled_argument(back, bits + 8), bits + 8);
    return side < 0 ? subtract({}, sum, bits + 8) : sum;
  };
  constexpr long bits = 512;
  const RealBall over_pi = divide(turned(bits), pi(bits), bits);
  flint::Fmpz nearest;
  if (arb_get_unique_fmpz(nearest.get(), over_pi.raw()) != 0 && rational_part(end) == 0) {
    const auto multiple =
        Evaluator(over_unit_interval(end)).multiple_of_pi(0, 1, path_to(back) * path_to(back));
    if (multiple && denominator(*multiple) == 1) {
      if (numerator(*multiple) % 2 == 0) return Rational(0);
      return Real([](long precision) { return pi(precision); });
    }
  }
  const Rational half_turns(2 * whole_turns(over_pi, bits));
  return Real([turned, half_turns](long precision) {
    const long more = precision + 8;
    return subtract(turned(more), multiply(RealBall(half_turns, more), pi(more), more), more);
  });
}

}  // namespace phrame
