#include "phrame/ph/along/path_totals.hpp"

#include <algorithm>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/integrate/integral_sum.hpp"
#include "phrame/ph/along/known_poles.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/total_rates.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/formula_domain.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"

// What a PH curve adds is a Total. Of other curves τ = W²·det(H, H′, H″)/(p·ρ) does not depend on
// the sign of H, and so τ ds = sign p·√σ·det(H, H′, H″)/ρ dt, which is −sign p times how the
// rotation-minimizing frame turns against the Frenet frame.

namespace phrame::inline v0 {
namespace {

// ---- The sum.

/// factor · (total/√radicand), the integral without the root.
KnownIntegral without_root(const CurveTotal& total, const Rational& factor) {
  const Real value = Real(factor) * (square_root_of(1 / total.radicand) * total.value);
  KnownIntegral integral{{cached(value), std::nullopt}};
  if (total.exact) integral.value.exact = factor * *total.exact;
  Rational from = 0;
  Rational sign = factor;
  const auto add = [&](const Rational& to) {
    integral.parts.push_back({total.rate, total.antiderivative, from, to, sign});
    from = to;
    sign = -sign;
  };
  for (const RealAlgebraic& turn : total.sign_changes) {
    if (!turn.is_rational()) {
      integral.parts.clear();
      return integral;
    }
    add(*turn.rational());
  }
  add(1);
  return integral;
}

/// Those with one root.
struct Group {
  Rational radicand;
  std::vector<KnownIntegral> integrals = {};
};

/// What is added up.
struct Terms {
  std::vector<Group> groups = {};   ///< of PH curves
  Surd roots = {};                  ///< of others, where it is such a sum
  std::vector<Real> approximate{};  ///< of others
};

/// The group for the root of that, and that root over the one of the group.
std::pair<Group&, Rational> group_of(std::vector<Group>& groups, const Rational& radicand) {
  for (Group& group : groups)
    if (const auto quotient = square_root(Rational(radicand / group.radicand)))
      return {group, *quotient};
  groups.push_back({radicand});
  return {groups.back(), 1};
}

Real to_real(const Surd& x) {
  Real sum = Rational(0);
  for (const auto& [d, c] : x.terms()) sum = sum + Real(c) * square_root_of(Rational(d));
  return x.is_rational() ? sum : known_irrational(sum);
}

void add_to(Terms& terms, const std::shared_ptr<const CurveTotal>& total) {
  if (total->value.exact() == Rational(0)) return;
  const auto [group, quotient] = group_of(terms.groups, total->radicand);
  group.integrals.push_back(without_root(*total, quotient));
}

void add_to(Terms& terms, const Surd& sum) {
  constexpr std::size_t most_kept_roots = 16;
  if (sum.is_rational() || terms.roots.count_roots() <= most_kept_roots)
    terms.roots = terms.roots + sum;
  else
    terms.approximate.push_back(to_real(sum));
}

void add_to(Terms& terms, const Real& x) {
  if (x.exact())
    terms.roots = terms.roots + Surd(*x.exact());
  else
    terms.approximate.push_back(x);
}

/// Is it an irrational sum of square roots?
bool is_of_roots(const std::vector<PathTotal::Term>& exact) {
  return std::any_of(exact.begin(), exact.end(),
                     [](const auto& term) { return term.radicand != 1; }) &&
         std::all_of(exact.begin(), exact.end(),
                     [](const auto& term) { return is_rational(term.of); });
}

/// The sum as + makes it, but that each term is asked for a few bits more than the sum, and not the
/// first one for eight more with each that follows.
Real sum_at_once(std::vector<Real> terms) {
  std::erase_if(terms, [](const Real& x) { return x.exact() == Rational(0); });
  Real sum = Rational(0);
  for (const Real& x : terms) sum = sum + x;
  if (terms.size() <= 2) return sum;
  const Real::Origin origin = sum.origin();
  return {[all = sum_of(std::move(terms))](long bits) { return all.enclose(bits); }, origin};
}

PathTotal sum_of(Terms terms, std::vector<PathTotal::OfSegment> segments) {
  for (const auto& [d, c] : terms.roots.terms()) {
    const auto [group, quotient] = group_of(terms.groups, Rational(d));
    const Rational known = quotient * c;
    group.integrals.push_back({{known, exact_value(known)}});
  }
  std::optional<std::vector<PathTotal::Term>> exact;
  if (terms.approximate.empty()) exact.emplace();
  PathTotal total{std::move(segments), Rational(0), std::move(exact)};
  std::vector<Real> values{sum_of(std::move(terms.approximate))};
  for (const Group& group : terms.groups) {
    const DefiniteIntegral sum = sum_of_integrals(group.integrals);
    values.push_back(square_root_of(group.radicand) * sum.value);
    if (sum.exact && total.exact)
      total.exact->push_back({group.radicand, *sum.exact});
    else
      total.exact.reset();
  }
  total.value = sum_at_once(std::move(values));
  if (total.exact && total.exact->empty()) total.exact = {{1, ExactValue{}}};
  if (total.exact && !total.value.exact() && is_of_roots(*total.exact))
    total.value = known_irrational(total.value);
  return total;
}

PathTotal sum_of(std::vector<PathTotal::OfSegment> segments) {
  if (const CurveTotal* only = closed_form(segments.front()); only && segments.size() == 1) {
    PathTotal total{{}, only->value, std::nullopt};
    if (only->exact) total.exact = {{only->radicand, *only->exact}};
    total.segments = std::move(segments);
    return total;
  }
  Terms terms;
  terms.approximate.reserve(segments.size());
  for (const auto& segment : segments)
    std::visit([&](const auto& of) { add_to(terms, of); }, segment);
  return sum_of(std::move(terms), std::move(segments));
}

/// What a segment adds; where that is infinite, the pole is a parameter of the segment.
using SegmentTotal = std::variant<PathTotal::OfSegment, Infinite>;
using OfSegment = SegmentTotal (*)(const Segment&);

/// The term, of which only a ball is kept; where more digits are asked for it is found again.
template <class Again>
Real kept_ball(const Real& term, const Again& again) {
  return Real([again, first = term.enclose(first_bits_of_sums)](long bits) {
    return bits <= first_bits_of_sums ? first : again().enclose(bits);
  });
}

/// Of a long path only balls are kept.
Real kept_term(const Real& term, const std::shared_ptr<const Path>& path, std::size_t k,
               OfSegment of) {
  const bool is_short = path->segments().size() <= most_kept_integrals ||
                        std::holds_alternative<ExpressionCurve>(path->segments()[k]);
  if (term.exact() || is_short) return term;
  return kept_ball(term, [path, k, of] {
    return std::get<Real>(std::get<PathTotal::OfSegment>(of(path->segments()[k])));
  });
}

/// What of the sum is no logarithm.
RealBall rational_part(const Path& path, TotalRate (*rate_of)(const Curve&)) {
  RealBall sum;
  for (const Segment& segment : path.segments())
    sum = add(sum, RealBall(without_logarithms(rate_of(*ph_curve(segment))), first_bits_of_sums),
              first_bits_of_sums);
  return sum;
}

/// What is integrated along PH curves.
struct Integrand {
  TotalRate (*rate)(const Curve&);
  std::optional<FactoredFunction> (*factors)(const Curve&, const TotalPoles&);
};

/// Along one PH curve, without a closed form.
struct OpenTotal {
  RealBall value;
  RealBall logarithm;  ///< of the value; unknown where it is not found by its poles
};

/// To so many bits; no value where value_without_closed_form() has none.
std::optional<OpenTotal> open_total(const Curve& curve, const TotalPoles& poles,
                                    const Integrand& of, long bits) {
  if (const auto factors = of.factors(curve, poles))
    if (const auto parts = pole_change(*factors, bits))
      return OpenTotal{parts->whole(bits + 32), parts->logarithm};
  const auto value = value_without_closed_form(of.rate(curve));
  if (!value) return std::nullopt;
  return OpenTotal{value->enclose(bits), RealBall::unknown()};
}

/// Of several PH curves the sum, where it is seen to be irrational, and not known in finite terms,
/// for that of the first one is not: without closed forms, which take long and are not asked for.
std::optional<PathTotal> irrational_sum(const Path& path, OfSegment of, const Integrand& integrand,
                                        KnownPoles& poles) {
  if (path.segments().size() == 1 || !path.is_ph()) return std::nullopt;
  const SegmentTotal first = of(path.segments().front());
  const auto* finite = std::get_if<PathTotal::OfSegment>(&first);
  const CurveTotal* form = finite == nullptr ? nullptr : closed_form(*finite);
  if (form == nullptr || form->exact) return std::nullopt;
  const auto shared = std::make_shared<const Path>(path);
  std::vector<Real> terms;
  terms.reserve(path.segments().size());
  constexpr long bits = first_bits_of_sums;
  RealBall value;
  RealBall logarithms;
  Stage stage("segments", path.segments().size());
  for (std::size_t k = 0; k < path.segments().size(); ++k, stage.advance()) {
    const Curve& curve = *ph_curve(path.segments()[k]);
    const auto found = open_total(curve, *poles.of(k, curve), integrand, bits);
    if (!found) return std::nullopt;
    terms.push_back(Real([shared, k, integrand, known = found->value](long wanted) {
      if (wanted <= bits) return known;
      const Curve& again = *ph_curve(shared->segments()[k]);
      return open_total(again, total_poles(again), integrand, wanted)->value;
    }));
    value = add(value, found->value, bits + 32);
    logarithms = add(logarithms, found->logarithm, bits + 32);
  }
  if (logarithms.contains_zero() && value.overlaps(rational_part(path, integrand.rate)))
    return std::nullopt;
  return PathTotal{
      {terms.begin(), terms.end()}, known_irrational(sum_of(std::move(terms))), std::nullopt};
}

std::variant<PathTotal, Infinite> sum_over(const Path& path, OfSegment of) {
  std::vector<PathTotal::OfSegment> segments;
  segments.reserve(path.segments().size());
  const auto shared = std::make_shared<const Path>(path);
  Stage stage("segments", path.segments().size());
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    SegmentTotal total = of(path.segments()[k]);
    if (const auto* infinite = std::get_if<Infinite>(&total))
      return Infinite{*algebraic_parameter(Place(k, infinite->pole)), k};
    auto& term = segments.emplace_back(std::get<PathTotal::OfSegment>(std::move(total)));
    if (auto* real = std::get_if<Real>(&term)) *real = kept_term(*real, shared, k, of);
    stage.advance();
  }
  return sum_of(std::move(segments));
}

std::variant<PathTotal, Infinite> sum_over(const Path& path, OfSegment of,
                                           const Integrand& integrand, KnownPoles& poles) {
  if (auto sum = irrational_sum(path, of, integrand, poles)) return *std::move(sum);
  return sum_over(path, of);
}

PathTotal finite_sum_over(const Path& path, OfSegment of) {
  return std::get<PathTotal>(sum_over(path, of));
}

// ---- What the segments add.

/// `of_ph` of a PH curve, `of_other` of another one.
template <class OfPh, class OfOther>
SegmentTotal by_kind(const Segment& segment, const OfPh& of_ph, const OfOther& of_other) {
  if (const Curve* curve = ph_curve(segment)) return of_ph(*curve);
  return visit_curve([&](const auto& curve) { return SegmentTotal(of_other(curve)); }, segment);
}

SegmentTotal shared(CurveTotal total) {
  return std::make_shared<const CurveTotal>(std::move(total));
}

SegmentTotal either(std::variant<CurveTotal, Infinite> total) {
  if (auto* finite = std::get_if<CurveTotal>(&total)) return shared(std::move(*finite));
  return std::get<Infinite>(total);
}

SegmentTotal length_of(const Segment& segment) {
  if (const Curve* curve = ph_curve(segment)) return shared(total_length(*curve));
  const SegmentIntegral length = arc_length(segment);
  if (auto sum = length.algebraic_value(1)) return *std::move(sum);
  return length.value(Rational(1));
}

// Of a PH curve by its positions √ρ/σ is this, too, with a square root as it is of any curve.
SegmentTotal curvature_of(const Segment& segment) {
  if (const Curve* curve = ph_curve(segment))
    if (auto total = total_curvature(*curve)) return shared(*std::move(total));
  return bending_angle(segment).value(Rational(1));
}

/// −∫ of how the rotation-minimizing frame turns, times sign p, with the sign changes of p in
/// (0, 1).
Real other_torsion(const RationalCurve& curve) {
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
  for (const RealRoot& root : odd(real_roots(curve.multiplier(), open_interval(0, 1))))
    add_up_to(at(root.at));
  add_up_to(turning.value(1));
  return sum;
}

Real other_torsion(const ExpressionCurve& curve) {
  return Rational(-curve.orientation()) * frenet_angle(curve).value(Rational(1));
}

SegmentTotal erf_twist_of(const Segment& segment) { return shared(erf_twist(*ph_curve(segment))); }

SegmentTotal torsion_of(const Segment& segment) {
  return by_kind(
      segment, [](const Curve& curve) { return shared(total_torsion(curve)); },
      [](const auto& curve) { return other_torsion(curve); });
}

/// The numerator and the denominator without what they have in common.
RootQuotient without_common_factor(const RootQuotient& f) {
  const Polynomial common = gcd(f.numerator, f.denominator);
  return {exact_quotient(f.numerator, common), exact_quotient(f.denominator, common), f.radicand};
}

/// ∫ of what is not negative, or where it has a pole.
SegmentTotal energy_of(const RootQuotient& given) {
  const RootQuotient rate = without_common_factor(given);
  const auto poles = rate.denominator.is_constant()
                         ? std::vector<RealRoot>{}
                         : real_roots(rate.denominator, closed_interval(0, 1));
  if (!poles.empty() && !rate.numerator.is_zero()) return Infinite{poles.front().at};
  return AbsoluteIntegral(rate).value(Rational(1));
}

Real whole_integral(const ExpressionCurve& curve, const CurveIntegrand& y) {
  return SegmentIntegral(ExpressionIntegral(curve, y)).value(Rational(1));
}

SegmentTotal other_bending(const RationalCurve& curve) {
  return energy_of(phrame::bending_rate(curve));
}

Real other_bending(const ExpressionCurve& curve) {
  if (are_on_a_line(direction_span(curve))) return Rational(0);
  return whole_integral(curve, bending_rate());
}

SegmentTotal bending_of(const Segment& segment) {
  return by_kind(
      segment, [](const Curve& curve) { return either(bending_energy(curve)); },
      [](const auto& curve) { return other_bending(curve); });
}

SegmentTotal other_frenet_energy(const RationalCurve& curve) {
  return energy_of(phrame::frenet_energy_rate(curve));
}

Real other_frenet_energy(const ExpressionCurve& curve) {
  const Real bending = other_bending(curve);
  if (common_normal(direction_span(curve))) return bending;  // τ = 0
  if (const auto fault = taylor_parts(curve, squared_torsion_rate())->fault)
    refuse_inflection(curve, *fault, "integral of the Frenet frame's rate");
  const Real twisting = whole_integral(curve, squared_torsion_rate());
  return Real([bending, twisting](long bits) {
    return add(bending.enclose(bits), twisting.enclose(bits), bits);
  });
}

SegmentTotal frenet_energy_of(const Segment& segment) {
  return by_kind(
      segment, [](const Curve& curve) { return either(frenet_energy(curve)); },
      [](const auto& curve) { return other_frenet_energy(curve); });
}

/// How far the tangent turns at corners, in finite terms where that is a rational multiple of π.
void add_corners(PathTotal& total, const std::vector<Corner>& corners) {
  std::vector<Real> angles{total.value};
  std::optional<Rational> half_turns = 0;
  for (const Corner& corner : corners) {
    angles.push_back(corner.angle);
    const auto over = half_turns ? over_pi(corner.angle) : std::nullopt;
    half_turns = over ? std::optional<Rational>(*half_turns + *over) : std::nullopt;
  }
  total.value = sum_of(std::move(angles));
  if (!half_turns) total.exact.reset();
  if (!total.exact) return;
  ExactValue turn;
  turn.pi = *half_turns;
  for (auto& [radicand, of] : *total.exact)
    if (radicand == 1) {
      of = of + turn;
      return;
    }
  total.exact->push_back({1, turn});
}

// ---- The rotation index.

/// e₁ of any length > 0; no value for formulas.
std::optional<Vector<Polynomial>> direction_of(const Segment& segment) {
  if (const auto* ph = std::get_if<PhSegment>(&segment)) return rotated_i(ph->primitive_preimage());
  if (const auto* curve = std::get_if<RationalCurve>(&segment)) return curve->direction();
  return std::nullopt;
}

/// 1 or −1 where e₁ = d/|d| turns to the left or right about this normal all along, 0 where it does
/// not turn; no value where it turns back. The sense is the sign of normal·(d × d′).
std::optional<int> sense_of_turn(const Vector<Polynomial>& d, const Vector<Rational>& normal) {
  const auto minor = [](const Polynomial& a, const Polynomial& b) {
    return a * differentiate(b) - b * differentiate(a);
  };
  const auto& [x, y, z] = d;
  const Polynomial turn =
      normal[0] * minor(y, z) + normal[1] * minor(z, x) + normal[2] * minor(x, y);
  if (turn.is_zero()) return 0;
  if (!odd(real_roots(turn, open_interval(0, 1))).empty()) return std::nullopt;
  return sign_after_zero(turn);
}

/// 1 or −1 where the tangent turns to the left or right at the corner at the start of that segment.
int sense_of_corner(const Path& path, std::size_t segment, const Vector<Rational>& normal) {
  const std::size_t count = path.segments().size();
  const auto before =
      evaluate(direction_of(path.segments()[(segment + count - 1) % count]).value(), 1);
  const auto after = evaluate(direction_of(path.segments()[segment]).value(), 0);
  return dot(normal, cross(before, after)).sign();
}

/// Is the tangent of a path in the plane with this normal seen never to turn back?
bool turns_one_way(const Path& path, const Vector<Rational>& normal) {
  int sense = 0;
  const auto is_against = [&](int here) {
    const bool is_other = here * sense < 0;
    if (here != 0) sense = here;
    return is_other;
  };
  for (const Segment& segment : path.segments()) {
    const auto d = direction_of(segment);
    const auto here = d ? sense_of_turn(*d, normal) : std::nullopt;
    if (!here || is_against(*here)) return false;
  }
  const auto corners = phrame::corners(path);
  return std::none_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    return is_against(sense_of_corner(path, corner.segment, normal));
  });
}

/// cos² of the angle between e₁ at the ends; 1 where the turn at a corner between them is counted.
Rational squared_cosine_of_ends(const Path& path) {
  if (closure(path).at_corner) return 1;
  const auto a = evaluate(direction_of(path.segments().front()).value(), 0);
  const auto b = evaluate(direction_of(path.segments().back()).value(), 1);
  const Rational product = dot(a, b);
  return product * product / (dot(a, a) * dot(b, b));
}

}  // namespace

Real value_of(const PathTotal::OfSegment& segment) {
  if (const CurveTotal* total = closed_form(segment)) return total->value;
  if (const auto* sum = std::get_if<Surd>(&segment)) return to_real(*sum);
  return std::get<Real>(segment);
}

const CurveTotal* closed_form(const PathTotal::OfSegment& segment) {
  const auto* total = std::get_if<std::shared_ptr<const CurveTotal>>(&segment);
  return total == nullptr ? nullptr : total->get();
}

PathTotal total_length(const Path& path) { return finite_sum_over(path, length_of); }

PathTotal total_curvature(const Path& path) {
  PathTotal total = finite_sum_over(path, curvature_of);
  const auto angles = corners(path);
  if (!angles.empty()) add_corners(total, angles);
  return total;
}

PathTotal total_torsion(const Path& path, KnownPoles& poles) {
  const Integrand integrand{total_torsion_rate, total_torsion_factors};
  return std::get<PathTotal>(sum_over(path, torsion_of, integrand, poles));
}

std::variant<PathTotal, Infinite> bending_energy(const Path& path, KnownPoles& poles) {
  return sum_over(path, bending_of, {bending_energy_rate, bending_energy_factors}, poles);
}

std::variant<PathTotal, Infinite> frenet_energy(const Path& path, KnownPoles& poles) {
  return sum_over(path, frenet_energy_of, {frenet_energy_rate, frenet_energy_factors}, poles);
}

PathTotal erf_twist(const PhPath& path, KnownPoles& poles) {
  const Integrand integrand{erf_twist_rate, erf_twist_factors};
  return std::get<PathTotal>(sum_over(path, erf_twist_of, integrand, poles));
}

PathTotal total_torsion(const Path& path) {
  KnownPoles poles;
  return total_torsion(path, poles);
}

std::variant<PathTotal, Infinite> bending_energy(const Path& path) {
  KnownPoles poles;
  return bending_energy(path, poles);
}

std::variant<PathTotal, Infinite> frenet_energy(const Path& path) {
  KnownPoles poles;
  return frenet_energy(path, poles);
}

PathTotal erf_twist(const PhPath& path) {
  KnownPoles poles;
  return erf_twist(path, poles);
}

Real reference_twist(const PathAngle& angle) {
  return -angle.value({angle.path().segments().size() - 1, Rational(1)});
}

std::optional<Real> absolute_rotation_index(const Path& path) {
  return absolute_rotation_index(path, total_curvature(path));
}

// The tangents at the ends have rational directions. Between them the tangent turns by ±α up to
// whole turns, where it does not turn back; and an angle α with a rational cos² α, so a rational
// cos 2α, is a rational multiple of π only for cos 2α = 0, ±1/2 and ±1 (Niven), that is for 4 cos²
// α = 0, 1, …, 4, where it is a multiple of π/12.
std::optional<Real> absolute_rotation_index(const Path& path, const PathTotal& curvature) {
  if (curvature.value.exact() == Rational(0)) return Real(Rational(0));
  const auto normal = plane_normal(path);
  if (!normal) return std::nullopt;
  if (curvature.exact && curvature.exact->size() == 1)
    if (const auto& [radicand, x] = curvature.exact->front(); x == ExactValue{0, x.pi, {}, {}})
      return square_root_of(radicand) * Rational(x.pi / 2);
  const Real index = curvature.value * Real([](long bits) {
                       return divide(RealBall(Rational(1, 2), bits), pi(bits), bits);
                     });
  if (!turns_one_way(path, *normal)) return index;
  if (denominator(Rational(4 * squared_cosine_of_ends(path))) != 1) return known_irrational(index);
  for (long bits = 64;; bits *= 2) {
    const RealBall parts = multiply(RealBall(24, bits), index.enclose(bits), bits);
    if (const auto nearest = unique_integer(parts)) return Real(Rational(*nearest, 24));
  }
}

}  // namespace phrame
