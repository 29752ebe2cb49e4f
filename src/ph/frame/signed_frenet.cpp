#include "phrame/ph/frame/signed_frenet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/curve_point.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/formula_domain.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/formula_program.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

// b is along β = H × H′, and n along β × H. Of a rational curve β = G·B with G the greatest common
// divisor, and B has no zero: B is the continued direction, with the sign for which G > 0 at first.
//
// Of formulas β is c·r′ × r″ by their parameter s, c = 1 where s grows with t. At a zero s₀ of
// order m it is (s − s₀)ᵐ times something that is D/m! there, D the m-th derivative; on a part on
// which a component of that has no zero, β has no other one (Rolle), and (s − s₀)⁻ᵐβ is in the ball
// of the m-th derivative there, over m! (Lagrange).
//
// n·(v × e₁) and n·(e₁ × (v × e₁)) are B·v and (B × H)·v/|H|, up to a positive factor.

namespace phrame::inline v0 {

/// How a rational curve turns.
struct RationalTurning {
  Vector<Polynomial> binormal;  ///< B
  Polynomial content;           ///< G, > 0 at first
};

/// A zero of r′ × r″.
struct FormulaZero {
  NarrowPart part;             ///< on which there is no other
  Formula place;               ///< s there
  Real t;                      ///< t there
  long order;                  ///< m
  Vector<Formula> derivative;  ///< the m-th
  bool is_at_start;
};

/// How one by formulas does.
struct FormulaTurning {
  std::vector<FormulaZero> zeros;  ///< ascending, but in a plane with the normal:
  std::optional<Vector<Rational>> normal = {};
  int direction;  ///< 1 where s grows with t
};

namespace {

constexpr long ball_bits = 128;

using BendBalls = Vector<RealBall>;

RealBall product(const BendBalls& a, const BendBalls& b) {
  RealBall sum = multiply(a[0], b[0], ball_bits);
  sum = add_product(sum, a[1], b[1], ball_bits);
  return add_product(sum, a[2], b[2], ball_bits);
}

BendBalls cross_product(const BendBalls& a, const BendBalls& b) {
  const auto minor = [](const RealBall& p, const RealBall& s, const RealBall& q,
                        const RealBall& r) {
    return subtract(multiply(p, s, ball_bits), multiply(q, r, ball_bits), ball_bits);
  };
  return {minor(a[1], b[2], a[2], b[1]), minor(a[2], b[0], a[0], b[2]),
          minor(a[0], b[1], a[1], b[0])};
}

bool may_be_zero(const BendBalls& v) {
  return std::ranges::all_of(v, [](const RealBall& x) { return sign(x) == 0; });
}

BendBalls times_sign(int sign, BendBalls v) {
  if (sign < 0)
    for (RealBall& x : v) x = subtract({}, x, ball_bits);
  return v;
}

// ---- rational curves

RationalTurning turning_of(const RationalCurve& curve) {
  const Vector<Polynomial> b = binormal(curve);
  RationalTurning found{{}, gcd(b)};
  if (found.content.is_zero())
    throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
  if (sign_after_zero(found.content) < 0) found.content = -found.content;
  for (std::size_t k = 0; k < 3; ++k) found.binormal[k] = exact_quotient(b[k], found.content);
  return found;
}

// ---- formulas

/// f at the constant s.
Real value_at(const Formula& f, const Formula& s) {
  FormulaProgram program;
  const auto id = program.insert(f, program.insert(s, program.number(0)));
  if (const Rational* value = program.rational(id)) return *value;
  const auto shared = std::make_shared<const FormulaProgram>(std::move(program));
  return Real([shared, id](long bits) { return constant_value(*shared, id, bits + 8); });
}

/// A ball around f on a part.
RealBall ball_on(const ExpressionCurve& curve, const Formula& f, const RealBall& t) {
  const RealBall s = curve.parameter(t, ball_bits);
  return evaluate_steps(f.steps(), BallPolynomial(std::vector<RealBall>{s}), 1, ball_bits)
      .back()
      .coefficient(0);
}

BendBalls bend_on(const ExpressionCurve& curve, const RealBall& t) {
  const CurvePoint point(curve, t, 1, ball_bits);
  return {point.bend()[0].value, point.bend()[1].value, point.bend()[2].value};
}

/// The parts of 2^−40 on which r′ × r″ may be 0, neighbours as one.
void find_narrow(const ExpressionCurve& curve, const Rational& lower, const Rational& upper,
                 int halvings, std::vector<NarrowPart>& found) {
  constexpr int most_halvings = 40;
  constexpr std::size_t most_parts = 64;
  if (!may_be_zero(bend_on(curve, hull(lower, upper, ball_bits)))) return;
  if (halvings == most_halvings) {
    if (!found.empty() && found.back().upper == lower)
      found.back().upper = upper;
    else
      found.push_back({lower, upper});
    if (found.size() > most_parts)
      throw Undecided("Frenet frame: the curvature is 0, or nearly so, at too many places");
    return;
  }
  if (upper - lower > Rational(1, 1 << 30) && !found.empty() &&
      found.back().upper - found.back().lower > Rational(1, 1 << 30))
    refuse_inflection(curve, found.back(), "Frenet frame");
  const Rational middle = (lower + upper) / 2;
  find_narrow(curve, lower, middle, halvings + 1, found);
  find_narrow(curve, middle, upper, halvings + 1, found);
}

FormulaZero zero_in(const ExpressionCurve& curve, const NarrowPart& narrow) {
  const auto refuse = [&](const char* what) {
    throw Undecided(
        fmt::format("Frenet frame: {} near t = {:.9g}", what, static_cast<double>(narrow.lower)));
  };
  const NarrowPart part = widened_part(narrow);
  Vector<Formula> f = cross(curve.derivative(1), curve.derivative(2));
  const auto place = simple_zero(curve, part, f);
  if (!place) refuse("whether the curvature is 0 is not told");
  constexpr long most = 8;
  for (long order = 1; order <= most; ++order) {
    for (Formula& x : f) x = derivative(x);
    const Vector<Real> at{value_at(f[0], *place), value_at(f[1], *place), value_at(f[2], *place)};
    if (is_zero(at)) continue;
    const RealBall all = hull(part.lower, part.upper, ball_bits);
    if (std::ranges::none_of(f,
                             [&](const Formula& x) { return sign(ball_on(curve, x, all)) != 0; }))
      refuse("the order of the zero of the curvature is not told");
    const Formula way = curve.to() - curve.from();
    const Real t = value_at((*place - curve.from()) / way, Formula(0));
    return {part, *place, t, order, f, rational_value(*place - curve.from()) == Rational(0)};
  }
  refuse("the order of the zero of the curvature is not told");
  std::abort();
}

FormulaTurning turning_of(const ExpressionCurve& curve) {
  if (is_straight(Path(curve)))
    throw DomainError("Frenet frame: the curve is a straight line, it has no principal normal");
  FormulaTurning found{{}, {}, direction_of_parameter(curve)};
  if (const auto normal = common_normal(direction_span(curve))) {
    const BendBalls n{RealBall((*normal)[0], ball_bits), RealBall((*normal)[1], ball_bits),
                      RealBall((*normal)[2], ball_bits)};
    if (const int side = sign(product(bend_on(curve, RealBall(0, ball_bits)), n)); side != 0) {
      found.normal = Rational(side) * *normal;
      return found;
    }
  }
  std::vector<NarrowPart> parts;
  find_narrow(curve, 0, 1, 0, parts);
  for (const NarrowPart& part : parts) {
    FormulaZero zero = zero_in(curve, part);
    if (!found.zeros.empty() && zero.part.lower < found.zeros.back().part.upper) {
      if (zero.place == found.zeros.back().place) continue;
      throw Undecided("Frenet frame: two zeros of the curvature are not told apart");
    }
    found.zeros.push_back(std::move(zero));
  }
  return found;
}

}  // namespace

struct PHRAME_INSIDE SignedFrenet::State {
  using Turning = std::variant<RationalTurning, FormulaTurning>;

  Path path;
  std::vector<Turning> turnings{};
  std::vector<int> signs{};  ///< of the segments, by which their own are continued

  explicit State(const Path& of);

  /// t of the segment less that of the zero: the sign.
  int side_of(std::size_t segment, const FormulaZero& zero, const Real& t) const;
  /// The product of −1 for each zero of odd order up to t, and the zero that t is at.
  std::pair<int, const FormulaZero*> side(std::size_t segment, const Real& t) const;
  Vector<Real> binormal(const Place& at) const;
  BendBalls binormal_on(std::size_t segment, const NarrowPart& part) const;
  RealBall angle_along(std::size_t segment, const BendBalls& v, const Rational& lower,
                       const Rational& upper, int halvings) const;
  std::pair<RealBall, RealBall> in_plane(std::size_t segment, const BendBalls& v,
                                         const NarrowPart& part) const;
};

int SignedFrenet::State::side_of(std::size_t segment, const FormulaZero& zero,
                                 const Real& t) const {
  if (t.exact()) {
    const auto& curve = std::get<ExpressionCurve>(path.segments()[segment]);
    const Formula s = curve.from() + Formula(*t.exact()) * (curve.to() - curve.from());
    if (rational_value(s - zero.place) == Rational(0)) return 0;
  }
  const Real off = t + -zero.t;
  const int found = sign_of(off);
  if (found == 0 && !off.exact())
    throw Undecided("Frenet frame: a place is not told from an inflection");
  return found;
}

std::pair<int, const FormulaZero*> SignedFrenet::State::side(std::size_t segment,
                                                             const Real& t) const {
  int product = 1;
  for (const FormulaZero& zero : std::get<FormulaTurning>(turnings[segment]).zeros) {
    const int where = side_of(segment, zero, t);
    if (where < 0) break;
    if (!zero.is_at_start && zero.order % 2 != 0) product = -product;
    if (where == 0) return {product, &zero};
  }
  return {product, nullptr};
}

Vector<Real> SignedFrenet::State::binormal(const Place& at) const {
  const int sign = signs[at.segment];
  if (const auto* of = std::get_if<RationalTurning>(&turnings[at.segment])) {
    Vector<Real> b{value(of->binormal[0], at), value(of->binormal[1], at),
                   value(of->binormal[2], at)};
    return sign < 0 ? opposite(b) : b;
  }
  const FormulaTurning& formulas = std::get<FormulaTurning>(turnings[at.segment]);
  if (formulas.normal) return as_reals(Rational(sign) * *formulas.normal);
  const int along = formulas.direction;
  const auto [product, zero] = side(at.segment, at.t);
  if (zero == nullptr) {
    const Vector<Real> b = cross(direction(path, at), direction_slope(path, at));
    return sign * product < 0 ? opposite(b) : b;
  }
  const int turned = zero->order % 2 != 0 ? 1 : along;
  const Vector<Real> b{value_at(zero->derivative[0], zero->place),
                       value_at(zero->derivative[1], zero->place),
                       value_at(zero->derivative[2], zero->place)};
  return sign * product * turned < 0 ? opposite(b) : b;
}

SignedFrenet::State::State(const Path& of) : path(of) {
  for (const Segment& segment : path.segments())
    turnings.push_back(
        visit_curve([](const auto& curve) -> Turning { return turning_of(curve); }, segment));
  signs.assign(turnings.size(), 1);
  if (turnings.size() == 1) return;
  require_frenet_joints(path);
  for (std::size_t k = 1; k < turnings.size(); ++k) {
    const int same = sign_of(dot(binormal({k - 1, Rational(1)}), binormal({k, Rational(0)})));
    if (same == 0)
      throw Undecided(
          fmt::format("Frenet frame: whether it goes on at the joint t = {} is not told", k));
    signs[k] = same;
  }
}

SignedFrenet::SignedFrenet(const Path& path) : state_(std::make_shared<const State>(path)) {}

Frame<Real> SignedFrenet::frame(const Place& at) const {
  const Vector<Real> H = direction(state_->path, at);
  return frame_along(H, cross(state_->binormal(at), H));
}

Real SignedFrenet::curvature(const Place& at) const {
  const State& of = *state_;
  int sign = of.signs[at.segment];
  if (const auto* rational = std::get_if<RationalTurning>(&of.turnings[at.segment])) {
    const auto t = algebraic_number(at);
    sign *= t ? sign_at(rational->content, *t) : sign_of(value(rational->content, at));
  } else if (std::get<FormulaTurning>(of.turnings[at.segment]).normal) {
    const Vector<Real> H = direction(of.path, at);
    const Vector<Real> n = of.binormal(at);
    const Real square = dot(H, H);
    const Real turn = dot(cross(H, direction_slope(of.path, at)), n);
    return over_square_root(quotient_of(turn, square), dot(n, n) * square);
  } else {
    const auto [product, zero] = of.side(at.segment, at.t);
    sign *= zero != nullptr ? 0 : product;
  }
  if (sign == 0) return Rational(0);
  const Real kappa = phrame::curvature(of.path, at);
  return sign < 0 ? -kappa : kappa;
}

// ---- turns

/// B on a part that is in the part of a zero or in none.
BendBalls SignedFrenet::State::binormal_on(std::size_t segment, const NarrowPart& part) const {
  const int sign = signs[segment];
  const RealBall t = hull(part.lower, part.upper, ball_bits);
  if (const auto* of = std::get_if<RationalTurning>(&turnings[segment]))
    return times_sign(
        sign, {evaluate(of->binormal[0], t, ball_bits), evaluate(of->binormal[1], t, ball_bits),
               evaluate(of->binormal[2], t, ball_bits)});
  const auto& curve = std::get<ExpressionCurve>(path.segments()[segment]);
  const FormulaTurning& of = std::get<FormulaTurning>(turnings[segment]);
  if (of.normal) {
    const Vector<Rational>& n = *of.normal;
    return times_sign(
        sign, {RealBall(n[0], ball_bits), RealBall(n[1], ball_bits), RealBall(n[2], ball_bits)});
  }
  int product = sign;
  for (const FormulaZero& zero : of.zeros) {
    const bool is_odd = zero.order % 2 != 0;
    const bool is_point = part.lower == part.upper;  // those at the ends of its part belong to it
    if (is_point ? part.upper < zero.part.lower : part.upper <= zero.part.lower) break;
    if (is_odd && !zero.is_at_start) product = -product;
    if (is_point ? part.lower > zero.part.upper : part.lower >= zero.part.upper) continue;
    const RealBall all = hull(zero.part.lower, zero.part.upper, ball_bits);
    return times_sign(
        product * (is_odd ? 1 : of.direction),
        {ball_on(curve, zero.derivative[0], all), ball_on(curve, zero.derivative[1], all),
         ball_on(curve, zero.derivative[2], all)});
  }
  return times_sign(product, bend_on(curve, t));
}

std::pair<RealBall, RealBall> SignedFrenet::State::in_plane(std::size_t segment, const BendBalls& v,
                                                            const NarrowPart& part) const {
  const RealBall t = hull(part.lower, part.upper, ball_bits);
  const BendBalls b = binormal_on(segment, part);
  const BendBalls H = visit_curve(
      [&](const auto& curve) -> BendBalls {
        if constexpr (std::is_same_v<std::decay_t<decltype(curve)>, RationalCurve>) {
          return {evaluate(curve.direction()[0], t, ball_bits),
                  evaluate(curve.direction()[1], t, ball_bits),
                  evaluate(curve.direction()[2], t, ball_bits)};
        } else {
          const CurvePoint point(curve, t, 1, ball_bits);
          return times_sign(curve.orientation(), {point.first()[0].value, point.first()[1].value,
                                                  point.first()[2].value});
        }
      },
      path.segments()[segment]);
  return {multiply(product(b, v), sqrt(product(H, H), ball_bits), ball_bits),
          product(cross_product(b, H), v)};
}

/// By which angle the vector in the plane turns; on a part on which it stays in a half-plane that
/// is less than π.
RealBall SignedFrenet::State::angle_along(std::size_t segment, const BendBalls& v,
                                          const Rational& lower, const Rational& upper,
                                          int halvings) const {
  const auto [x, y] = in_plane(segment, v, {lower, upper});
  if (sign(x) != 0 || sign(y) != 0) {
    const auto [x0, y0] = in_plane(segment, v, {lower, lower});
    const auto [x1, y1] = in_plane(segment, v, {upper, upper});
    return argument(multiply(ComplexBall(x1, y1), conjugate(ComplexBall(x0, y0)), ball_bits),
                    ball_bits);
  }
  constexpr int most_halvings = 36;
  if (halvings == most_halvings)
    throw Undecided(fmt::format(
        "the turns of the normal: the vector is along the tangent, or nearly so, near t = {:.9g}",
        static_cast<double>(Rational(lower + static_cast<long>(segment)))));
  const Rational middle = (lower + upper) / 2;
  return add(angle_along(segment, v, lower, middle, halvings + 1),
             angle_along(segment, v, middle, upper, halvings + 1), ball_bits);
}

Rational SignedFrenet::turns_about(const Vector<Rational>& v) const {
  const State& of = *state_;
  if (!of.path.is_closed() || of.path.closes_at_corner())
    throw DomainError("the turns of the normal: the path is not closed with a continuous tangent");
  require_up_vector(of.path, v);
  const BendBalls up{RealBall(v[0], ball_bits), RealBall(v[1], ball_bits),
                     RealBall(v[2], ball_bits)};
  RealBall angle;
  for (std::size_t k = 0; k < of.turnings.size(); ++k) {
    std::vector<Rational> cuts{0};
    if (const auto* formulas = std::get_if<FormulaTurning>(&of.turnings[k]))
      for (const FormulaZero& zero : formulas->zeros)
        for (const Rational& end : {zero.part.lower, zero.part.upper})
          if (end > cuts.back() && end < 1) cuts.push_back(end);
    cuts.emplace_back(1);
    for (std::size_t j = 0; j + 1 < cuts.size(); ++j)
      angle = add(angle, of.angle_along(k, up, cuts[j], cuts[j + 1], 0), ball_bits);
  }
  const auto half_turns = unique_integer(divide(angle, pi(ball_bits), ball_bits));
  if (!half_turns)
    throw DomainError("the turns of the normal: the Frenet frame jumps where the path closes");
  return Rational(*half_turns) / 2;
}

}  // namespace phrame
