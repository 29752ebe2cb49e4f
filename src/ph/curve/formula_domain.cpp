#include "phrame/ph/curve/formula_domain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long domain_bits = 128;

/// The values of the steps on [t, t + width].
std::vector<BallPolynomial> values_on(const ExpressionCurve& curve, const NarrowPart& part) {
  const RealBall s = curve.parameter(hull(part.lower, part.upper, domain_bits), domain_bits);
  return evaluate_steps(curve.program().steps(), BallPolynomial(std::vector<RealBall>{s}), 1,
                        domain_bits);
}

/// Does the step need an operand ≠ 0, or > 0? Which, and what for?
struct Need {
  std::size_t operand;
  bool is_positive;
};
Need need_of(const Formula::Step& step) {
  using Operation = Formula::Operation;
  if (step.operation == Operation::divide) return {step.right, false};
  const bool is_power = step.operation == Operation::power;
  return {step.left, !is_power || denominator(step.number) != 1};
}

/// Of the numbers s on the part the simplest rational one and the simplest multiple of π.
Vector<Formula> simple_places(const ExpressionCurve& curve, const NarrowPart& part) {
  const RealBall a = curve.parameter(RealBall(part.lower, domain_bits), domain_bits);
  const RealBall b = curve.parameter(RealBall(part.upper, domain_bits), domain_bits);
  const auto simplest = [](const RealBall& x, const RealBall& y) {
    return simplest_between(std::min(x.lower(), y.lower()), std::max(x.upper(), y.upper()));
  };
  const RealBall unit = pi(domain_bits);
  const auto turns = simplest(divide(a, unit, domain_bits), divide(b, unit, domain_bits));
  const Formula rational(simplest(a, b));
  const Formula by_pi(0, turns);
  const bool is_turn = bits_of(turns) < bits_of(rational.steps().front().number);
  return is_turn ? Vector<Formula>{by_pi, rational, by_pi}
                 : Vector<Formula>{rational, by_pi, rational};
}

/// "s = 3/2*pi": the simplest place on the part, or its digits.
std::string place_on(const ExpressionCurve& curve, const NarrowPart& part) {
  constexpr long place_bits = 30;
  const Formula place = simple_places(curve, part)[0];
  const Formula::Step& number = place.steps().front();
  const bool is_simple = bits_of(number.number) + bits_of(number.pi_multiple) < place_bits;
  return fmt::format(
      "{} = {}", curve.variable(),
      is_simple ? to_string(place, curve.variable()) : to_string(constant_value(place, 64), 12));
}

Formula formula_of_step(const ExpressionCurve& curve, std::size_t step) {
  const auto& steps = curve.program().steps();
  return Formula(
      std::vector<Formula::Step>(steps.begin(), steps.begin() + static_cast<long>(step) + 1));
}

[[noreturn]] void refuse_undefined(const ExpressionCurve& curve, const NarrowPart& part,
                                   std::size_t fault) {
  const auto& steps = curve.program().steps();
  const auto texts = step_texts(steps, curve.variable());
  const std::string place = place_on(curve, part);
  const Need need = need_of(steps[fault]);
  const std::string& name = texts[fault];
  const std::string& operand = texts[need.operand];
  const Formula f = formula_of_step(curve, need.operand);
  if (const auto at = simple_zero(curve, part, {f, f, f}); at)
    throw DomainError(fmt::format("{} is undefined at {} = {}: {} is 0 there", name,
                                  curve.variable(), to_string(*at, curve.variable()), operand));
  const auto sign_at = [&](const Rational& t) {
    return sign(values_on(curve, {t, t})[need.operand].coefficient(0));
  };
  const int before = sign_at(part.lower);
  const int after = sign_at(part.upper);
  if (need.is_positive && (before < 0 || after < 0))
    throw DomainError(
        fmt::format("{} is undefined near {}: {} is negative there", name, place, operand));
  if (before * after < 0)
    throw DomainError(
        fmt::format("{} has a pole near {}: {} changes its sign there", name, place, operand));
  throw Undecided(
      fmt::format("whether {} is defined near {} is not told within parts of 2^-40 of "
                  "the curve: {} is not told from 0",
                  name, place, operand));
}

[[noreturn]] void refuse_cusp(const ExpressionCurve& curve, const NarrowPart& part) {
  const auto at = simple_zero(curve, part, curve.derivative(1));
  if (at)
    throw DomainError(fmt::format("r' is 0 at {} = {}: a cusp", curve.variable(),
                                  to_string(*at, curve.variable())));
  throw Undecided(
      fmt::format("whether r' is 0 near {} is not told within parts of 2^-40 of the "
                  "curve",
                  place_on(curve, part)));
}

}  // namespace

std::optional<Formula> simple_zero(const ExpressionCurve& curve, const NarrowPart& part,
                                   const Vector<Formula>& of) {
  for (const Formula& place : simple_places(curve, part)) {
    FormulaProgram program;
    const auto s = program.insert(place, program.number(0));
    const bool is_zero = std::all_of(of.begin(), of.end(), [&](const Formula& f) {
      const Rational* value = program.rational(program.insert(f, s));
      return value != nullptr && *value == 0;
    });
    if (is_zero) return place;
  }
  return std::nullopt;
}

NarrowPart widened_part(const NarrowPart& part) {
  const Rational margin = Rational(64) * (part.upper - part.lower);
  return {std::max(Rational(0), Rational(part.lower - margin)),
          std::min(Rational(1), Rational(part.upper + margin))};
}

// Up to the first step that is not finite, all are continuous on the part.
void refuse_part(const ExpressionCurve& curve, const NarrowPart& narrow) {
  const NarrowPart part = widened_part(narrow);
  const auto values = values_on(curve, part);
  const auto fault = std::find_if(values.begin(), values.end(), [](const BallPolynomial& value) {
    return !value.coefficient(0).is_finite();
  });
  if (fault == values.end()) refuse_cusp(curve, part);
  refuse_undefined(curve, part, static_cast<std::size_t>(fault - values.begin()));
}

void refuse_inflection(const ExpressionCurve& curve, const NarrowPart& narrow,
                       const std::string& what) {
  const NarrowPart part = widened_part(narrow);
  const Vector<Formula> bend = cross(curve.derivative(1), curve.derivative(2));
  if (const auto at = simple_zero(curve, part, bend))
    throw DomainError(fmt::format("{}: the curvature is 0 at {} = {}", what, curve.variable(),
                                  to_string(*at, curve.variable())));
  throw Undecided(
      fmt::format("{}: whether the curvature is 0 near {} is not told within parts of 2^-40 of the "
                  "curve",
                  what, place_on(curve, part)));
}

}  // namespace phrame
