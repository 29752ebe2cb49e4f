// An end p = g(π) has a rational number m next to it, with no pole of f from m to p, and
//   ∫ f from a to p = ∫ f from a to m + ∫ f from m to p.
// A ball [u, v] around p gives the last integral by rational ends:
//   ∫ f from m to p ∈ ∫ f from m to u + (v − u)·[0, 1]·f([u, v]).
#include "phrame/integrate/path_end.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"

namespace phrame::inline v0 {
namespace {

/// g where the end is g(π) or rational; no value where it is another.
std::optional<RationalFunction> function_of_pi(const PathEnd& end) {
  if (const auto* r = std::get_if<Rational>(&end)) return RationalFunction(Polynomial{*r});
  if (const auto* p = std::get_if<PiValue>(&end)) return p->of_pi;
  return std::nullopt;
}

/// The integral from g(π) to h(π), where it is rational for an algebraic reason: F is rational, and
/// F(h) − F(g) constant; or f(c − t) = −f(t), c = g + h.
std::optional<Rational> rational_value(const RationalFunction& f, const Antiderivative& F,
                                       const PathEnd& a, const PathEnd& b) {
  const auto g = function_of_pi(a);
  const auto h = function_of_pi(b);
  if (!g || !h) return std::nullopt;
  if (*g == *h) return Rational(0);
  if (const auto c = constant(*g + *h); c && compose(f, Polynomial{*c, -1}) == -f)
    return Rational(0);
  if (!F.logs.empty()) return std::nullopt;
  const RationalFunction whole = RationalFunction(F.polynomial) + F.rational;
  return constant(compose(whole, *h) - compose(whole, *g));
}

/// A rational number with no pole between it and the end.
Rational next_to(const PiValue& end, const Polynomial& denominator) {
  const Real x = to_real(end);
  for (long bits = 64;; bits *= 2) {
    const RealBall ball = x.enclose(bits);
    if (ball.is_finite() &&
        count_real_roots(denominator, closed_interval(ball.lower(), ball.upper())) == 0)
      return ball.midpoint();
  }
}

/// ∫ f from m to the end, between which there is no pole; `evaluator` is of f.
Real rest(const RationalFunction& f, const Evaluator& evaluator, const Rational& m,
          const PiValue& end) {
  const auto enclosure = [=, x = to_real(end)](long bits) {
    for (long precision = bits + 32;; precision *= 2) {
      const RealBall ball = x.enclose(precision);
      if (!ball.is_finite()) continue;
      const Rational u = ball.lower();
      const RealBall rise = evaluate(f, ball, precision);
      if (!rise.is_finite()) continue;
      const RealBall width = hull(0, ball.upper() - u, precision);
      return add(evaluator.difference(m, u, bits + 8), multiply(width, rise, precision), precision);
    }
  };
  return {enclosure, {false, bits_of(end.of_pi) + bits_of(m) + bits_of(f)}};
}

}  // namespace

Real to_real(const PiValue& x) {
  return {[x](long bits) { return evaluate(x.of_pi, pi(bits + 16), bits + 16); },
          {true, bits_of(x.of_pi)}};
}

DefiniteIntegral path_integral(const RationalFunction& f, const PathEnd& a, const PathEnd& b,
                               AtPoles at_poles) {
  const auto near = [&](const PathEnd& end) {
    return std::visit(
        [&](const auto& x) -> Endpoint {
          if constexpr (std::is_same_v<std::decay_t<decltype(x)>, PiValue>)
            return next_to(x, f.denominator());
          else
            return x;
        },
        end);
  };
  const auto* p = std::get_if<PiValue>(&a);
  const auto* q = std::get_if<PiValue>(&b);
  if (p == nullptr && q == nullptr) return definite_integral(f, near(a), near(b), at_poles);
  const Endpoint from = near(a);
  const Endpoint to = near(b);
  const DefiniteIntegral middle = definite_integral(f, from, to, at_poles);
  const Antiderivative F = integrate(f, Form::partial_fractions);
  if (const auto r = rational_value(f, F, a, b)) return {*r, exact_value(*r)};
  const Evaluator evaluator(F, f);
  Real value = middle.value;
  if (p != nullptr) value = value + -rest(f, evaluator, std::get<Rational>(from), *p);
  if (q != nullptr) value = value + rest(f, evaluator, std::get<Rational>(to), *q);
  return {value, std::nullopt};
}

}  // namespace phrame
