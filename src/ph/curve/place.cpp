#include "phrame/ph/curve/place.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// The values of dⁿr/dsⁿ at t, or of dⁿr/dtⁿ, all components at once, kept for the bits that were
/// asked for last.
class DerivativeValues {
 public:
  DerivativeValues(const ExpressionCurve& curve, std::size_t order, const Real& t, bool is_by_t)
      : curve_(curve), order_(order), t_(t), is_by_t_(is_by_t) {}

  RealBall enclose(std::size_t component, long bits) const {
    return (*known_.get(bits, [&](const auto*) { return computed(bits + 8); }))[component];
  }

 private:
  // r(t + z) = Σ cₖ zᵏ, s = a + (b − a)t.
  Vector<RealBall> computed(long bits) const {
    const auto n = static_cast<long>(order_);
    const Vector<BallPolynomial> r = curve_.series(t_.enclose(bits), 1, n + 1, bits);
    RealBall scale(1, bits);
    for (long k = 2; k <= n; ++k) scale = multiply(scale, RealBall(k, bits), bits);
    if (n > 0 && !is_by_t_) {
      const RealBall length =
          subtract(constant_value(curve_.to(), bits), constant_value(curve_.from(), bits), bits);
      scale = divide(scale, pow(length, n, bits), bits);
    }
    Vector<RealBall> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = multiply(r[k].coefficient(n), scale, bits);
    return values;
  }

  ExpressionCurve curve_;
  std::size_t order_;
  Real t_;
  bool is_by_t_;
  Refined<Vector<RealBall>> known_;
};

Vector<Real> values_of(const ExpressionCurve& curve, std::size_t order, const Real& t,
                       bool is_by_t) {
  const auto values = std::make_shared<const DerivativeValues>(curve, order, t, is_by_t);
  Vector<Real> result{Rational(0), Rational(0), Rational(0)};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = Real([values, k](long bits) { return values->enclose(k, bits); });
  return result;
}

/// A constant, exact where its form shows a fraction.
Real value_of(const Formula& f) {
  if (const auto x = rational_value(f)) return *x;
  return Real([f](long bits) { return constant_value(f, bits + 8); });
}

/// v or −v, with this sign.
Vector<Real> with_sign(int sign, const Vector<Real>& v) {
  return sign < 0 ? Vector<Real>{-v[0], -v[1], -v[2]} : v;
}

}  // namespace

Place::Place(std::size_t on_segment, const RealAlgebraic& at) : Place(on_segment, to_real(at)) {
  if (!t.exact()) algebraic = std::make_shared<const AlgebraicPoint>(at);
}

Place end_of(const Path& path) { return {path.segments().size() - 1, Rational(1)}; }

std::optional<RealAlgebraic> algebraic_number(const Place& at) {
  if (at.t.exact()) return RealAlgebraic(*at.t.exact());
  if (at.algebraic) return at.algebraic->number();
  return std::nullopt;
}

namespace {

/// "[0, 12.5663706]"
std::string range_text(const Real& from, const Real& to) {
  const auto text = [](const Real& x) {
    return x.exact() ? as_written(*x.exact()) : to_string(x.enclose(64), 9);
  };
  return fmt::format("[{}, {}]", text(from), text(to));
}

}  // namespace

std::vector<Real> formula_parameters(const ExpressionCurve& curve) {
  return {value_of(curve.from()), value_of(curve.to())};
}

Place native_place(const NamedPath& named, const Rational& x) {
  const std::vector<Real>& joints = named.parameters;
  if (joints.empty()) throw DomainError("the file of the path has no parameter of its own but t");
  const int sense = sign_of(joints[1] + -joints[0]);
  const auto is_before = [&](const Real& joint) { return sense * sign_of(Real(x) + -joint) < 0; };
  const bool is_too_early = is_before(joints.front());
  if (is_too_early && is_rounded(x, joints.front())) return {0, Rational(0)};
  const bool is_too_late = sense * sign_of(Real(x) + -joints.back()) > 0;
  if (is_too_late && is_rounded(x, joints.back())) return end_of(named.path);
  if (is_too_early || is_too_late)
    throw DomainError(fmt::format("{} is outside {}, what the parameter of the file goes through",
                                  as_written(x), range_text(joints.front(), joints.back())));
  const auto behind = std::partition_point(joints.begin() + 1, joints.end() - 1,
                                           [&](const Real& joint) { return !is_before(joint); });
  const auto k = static_cast<std::size_t>(behind - joints.begin()) - 1;
  const Real from = joints[k];
  if (x == from.exact()) return {k, Rational(0)};
  if (x == joints[k + 1].exact()) return {k, Rational(1)};
  return {k, quotient_of(Real(x) + -from, joints[k + 1] + -from)};
}

Real parameter(const Place& at) { return at.t + Rational(static_cast<long>(at.segment)); }

std::optional<RealAlgebraic> algebraic_parameter(const Place& at) {
  const auto t = algebraic_number(at);
  if (!t) return std::nullopt;
  return affine(*t, 1, Rational(static_cast<long>(at.segment)));
}

Real value(const Polynomial& p, const Place& at) {
  return at.algebraic ? at.algebraic->value(p) : value(p, at.t);
}

Real value(const RationalFunction& f, const Place& at) {
  if (at.algebraic) return at.algebraic->value(f);
  if (at.t.exact()) return f(*at.t.exact());
  if (const auto c = constant(f)) return *c;
  return Real([f, t = at.t](long bits) { return evaluate(f, t.enclose(bits + 16), bits + 16); });
}

Real value(const Polynomial& p, const Real& t) {
  if (t.exact()) return p(*t.exact());
  if (p.is_constant()) return p.coefficient(0);
  return Real([p, t](long bits) { return evaluate(p, t.enclose(bits + 8), bits + 8); });
}

Vector<Real> position(const RationalCurve& curve, const Real& t) {
  const Real below = value(curve.weight(), t);
  const Vector<Polynomial>& X = curve.numerator();
  return {quotient_of(value(X[0], t), below), quotient_of(value(X[1], t), below),
          quotient_of(value(X[2], t), below)};
}

Vector<Real> direction(const RationalCurve& curve, const Real& t) {
  const Vector<Polynomial>& H = curve.direction();
  return {value(H[0], t), value(H[1], t), value(H[2], t)};
}

Vector<Real> derivative(const ExpressionCurve& curve, std::size_t order, const Real& t) {
  Vector<Real> result = values_of(curve, order, t, false);
  if (!t.exact()) return result;
  FormulaProgram program;
  const ExactVector exact = exact_derivative(curve, order, *t.exact(), program);
  for (std::size_t k = 0; k < 3; ++k)
    if (const Rational* x = program.rational(exact[k])) result[k] = *x;
  return result;
}

Vector<Real> position(const Path& path, const Place& at) {
  const Segment& segment = path.segments()[at.segment];
  if (const RationalCurve* curve = rational_curve(segment)) {
    if (!at.algebraic) return position(*curve, at.t);
    const auto component = [&](const Polynomial& x) {
      return value(RationalFunction(x, curve->weight()), at);
    };
    const Vector<Polynomial>& X = curve->numerator();
    return {component(X[0]), component(X[1]), component(X[2])};
  }
  return derivative(std::get<ExpressionCurve>(segment), 0, at.t);
}

Vector<Real> derivative(const Path& path, std::size_t order, const Place& at) {
  if (order == 0) return position(path, at);
  const Segment& segment = path.segments()[at.segment];
  Vector<Real> result{Rational(0), Rational(0), Rational(0)};
  if (const RationalCurve* curve = rational_curve(segment)) {
    for (std::size_t k = 0; k < 3; ++k) {
      RationalFunction x(curve->numerator()[k], curve->weight());
      for (std::size_t n = 0; n < order; ++n) x = differentiate(x);
      result[k] = value(x, at);
    }
    return result;
  }
  // dⁿr/dsⁿ·(b − a)ⁿ, where that is seen to be a fraction.
  const auto& formulas = std::get<ExpressionCurve>(segment);
  result = values_of(formulas, order, at.t, true);
  const std::vector<Real> ends = formula_parameters(formulas);
  const Real length = ends[1] + -ends[0];
  if (order > 3 || !at.t.exact()) return result;
  const Vector<Real> by_s = derivative(formulas, order, at.t);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!by_s[k].exact() || !(length.exact() || *by_s[k].exact() == 0)) continue;
    Rational x = *by_s[k].exact();
    for (std::size_t n = 0; n < order && x != 0; ++n) x *= *length.exact();
    result[k] = x;
  }
  return result;
}

Vector<Real> direction(const Path& path, const Place& at) {
  const Segment& segment = path.segments()[at.segment];
  if (const RationalCurve* curve = rational_curve(segment)) return direction(*curve, at.t);
  const auto& formulas = std::get<ExpressionCurve>(segment);
  return with_sign(formulas.orientation() * direction_of_parameter(formulas),
                   derivative(formulas, 1, at.t));
}

Vector<Real> direction_slope(const Path& path, const Place& at) {
  const Segment& segment = path.segments()[at.segment];
  if (const auto* formulas = std::get_if<ExpressionCurve>(&segment))
    return with_sign(formulas->orientation(), derivative(*formulas, 2, at.t));
  const Vector<Polynomial> slope = differentiate(rational_curve(segment)->direction());
  return {value(slope[0], at.t), value(slope[1], at.t), value(slope[2], at.t)};
}

}  // namespace phrame
