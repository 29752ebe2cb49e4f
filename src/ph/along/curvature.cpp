#include "phrame/ph/along/curvature.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/ring_ball.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/along/expression_integral.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "phrame/ph/curve/formula_domain.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

RationalFunction squared_curvature(const RationalCurve& curve) {
  const Vector<Polynomial> b = binormal(curve);
  const Polynomial sigma = dot(curve.direction(), curve.direction());
  return {dot(b, b) * pow(curve.weight(), 4), pow(curve.multiplier(), 2) * pow(sigma, 3)};
}

RationalFunction torsion(const RationalCurve& curve) {
  const auto [sigma, rho, volume] = turning_of(curve);
  if (rho.is_zero()) throw DomainError("torsion: the curve is a straight line, it has none");
  return {volume * pow(curve.weight(), 2), curve.multiplier() * rho};
}

namespace {

/// f(t), exact where t is.
Real value_of(const RationalFunction& f, const Real& t, const char* name) {
  if (!t.exact())
    return Real([f, t](long bits) { return evaluate(f, t.enclose(bits + 8), bits + 8); });
  const Rational below = f.denominator()(*t.exact());
  if (below == 0)
    throw DomainError(fmt::format("{}: it is infinite at t = {}", name, as_written(*t.exact())));
  return Rational(f.numerator()(*t.exact()) / below);
}

/// Has the curve neither inflections nor a straight part?
bool bends_all_along(const RationalCurve& curve) {
  const Polynomial common = gcd(binormal(curve));
  return !common.is_zero() && count_real_roots(common, {0, 1}) == 0;
}

bool bends_all_along(const ExpressionCurve& curve) {
  if (are_on_a_line(direction_span(curve))) return false;
  const auto fault = taylor_parts(curve, curvature_rate())->fault;
  if (!fault) return true;
  const Vector<Formula> bend = cross(curve.derivative(1), curve.derivative(2));
  if (simple_zero(curve, widened_part(*fault), bend)) return false;
  throw Undecided("whether the curvature is 0 somewhere is not told within parts of 2^-40");
}

/// H × H′ at t, up to a positive factor, put into the program.
ExactVector binormal_at(const RationalCurve& curve, const Rational& t, FormulaProgram& program) {
  const Vector<Rational> b = evaluate(binormal(curve), t);
  return {program.number(b[0]), program.number(b[1]), program.number(b[2])};
}

ExactVector binormal_at(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program) {
  const ExactVector u = exact_direction(curve, t, program);
  ExactVector v = exact_derivative(curve, 2, t, program);
  if (curve.orientation() < 0)
    for (auto& x : v) x = program.negative(x);
  ExactVector b{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    b[k] = program.subtract(program.multiply(u[i], v[j]), program.multiply(u[j], v[i]));
  }
  return b;
}

/// Is the principal normal at the end of one segment that at the start of the other?
bool have_same_normal(const Segment& before, const Segment& after) {
  FormulaProgram program;
  const auto at = [&](const Segment& segment, const Rational& t) {
    return visit_curve([&](const auto& curve) { return binormal_at(curve, t, program); }, segment);
  };
  const auto same = have_same_direction(program, at(before, 1), at(after, 0));
  if (!same) throw Undecided("whether the normals at a joint are the same is not told");
  return *same;
}

/// The binormal of the Frenet frame that is continued through inflections, up to a factor ≠ 0.
ExactVector continued_binormal(const RationalCurve& curve, const Rational& t,
                               FormulaProgram& program) {
  const Vector<Polynomial> b = binormal(curve);
  const Polynomial common = gcd(b);
  ExactVector result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = program.number(exact_quotient(b[k], common)(t));
  return result;
}

ExactVector continued_binormal(const ExpressionCurve& curve, const Rational& t,
                               FormulaProgram& program) {
  const auto plane = common_normal(direction_span(curve));
  if (!plane) return binormal_at(curve, t, program);
  return {program.number((*plane)[0]), program.number((*plane)[1]), program.number((*plane)[2])};
}

/// "Frenet frame: at the joint t = 2 it jumps, by 0.5 radians": the angle between these binormals,
/// less a half turn where it is nearer to that.
std::string frenet_jump(std::size_t joint, const FormulaProgram& program, const ExactVector& before,
                        const ExactVector& after) {
  constexpr long bits = 512;
  using Ball = RingBall<bits>;
  const auto value = [&](const ExactVector& v) {
    return Vector<Ball>{Ball{constant_value(program, v[0], bits)},
                        Ball{constant_value(program, v[1], bits)},
                        Ball{constant_value(program, v[2], bits)}};
  };
  const Vector<Ball> a = value(before);
  const Vector<Ball> b = value(after);
  const Vector<Ball> c = cross(a, b);
  const RealBall across = sqrt_of_nonnegative(dot(c, c).x, bits);
  const double by = approximate(argument(ComplexBall(absolute(dot(a, b).x), across), bits));
  return fmt::format("Frenet frame: at the joint t = {} it jumps, by {:.3g} radians", joint, by);
}

// By the parameter of the formulas, κ = |r′ × r″|/|r′|³ and τ = det(r′, r″, r‴)/|r′ × r″|².

Real curvature_of(const ExpressionCurve& curve, const Real& t) {
  const Vector<Real> first = derivative(curve, 1, t);
  const Vector<Real> bend = cross(first, derivative(curve, 2, t));
  if (is_zero(bend)) return Rational(0);
  const Real speed = dot(first, first);
  return square_root_of(Real([size = dot(bend, bend), cube = speed * speed * speed](long bits) {
    return divide(size.enclose(bits + 8), cube.enclose(bits + 8), bits + 8);
  }));
}

Real torsion_of(const ExpressionCurve& curve, const Real& t) {
  const auto span = direction_span(curve);
  if (are_on_a_line(span)) throw DomainError("torsion: the curve is a straight line, it has none");
  if (common_normal(span)) return Rational(0);
  const Vector<Real> bend = cross(derivative(curve, 1, t), derivative(curve, 2, t));
  if (is_zero(bend)) throw DomainError("torsion: the curvature is 0 there, at an inflection");
  const Real size = dot(bend, bend);
  return Real([volume = dot(bend, derivative(curve, 3, t)), size](long bits) {
    return divide(volume.enclose(bits + 8), size.enclose(bits + 8), bits + 8);
  });
}

Real curvature_of(const RationalCurve& curve, const Real& t) {
  return square_root_of(value_of(squared_curvature(curve), t, "curvature"));
}

Real torsion_of(const RationalCurve& curve, const Real& t) {
  return value_of(torsion(curve), t, "torsion");
}

}  // namespace

Real curvature(const Path& path, const Place& at) {
  return visit_curve([&](const auto& curve) { return curvature_of(curve, at.t); },
                     path.segments()[at.segment]);
}

namespace {

/// |r′|/|H|, which for formulas is by their parameter.
Real speed_over_direction(const RationalCurve& curve, const Place& at) {
  const Real p = value(curve.multiplier(), at);
  if (sign_of(p) == 0) throw DomainError("curvature: it is infinite or undefined at a cusp");
  const Real w = value(curve.weight(), at);
  return quotient_of(sign_of(p) < 0 ? -p : p, w * w);
}
Real speed_over_direction(const ExpressionCurve&, const Place&) { return Rational(1); }

}  // namespace

// d(H/|H|)/dt = (H × H′) × H/|H|³ = (σH′ − (H·H′)H)/|H|³, and ds/dt = |H| times that ratio.
Vector<Real> curvature_vector(const Path& path, const Place& at) {
  const Vector<Real> H = direction(path, at);
  const Vector<Real> slope = direction_slope(path, at);
  const Real sigma = dot(H, H);
  const Real ratio = visit_curve([&](const auto& curve) { return speed_over_direction(curve, at); },
                                 path.segments()[at.segment]);
  const Real below = sigma * sigma * ratio;
  const Vector<Real> across = cross(cross(H, slope), H);
  return {quotient_of(across[0], below), quotient_of(across[1], below),
          quotient_of(across[2], below)};
}

namespace {

/// H″, and q′/q of q = |r′|/|H|.
struct SecondOrder {
  Vector<Real> second;
  Real ratio_slope;
};
SecondOrder second_order(const RationalCurve& curve, const Place& at) {
  const Polynomial& p = curve.multiplier();
  const Polynomial& w = curve.weight();
  Vector<Real> second{Rational(0), Rational(0), Rational(0)};
  for (std::size_t k = 0; k < 3; ++k)
    second[k] = value(differentiate(differentiate(curve.direction()[k])), at);
  return {second, quotient_of(value(differentiate(p), at), value(p, at)) +
                      Real(Rational(-2)) * quotient_of(value(differentiate(w), at), value(w, at))};
}
SecondOrder second_order(const ExpressionCurve& curve, const Place& at) {
  Vector<Real> second = derivative(curve, 3, at.t);
  if (curve.orientation() < 0) second = opposite(second);
  return {second, Rational(0)};
}

}  // namespace

// With N = H × H′ and |r′| = q|H| it is β = N/(q·σ^{3/2}), so that
//   dβ/ds = (N′ − (q′/q + 3H·H′/σ)·N)/(q²σ²).
Vector<Real> turning_slope(const Path& path, const Place& at) {
  const Vector<Real> H = direction(path, at);
  const Vector<Real> slope = direction_slope(path, at);
  const Real sigma = dot(H, H);
  const Segment& segment = path.segments()[at.segment];
  const Real ratio =
      visit_curve([&](const auto& curve) { return speed_over_direction(curve, at); }, segment);
  const SecondOrder order =
      visit_curve([&](const auto& curve) { return second_order(curve, at); }, segment);
  const Real factor = -(order.ratio_slope + Real(Rational(3)) * quotient_of(dot(H, slope), sigma));
  const Real below = ratio * ratio * sigma * sigma;
  const Vector<Real> change = cross(H, order.second) + factor * cross(H, slope);
  return each(change, [&](const Real& x) { return quotient_of(x, below); });
}

Real torsion(const Path& path, const Place& at) {
  return visit_curve([&](const auto& curve) { return torsion_of(curve, at.t); },
                     path.segments()[at.segment]);
}

bool has_continuous_frenet_frame(const Path& path) {
  const auto& segments = path.segments();
  if (!path.corners().empty()) return false;
  for (const Segment& segment : segments)
    if (!visit_curve([](const auto& curve) { return bends_all_along(curve); }, segment))
      return false;
  for (std::size_t k = 0; k + 1 < segments.size(); ++k)
    if (!have_same_normal(segments[k], segments[k + 1])) return false;
  if (!path.is_closed()) return true;
  return !path.closes_at_corner() && have_same_normal(segments.back(), segments.front());
}

void require_frenet_joints(const Path& path) {
  const auto& segments = path.segments();
  for (std::size_t k = 0; segments.size() > 1 && k < segments.size(); ++k)
    if (is_straight(Path(segments[k])))
      throw DomainError(fmt::format(
          "Frenet frame: segment {} is a straight line, it has no principal normal", k + 1));
  for (std::size_t k = 1; k < segments.size(); ++k) {
    FormulaProgram program;
    const auto at = [&](const Segment& segment, const Rational& t) {
      return visit_curve([&](const auto& curve) { return continued_binormal(curve, t, program); },
                         segment);
    };
    const ExactVector before = at(segments[k - 1], 1);
    const ExactVector after = at(segments[k], 0);
    ExactVector opposite{};
    for (std::size_t axis = 0; axis < 3; ++axis) opposite[axis] = program.negative(after[axis]);
    const auto same = have_same_direction(program, before, after);
    const auto flipped = have_same_direction(program, before, opposite);
    if (same == true || flipped == true) continue;
    if (!same || !flipped)
      throw Undecided(
          fmt::format("whether the Frenet frame jumps at the joint t = {} is not told", k));
    throw DomainError(frenet_jump(k, program, before, after));
  }
}

}  // namespace phrame
