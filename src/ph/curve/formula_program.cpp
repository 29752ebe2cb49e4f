#include "phrame/ph/curve/formula_program.hpp"

#include <algorithm>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

namespace {

/// Of numbers that exact ones are made of.
constexpr long most_exact_bits = 10'000;
/// Each new one is compared with them.
constexpr std::size_t most_constants = 256;

}  // namespace

using StepId = FormulaProgram::Id;

StepId FormulaProgram::step(Step step) {
  if (const auto known = ids_.find(step); known != ids_.end()) return known->second;
  if (const auto equal = known_constant(step)) return *equal;
  ids_.emplace(step, steps_.size());
  steps_.push_back(std::move(step));
  return steps_.size() - 1;
}

/// The step that has its value already; else what that is, is kept for the step that comes next.
std::optional<StepId> FormulaProgram::known_constant(const Step& step) {
  if (step.operation == Operation::number || step.operation == Operation::variable)
    return std::nullopt;
  const bool has_two = step.operation == Operation::add || step.operation == Operation::multiply ||
                       step.operation == Operation::divide;
  const auto left = constant(step.left);
  const auto right = left ? constant(has_two ? step.right : step.left) : std::nullopt;
  const auto value = right ? phrame::apply(step, *left, *right) : std::nullopt;
  if (!value) return std::nullopt;
  if (value->plain.is_rational() && value->of_pi.is_rational())
    return number(value->plain.rational_part(), value->of_pi.rational_part());
  for (const auto& [id, known] : constants_)
    if (known == *value) return id;
  if (constants_.size() < most_constants) constants_.emplace(steps_.size(), *value);
  return std::nullopt;
}

std::optional<FormulaConstant> FormulaProgram::constant(StepId a) const {
  if (is_number(a)) return FormulaConstant{steps_[a].number, steps_[a].pi_multiple};
  const auto known = constants_.find(a);
  return known == constants_.end() ? std::nullopt : std::optional(known->second);
}

StepId FormulaProgram::number(Rational rational, Rational pi_multiple) {
  return step({Operation::number, 0, 0, std::move(rational), std::move(pi_multiple)});
}

const Rational* FormulaProgram::rational(StepId a) const {
  const bool is_rational = is_number(a) && steps_[a].pi_multiple == 0;
  return is_rational ? &steps_[a].number : nullptr;
}

bool FormulaProgram::is_short_number(StepId a) const {
  return is_number(a) &&
         bits_of(steps_[a].number) + bits_of(steps_[a].pi_multiple) < most_exact_bits;
}

std::pair<Rational, StepId> FormulaProgram::split_factor(StepId a) const {
  const Step& step = steps_[a];
  if (step.operation != Operation::multiply) return {1, a};
  const Rational* c = rational(step.left);
  return c != nullptr ? std::pair(*c, step.right) : std::pair(Rational(1), a);
}

StepId FormulaProgram::add(StepId a, StepId b) {
  if (is_short_number(a) && is_short_number(b))
    return number(steps_[a].number + steps_[b].number,
                  steps_[a].pi_multiple + steps_[b].pi_multiple);
  const auto is_zero = [&](StepId x) { return rational(x) != nullptr && rational(x)->sign() == 0; };
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  const auto [p, x] = split_factor(a);
  const auto [q, y] = split_factor(b);
  if (x == y) return multiply(number(p + q), x);
  return step({Operation::add, std::min(a, b), std::max(a, b), 0, 0});
}

/// c·(x/y)·d·y = cd·x: that it is defined is seen at the quotient.
std::optional<StepId> FormulaProgram::without_denominator(StepId quotient, StepId factor) {
  const auto [c, x] = split_factor(quotient);
  const auto [d, y] = split_factor(factor);
  if (steps_[x].operation != Operation::divide || steps_[x].right != y) return std::nullopt;
  return multiply(number(c * d), steps_[x].left);
}

StepId FormulaProgram::multiply(StepId a, StepId b) {
  if (rational(b) != nullptr) std::swap(a, b);
  const Rational* known = rational(a);
  if (known == nullptr)
    for (const auto& [quotient, factor] : {std::pair(a, b), std::pair(b, a)})
      if (const auto cancelled = without_denominator(quotient, factor)) return *cancelled;
  if (known == nullptr) return step({Operation::multiply, std::min(a, b), std::max(a, b), 0, 0});
  const Rational c = *known;  // not the step, which moves when there are more
  if (is_short_number(a) && is_short_number(b))
    return number(c * steps_[b].number, c * steps_[b].pi_multiple);
  if (c == 0) return a;
  if (c == 1) return b;
  const auto [d, x] = split_factor(b);
  if (d != 1 && is_short_number(a) && bits_of(d) < most_exact_bits)
    return multiply(number(c * d), x);
  return step({Operation::multiply, a, b, 0, 0});
}

StepId FormulaProgram::divide(StepId a, StepId b) {
  const Rational* c = rational(b);
  if (c != nullptr && *c != 0 && is_short_number(b)) return multiply(number(Rational(1) / *c), a);
  if (c == nullptr && rational(a) != nullptr && *rational(a) == 0) {
    step({Operation::divide, a, b, 0, 0});  // whether it is defined is seen there
    return a;
  }
  const auto is_turn = [&](StepId x) { return is_number(x) && steps_[x].number == 0; };
  if (c == nullptr && is_turn(a) && is_turn(b))
    return number(steps_[a].pi_multiple / steps_[b].pi_multiple);
  return step({Operation::divide, a, b, 0, 0});
}

StepId FormulaProgram::power(StepId a, const Rational& exponent) {
  constexpr long most_exact = 100;
  if (exponent == 1) return a;
  if (exponent == 0) return number(1);
  const Rational* base = rational(a);
  const bool is_short =
      is_short_number(a) && denominator(exponent) == 1 && abs(exponent) <= most_exact;
  if (base != nullptr && is_short && (*base != 0 || exponent > 0)) {
    const Rational x = exponent.sign() < 0 ? Rational(1) / *base : *base;
    Rational product = 1;
    for (long k = static_cast<long>(numerator(abs(exponent))); k > 0; --k) product *= x;
    return number(product);
  }
  return step({Operation::power, a, 0, exponent, 0});
}

// sin(α + (β + n)π) = (−1)ⁿ sin(α + βπ), and sin(π − x) = sin x.
StepId FormulaProgram::sin(StepId a) {
  if (!is_number(a)) return function(Operation::sin, a);
  const Rational alpha = steps_[a].number;
  Rational beta = steps_[a].pi_multiple;
  const Integer turns = floor(beta);
  beta -= turns;
  const bool is_odd = turns % Integer(2) != Integer(0);
  if (alpha == 0 && beta > Rational(1, 2)) beta = Rational(1) - beta;
  StepId value = 0;
  if (alpha == 0 && beta == 0)
    value = number(0);
  else if (alpha == 0 && beta == Rational(1, 6))
    value = number(Rational(1, 2));
  else if (alpha == 0 && beta == Rational(1, 2))
    value = number(1);
  else
    value = function(Operation::sin, number(alpha, beta));
  return is_odd ? negative(value) : value;
}

StepId FormulaProgram::cos(StepId a) {
  if (!is_number(a)) return function(Operation::cos, a);
  return sin(number(steps_[a].number, steps_[a].pi_multiple + Rational(1, 2)));
}

StepId FormulaProgram::exp(StepId a) {
  const Rational* x = rational(a);
  return x != nullptr && *x == 0 ? number(1) : function(Operation::exp, a);
}

StepId FormulaProgram::log(StepId a) {
  const Rational* x = rational(a);
  return x != nullptr && *x == 1 ? number(0) : function(Operation::log, a);
}

StepId FormulaProgram::sqrt(StepId a) {
  const Rational* x = rational(a);
  if (x != nullptr)
    if (const auto root = square_root(*x); root) return number(*root);
  return function(Operation::sqrt, a);
}

StepId FormulaProgram::atan(StepId a) {
  const Rational* x = rational(a);
  if (x != nullptr && (*x == 0 || abs(*x) == 1)) return number(0, *x / 4);
  return function(Operation::atan, a);
}

StepId FormulaProgram::apply(const Step& step, StepId left, StepId right, StepId s) {
  switch (step.operation) {
    case Operation::number:
      return number(step.number, step.pi_multiple);
    case Operation::variable:
      return s;
    case Operation::add:
      return add(left, right);
    case Operation::multiply:
      return multiply(left, right);
    case Operation::divide:
      return divide(left, right);
    case Operation::power:
      return power(left, step.number);
    case Operation::sin:
      return sin(left);
    case Operation::cos:
      return cos(left);
    case Operation::exp:
      return exp(left);
    case Operation::log:
      return log(left);
    case Operation::sqrt:
      return sqrt(left);
    case Operation::atan:
      return atan(left);
  }
  return s;
}

std::vector<StepId> FormulaProgram::insert_steps(const Formula& f, StepId s) {
  std::vector<StepId> ids;
  for (const Step& step : f.steps()) {
    const StepId left = ids.empty() ? 0 : ids[step.left];    // of a number, any
    const StepId right = ids.empty() ? 0 : ids[step.right];  // likewise
    ids.push_back(apply(step, left, right, s));
  }
  return ids;
}

StepId FormulaProgram::rule_of_derivative(const Step& f, StepId self,
                                          const std::vector<StepId>& of) {
  const auto times = [&](StepId a, StepId b) { return multiply(a, b); };
  switch (f.operation) {
    case Operation::number:
      return number(0);
    case Operation::variable:
      return number(1);
    case Operation::add:
      return add(of[f.left], of[f.right]);
    case Operation::multiply:
      return add(times(of[f.left], f.right), times(f.left, of[f.right]));
    case Operation::divide:
      return divide(subtract(of[f.left], times(self, of[f.right])), f.right);
    case Operation::power:
      return times(times(number(f.number), power(f.left, f.number - 1)), of[f.left]);
    case Operation::sin:
      return times(cos(f.left), of[f.left]);
    case Operation::cos:
      return negative(times(sin(f.left), of[f.left]));
    case Operation::exp:
      return times(self, of[f.left]);
    case Operation::log:
      return divide(of[f.left], f.left);
    case Operation::sqrt:
      return divide(of[f.left], times(number(2), self));
    case Operation::atan:
      return divide(of[f.left], add(number(1), power(f.left, 2)));
  }
  return number(0);
}

StepId FormulaProgram::derivative(StepId f) {
  std::vector<StepId> derivatives;
  for (StepId k = 0; k <= f; ++k) {
    const Step step = steps_[k];  // the list grows
    derivatives.push_back(rule_of_derivative(step, k, derivatives));
  }
  return derivatives.back();
}

Formula derivative(const Formula& f) {
  FormulaProgram program;
  const StepId slope = program.derivative(program.insert(f, program.variable()));
  return Formula({program.steps().begin(), program.steps().begin() + static_cast<long>(slope) + 1});
}

std::optional<Rational> rational_value(const Formula& f, const Rational& s) {
  FormulaProgram program;
  const Rational* value = program.rational(program.insert(f, program.number(s)));
  return value == nullptr ? std::nullopt : std::optional(*value);
}

}  // namespace phrame
