#pragma once
#include <map>

#include "phrame/ph/curve/formula_constant.hpp"

namespace phrame::inline v0 {

/// Several expressions of one variable as one list of steps, in which no value is found twice, and
/// constants are exact where they are seen to be: sums and multiples of α + βπ with sums α and β of
/// square roots, as FormulaConstant knows them, and the sines and cosines of such with fractions α
/// and β, of which sin(βπ + α) is brought to one form, with β ∈ [0, 1), so that what is periodic
/// has the same step at both ends of a period. Two values of one step are equal; those of different
/// steps may be.
///
/// Products with 0 are 0, whatever the other factor: that it is defined is seen by evaluating all
/// steps.
class FormulaProgram {
 public:
  using Step = Formula::Step;            ///< of which the list is
  using Operation = Formula::Operation;  ///< of a step
  using Id = std::size_t;                ///< a step

  /// Operands before what is made of them.
  const std::vector<Step>& steps() const { return steps_; }

  /// @{ The step with this value, a new one where there is none.
  Id number(Rational rational, Rational pi_multiple = 0);
  Id variable() { return step({Operation::variable, 0, 0, 0, 0}); }
  Id add(Id a, Id b);
  Id subtract(Id a, Id b) { return add(a, negative(b)); }
  Id negative(Id a) { return multiply(number(-1), a); }
  Id multiply(Id a, Id b);
  Id divide(Id a, Id b);
  Id power(Id a, const Rational& exponent);
  Id sin(Id a);
  Id cos(Id a);
  Id exp(Id a);
  Id log(Id a);
  Id sqrt(Id a);
  Id atan(Id a);
  /// @}
  /// f at the value s of its variable.
  Id insert(const Formula& f, Id s) { return insert_steps(f, s).back(); }
  /// The same of each step of f.
  std::vector<Id> insert_steps(const Formula& f, Id s);
  /// The derivative of f by the variable.
  Id derivative(Id f);

  /// Its rational value, where it is one of these by its form.
  const Rational* rational(Id a) const;
  /// Its value as a FormulaConstant, likewise.
  std::optional<FormulaConstant> constant(Id a) const;

 private:
  Id step(Step step);
  std::optional<Id> known_constant(const Step& step);
  std::optional<Id> without_denominator(Id quotient, Id factor);
  Id apply(const Step& step, Id left, Id right, Id s);
  Id function(Operation operation, Id a) { return step({operation, a, 0, 0, 0}); }
  bool is_number(Id a) const { return steps_[a].operation == Operation::number; }
  /// One that others may be made of exactly: no tower of products grows out of hand.
  bool is_short_number(Id a) const;
  /// The factor c of c·x, c rational, and x.
  std::pair<Rational, Id> split_factor(Id a) const;
  Id rule_of_derivative(const Step& f, Id self, const std::vector<Id>& of);

  std::vector<Step> steps_;
  std::map<Step, Id> ids_;
  std::map<Id, FormulaConstant> constants_;  ///< of steps that are no numbers, all different
};

/// df/ds.
Formula derivative(const Formula& f);

/// f(s), where its form shows a fraction.
std::optional<Rational> rational_value(const Formula& f, const Rational& s = 0);

}  // namespace phrame
