#pragma once
#include <map>

#include "phrame/algebra/taylor_model.hpp"
#include "phrame/ph/curve/formula.hpp"

namespace phrame::inline v0 {

/// f₀, f₁, … of a function f(z, x) = Σ fⱼ(z)·xʲ, up to some j: for t = m + hz + x the fⱼ are the
/// derivatives of f by t, over j!.
using ModelJet = std::vector<TaylorModel>;

/// The steps of formulas of one variable, each once.
class DistinctSteps {
 public:
  using Step = Formula::Step;

  /// The number of the step that is f.
  std::size_t insert(const Formula& f);

  const std::vector<Step>& steps() const { return steps_; }
  /// The value of a step that is a number by numbers alone, as long as these are short.
  const std::optional<Rational>& number(std::size_t step) const { return numbers_[step]; }

 private:
  std::optional<Rational> number_of(const Step& step) const;

  std::vector<Step> steps_;
  std::vector<std::optional<Rational>> numbers_;
  std::map<Step, std::size_t> known_;
};

/// How much it is to find their jets: so many series of models, and products of jets. Sine and
/// cosine of one angle are one function.
struct FormulaWork {
  Integer series = 0;
  Integer products = 0;
};
FormulaWork work_of(const DistinctSteps& steps);

/// The jets of formulas of one variable.
class FormulaJets {
 public:
  /// Precondition: none of the formulas has a variable, or that has this jet, of at least one
  /// model.
  FormulaJets(const TaylorModels& models, ModelJet variable)
      : models_(models), variable_(std::move(variable)) {}

  /// Throws Undecided as TaylorModels.
  ModelJet of(const Formula& f);

 private:
  using Step = Formula::Step;
  ModelJet jet_of(const Step& step);
  ModelJet turned(const Step& step);

  ModelJet number(const Rational& x) const;
  ModelJet each(const ModelJet& a, const Rational& by) const;
  template <class Weight>
  TaylorModel sum_of(std::size_t k, const ModelJet& a, const ModelJet& b, Weight weight) const;
  template <class Next>
  ModelJet recursive(TaylorModel first, const Next& next) const;
  ModelJet sum(const ModelJet& a, const ModelJet& b) const;
  ModelJet product(const ModelJet& a, const ModelJet& b) const;
  ModelJet quotient(const ModelJet& a, const ModelJet& b) const;
  ModelJet sqrt(const ModelJet& a) const;
  ModelJet exp(const ModelJet& a) const;
  ModelJet by_slope(TaylorModel first, const ModelJet& a, const ModelJet& w) const;
  ModelJet power(const ModelJet& a, const Rational& k) const;

  TaylorModels models_;
  ModelJet variable_;
  DistinctSteps steps_;
  std::vector<ModelJet> jets_;  ///< of the first of these
};

}  // namespace phrame
