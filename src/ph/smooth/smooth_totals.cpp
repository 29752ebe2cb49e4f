#include "phrame/ph/smooth/smooth_totals.hpp"

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/integrate/absolute_integral.hpp"
#include "phrame/ph/smooth/rational_rates.hpp"
#include "phrame/ph/smooth/up_vector.hpp"

// τ = W²·det(H, H′, H″)/(p·ρ) does not depend on the sign of H, and so τ ds =
// sign p·√σ·det(H, H′, H″)/ρ dt, which is −sign p times how the rotation-minimizing frame turns
// against the Frenet frame.

namespace phrame {
namespace {

/// Of ∫ over all segments.
template <class OfSegment>
Real sum_of_segments(const SmoothPath& path, const OfSegment& of_segment) {
  Real sum = Rational(0);
  for (const SmoothSegment& segment : path.segments())
    sum = sum + of_segment(std::get<RationalCurve>(segment));
  return remembered(sum);
}

/// The numerator and the denominator without what they have in common.
RootQuotient without_common_factor(const RootQuotient& f) {
  const Polynomial common = gcd(f.numerator, f.denominator);
  return {exact_quotient(f.numerator, common), exact_quotient(f.denominator, common), f.radicand};
}

/// ∫ −(rate)·sign p, with the sign changes of p in (0, 1).
Real torsion_total(const RationalCurve& curve) {
  const TaylorIntegral turning(frenet_turning(curve));
  Real sum = Rational(0);
  int sign = sign_after_zero(curve.multiplier());
  Real before = Rational(0);
  const auto add_up_to = [&](const Real& at) {
    sum = sum + Rational(-sign) * (at + -before);
    before = at;
    sign = -sign;
  };
  const auto at = [&](const RealAlgebraic& t) -> Real {
    if (t.is_rational()) return turning.value(*t.rational());
    return Real(
        [turning, t](long bits) { return turning.enclose(enclose(t, bits + 16), bits + 8); });
  };
  for (const RealRoot& root : real_roots(curve.multiplier(), open(0, 1)))
    if (root.order % 2 == 1) add_up_to(at(root.at));
  add_up_to(turning.value(1));
  return sum;
}

/// ∫ of what is not negative, infinite where it has a pole.
std::variant<Real, Infinite> energy_of(const SmoothPath& path,
                                       RootQuotient (*rate_of)(const RationalCurve&)) {
  Real sum = Rational(0);
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const RootQuotient rate =
        without_common_factor(rate_of(std::get<RationalCurve>(path.segments()[k])));
    const auto poles = rate.denominator.is_constant() ? std::vector<RealRoot>{}
                                                      : real_roots(rate.denominator, closed(0, 1));
    if (!poles.empty() && !rate.numerator.is_zero())
      return Infinite{affine(poles.front().at, 1, Rational(static_cast<long>(k))), k};
    sum = sum + AbsoluteIntegral(rate).value(Rational(1));
  }
  return remembered(sum);
}

}  // namespace

Real total_curvature(const SmoothPath& path) {
  return sum_of_segments(path, [](const RationalCurve& curve) {
    return AbsoluteIntegral(curvature_rate(curve)).value(Rational(1));
  });
}

Real total_torsion(const SmoothPath& path) { return sum_of_segments(path, torsion_total); }

std::variant<Real, Infinite> bending_energy(const SmoothPath& path) {
  return energy_of(path, bending_rate);
}

std::variant<Real, Infinite> frenet_energy(const SmoothPath& path) {
  return energy_of(path, frenet_energy_rate);
}

Real up_frame_twist(const SmoothPath& path, const Vector<Rational>& up) {
  require_up_vector(path, up);
  return sum_of_segments(path, [&up](const RationalCurve& curve) {
    return -TaylorIntegral(up_frame_turning(curve, up)).value(1);
  });
}

}  // namespace phrame
