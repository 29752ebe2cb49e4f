#include "phrame/ph/along/smooth_totals.hpp"

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/formula_domain.hpp"
#include "phrame/ph/curve/real_vector.hpp"

// τ = W²·det(H, H′, H″)/(p·ρ) does not depend on the sign of H, and so τ ds =
// sign p·√σ·det(H, H′, H″)/ρ dt, which is −sign p times how the rotation-minimizing frame turns
// against the Frenet frame.

namespace phrame {
namespace {

/// The term of segment k. Of a long path only a ball around it is kept, and where more digits are
/// asked for it is what of_segment() finds again.
template <class OfSegment>
Real kept_term(const Real& term, const Path& path, std::size_t k, const OfSegment& of_segment) {
  constexpr long first_bits = 112;
  const bool is_short = path.segments().size() <= most_kept_integrals ||
                        std::holds_alternative<ExpressionCurve>(path.segments()[k]);
  if (term.exact() || is_short) return term;
  return Real([path, k, of_segment, first = term.enclose(first_bits)](long bits) {
    return bits <= first_bits ? first : of_segment(path.segments()[k]).enclose(bits);
  });
}

/// Of ∫ over all segments.
template <class OfSegment>
Real sum_of_segments(const Path& path, const OfSegment& of_segment) {
  std::vector<Real> terms;
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    terms.push_back(kept_term(of_segment(path.segments()[k]), path, k, of_segment));
  return sum_of(terms);
}

/// The numerator and the denominator without what they have in common.
RootQuotient without_common_factor(const RootQuotient& f) {
  const Polynomial common = gcd(f.numerator, f.denominator);
  return {exact_quotient(f.numerator, common), exact_quotient(f.denominator, common), f.radicand};
}

/// −∫ of how the rotation-minimizing frame turns, times sign p, with the sign changes of p in
/// (0, 1).
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

Real torsion_total(const ExpressionCurve& curve) {
  return Rational(-curve.orientation()) * frenet_angle(curve).value(Rational(1));
}

Real whole_integral(const ExpressionCurve& curve, const CurveIntegrand& y) {
  return SegmentIntegral(ExpressionIntegral(curve, y)).value(Rational(1));
}

/// ∫ of what is not negative along a segment, or where it has a pole.
using SegmentEnergy = std::variant<Real, RealAlgebraic>;

SegmentEnergy energy_of(const RootQuotient& given) {
  const RootQuotient rate = without_common_factor(given);
  const auto poles = rate.denominator.is_constant() ? std::vector<RealRoot>{}
                                                    : real_roots(rate.denominator, closed(0, 1));
  if (!poles.empty() && !rate.numerator.is_zero()) return poles.front().at;
  return AbsoluteIntegral(rate).value(Rational(1));
}

SegmentEnergy bending_of(const RationalCurve& curve) {
  return energy_of(phrame::bending_rate(curve));
}

SegmentEnergy bending_of(const ExpressionCurve& curve) {
  if (are_on_a_line(direction_span(curve))) return Real(Rational(0));
  return whole_integral(curve, bending_rate());
}

SegmentEnergy frenet_energy_of(const RationalCurve& curve) {
  return energy_of(phrame::frenet_energy_rate(curve));
}

SegmentEnergy frenet_energy_of(const ExpressionCurve& curve) {
  const Real bending = std::get<Real>(bending_of(curve));
  if (common_normal(direction_span(curve))) return bending;  // τ = 0
  if (const auto fault = taylor_parts(curve, squared_torsion_rate())->fault)
    refuse_inflection(curve, *fault, "integral of the Frenet frame's rate");
  const Real twisting = whole_integral(curve, squared_torsion_rate());
  return Real([bending, twisting](long bits) {
    return add(bending.enclose(bits), twisting.enclose(bits), bits);
  });
}

template <class OfCurve>
std::variant<Real, Infinite> sum_of_energies(const Path& path, const OfCurve& of_curve) {
  std::vector<Real> terms;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const SegmentEnergy energy = visit_curve(of_curve, path.segments()[k]);
    if (const auto* pole = std::get_if<RealAlgebraic>(&energy))
      return Infinite{affine(*pole, 1, Rational(static_cast<long>(k))), k};
    terms.push_back(kept_term(std::get<Real>(energy), path, k, [of_curve](const auto& segment) {
      return std::get<Real>(visit_curve(of_curve, segment));
    }));
  }
  return sum_of(terms);
}

}  // namespace

Real total_curvature(const Path& path) {
  return sum_of_segments(
      path, [](const Segment& segment) { return bending_angle(segment).value(Rational(1)); });
}

Real total_torsion(const Path& path) {
  return sum_of_segments(path, [](const Segment& segment) {
    return visit_curve([](const auto& curve) { return torsion_total(curve); }, segment);
  });
}

std::variant<Real, Infinite> bending_energy(const Path& path) {
  return sum_of_energies(path, [](const auto& curve) { return bending_of(curve); });
}

std::variant<Real, Infinite> frenet_energy(const Path& path) {
  return sum_of_energies(path, [](const auto& curve) { return frenet_energy_of(curve); });
}

Real up_frame_twist(const PathAngle& angle) {
  return -angle.value({angle.path().segments().size() - 1, Rational(1)});
}

}  // namespace phrame
