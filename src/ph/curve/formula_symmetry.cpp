#include "phrame/ph/curve/formula_symmetry.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "phrame/ph/curve/formula_program.hpp"

namespace phrame::inline v0 {
namespace {

using SymmetryOperation = Formula::Operation;

/// The symmetry of each step of a formula, from the first one on.
class StepSymmetries {
 public:
  StepSymmetries(const Formula& f, const Formula& c)
      : steps_(f.steps()),
        at_center_(program_.insert_steps(f, program_.insert(c, program_.number(0)))) {}

  FormulaSymmetry run() {
    for (const Formula::Step& step : steps_) found_.push_back(of_step(step));
    return found_.back();
  }

 private:
  FormulaSymmetry of_step(const Formula::Step& step) const;
  static FormulaSymmetry of_sum(FormulaSymmetry f, FormulaSymmetry g);
  FormulaSymmetry of_product(std::size_t left, std::size_t right) const;
  FormulaSymmetry of_power(std::size_t base, const Rational& exponent) const;
  FormulaSymmetry of_sine(std::size_t angle, const Rational& phase) const;
  const Formula::Step& value_at_center(std::size_t k) const {
    return program_.steps()[at_center_[k]];
  }
  bool is_odd(std::size_t k) const;

  const std::vector<Formula::Step>& steps_;
  FormulaProgram program_;
  std::vector<FormulaProgram::Id> at_center_;  ///< the value of each step at c
  std::vector<FormulaSymmetry> found_;         ///< of the steps before
};

bool StepSymmetries::is_odd(std::size_t k) const {
  const Rational* value = program_.rational(at_center_[k]);
  return found_[k] == FormulaSymmetry::skew && value != nullptr && *value == 0;
}

FormulaSymmetry StepSymmetries::of_sum(FormulaSymmetry f, FormulaSymmetry g) {
  if (f == FormulaSymmetry::constant) return g;
  return g == FormulaSymmetry::constant || f == g ? f : FormulaSymmetry::unknown;
}

FormulaSymmetry StepSymmetries::of_product(std::size_t left, std::size_t right) const {
  const FormulaSymmetry f = found_[left];
  const FormulaSymmetry g = found_[right];
  if (f == FormulaSymmetry::constant) return g;
  if (g == FormulaSymmetry::constant) return f;
  const bool f_is_even = f == FormulaSymmetry::even;
  const bool g_is_even = g == FormulaSymmetry::even;
  if ((!f_is_even && !is_odd(left)) || (!g_is_even && !is_odd(right)))
    return FormulaSymmetry::unknown;
  return f_is_even == g_is_even ? FormulaSymmetry::even : FormulaSymmetry::skew;
}

// What is divided by an odd function is undefined at c.
FormulaSymmetry StepSymmetries::of_power(std::size_t base, const Rational& exponent) const {
  if (found_[base] != FormulaSymmetry::skew) return found_[base];
  if (denominator(exponent) != 1 || exponent.sign() <= 0 || !is_odd(base))
    return FormulaSymmetry::unknown;
  return numerator(exponent) % Integer(2) == 0 ? FormulaSymmetry::even : FormulaSymmetry::skew;
}

// Of sin(f + phase·π): sin(kπ + x) = ±sin x is odd, and sin(kπ + π/2 + x) = ±cos x even.
FormulaSymmetry StepSymmetries::of_sine(std::size_t angle, const Rational& phase) const {
  if (found_[angle] != FormulaSymmetry::skew) return found_[angle];
  const Formula::Step& value = value_at_center(angle);
  if (value.operation != SymmetryOperation::number || value.number != 0)
    return FormulaSymmetry::unknown;
  const Rational turns = value.pi_multiple + phase;
  if (denominator(turns) == 1) return FormulaSymmetry::skew;
  return denominator(turns) == 2 ? FormulaSymmetry::even : FormulaSymmetry::unknown;
}

FormulaSymmetry StepSymmetries::of_step(const Formula::Step& step) const {
  switch (step.operation) {
    case SymmetryOperation::number:
      return FormulaSymmetry::constant;
    case SymmetryOperation::variable:
      return FormulaSymmetry::skew;
    case SymmetryOperation::add:
      return of_sum(found_[step.left], found_[step.right]);
    case SymmetryOperation::multiply:
      return of_product(step.left, step.right);
    case SymmetryOperation::divide:
      return found_[step.right] == FormulaSymmetry::skew ? FormulaSymmetry::unknown
                                                         : of_product(step.left, step.right);
    case SymmetryOperation::power:
      return of_power(step.left, step.number);
    case SymmetryOperation::sin:
      return of_sine(step.left, 0);
    case SymmetryOperation::cos:
      return of_sine(step.left, Rational(1, 2));
    case SymmetryOperation::atan:
      if (is_odd(step.left)) return FormulaSymmetry::skew;
      break;
    case SymmetryOperation::exp:
    case SymmetryOperation::log:
    case SymmetryOperation::sqrt:
      break;
  }
  const FormulaSymmetry f = found_[step.left];
  return f == FormulaSymmetry::skew ? FormulaSymmetry::unknown : f;
}

}  // namespace

FormulaSymmetry symmetry_about(const Formula& f, const Formula& c) {
  return StepSymmetries(f, c).run();
}

bool is_turned_over_by_half_turn(const ExpressionCurve& curve, const Vector<Rational>& v) {
  const Formula middle = Formula(Rational(1, 2)) * (curve.from() + curve.to());
  std::array<FormulaSymmetry, 3> found{};
  for (std::size_t k = 0; k < 3; ++k) found[k] = symmetry_about(curve.position()[k], middle);
  const auto is = [&](std::size_t k, FormulaSymmetry which) {
    return found[k] == which || found[k] == FormulaSymmetry::constant;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t j = (axis + 1) % 3;
    const std::size_t k = (axis + 2) % 3;
    if (v[axis] != 0 && (v[j] != 0 || v[k] != 0)) continue;
    if (is(axis, FormulaSymmetry::even) && is(j, FormulaSymmetry::skew) &&
        is(k, FormulaSymmetry::skew))
      return true;
  }
  return false;
}

}  // namespace phrame
