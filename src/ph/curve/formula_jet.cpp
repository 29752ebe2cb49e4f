#include "phrame/ph/curve/formula_jet.hpp"

#include <set>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {
namespace {

using Operation = Formula::Operation;

bool has_two_operands(Operation operation) {
  return operation == Operation::add || operation == Operation::multiply ||
         operation == Operation::divide;
}

constexpr long most_folded_bits = 4096;  // of numbers that numbers are made of

}  // namespace

std::size_t DistinctSteps::insert(const Formula& f) {
  std::vector<std::size_t> ids;
  for (Step step : f.steps()) {
    const bool is_leaf =
        step.operation == Operation::number || step.operation == Operation::variable;
    step.left = is_leaf ? 0 : ids[step.left];
    step.right = has_two_operands(step.operation) ? ids[step.right] : 0;
    const auto [known, is_new] = known_.emplace(step, steps_.size());
    ids.push_back(known->second);
    if (!is_new) continue;
    numbers_.push_back(number_of(step));
    steps_.push_back(std::move(step));
  }
  return ids.back();
}

std::optional<Rational> DistinctSteps::number_of(const Step& step) const {
  if (step.operation == Operation::number)
    return step.pi_multiple == 0 ? std::optional(step.number) : std::nullopt;
  if (step.operation == Operation::variable) return std::nullopt;
  const std::optional<Rational>& a = numbers_[step.left];
  if (!a) return std::nullopt;
  if (step.operation == Operation::power) {
    const Rational& k = step.number;
    if (denominator(k) != 1 || k < 0 || k * bits_of(*a) > most_folded_bits) return std::nullopt;
    const auto n = static_cast<unsigned long>(static_cast<long>(numerator(k)));
    return Rational(pow(numerator(*a), n), pow(denominator(*a), n));
  }
  if (!has_two_operands(step.operation)) return std::nullopt;
  const std::optional<Rational>& b = numbers_[step.right];
  if (!b || bits_of(*a) + bits_of(*b) > most_folded_bits) return std::nullopt;
  if (step.operation == Operation::add) return *a + *b;
  if (step.operation == Operation::multiply) return *a * *b;
  return *b == 0 ? std::nullopt : std::optional(*a / *b);
}

FormulaWork work_of(const DistinctSteps& steps) {
  FormulaWork work;
  const auto add = [&](long series, long products) {
    work.series += series;
    work.products += products;
  };
  std::set<std::size_t> angles;
  for (std::size_t k = 0; k < steps.steps().size(); ++k) {
    const Formula::Step& step = steps.steps()[k];
    if (steps.number(k)) continue;
    switch (step.operation) {
      case Operation::number:
      case Operation::variable:
      case Operation::add:
        break;
      case Operation::multiply:
        if (!steps.number(step.left) && !steps.number(step.right)) add(0, 1);
        break;
      case Operation::power:
        if (denominator(step.number) != 1) add(3, 2);
        if (step.number.sign() < 0) add(1, 1);
        add(0, 2 * bit_length(numerator(step.number)));
        break;
      case Operation::sin:
      case Operation::cos:
        if (angles.insert(step.left).second) add(2, 2);
        break;
      case Operation::atan:
        add(4, 2);
        break;
      case Operation::sqrt:
      case Operation::log:
        add(2, 1);
        break;
      default:
        add(1, 1);
    }
  }
  return work;
}

ModelJet FormulaJets::of(const Formula& f) {
  const std::size_t id = steps_.insert(f);
  while (jets_.size() < steps_.steps().size()) {
    const std::size_t k = jets_.size();
    const auto& x = steps_.number(k);
    jets_.push_back(x ? number(*x) : jet_of(steps_.steps()[k]));
  }
  return jets_[id];
}

ModelJet FormulaJets::jet_of(const Step& step) {
  const auto left = [&]() -> const ModelJet& { return jets_[step.left]; };
  const auto right = [&]() -> const ModelJet& { return jets_[step.right]; };
  switch (step.operation) {
    case Operation::number: {
      ModelJet jet = number(step.number);
      jet[0] = models_.add(jet[0], models_.multiply(step.pi_multiple, models_.pi()));
      return jet;
    }
    case Operation::variable:
      return variable_;
    case Operation::add:
      return sum(left(), right());
    case Operation::multiply:
      if (const auto& x = steps_.number(step.left)) return each(right(), *x);
      if (const auto& x = steps_.number(step.right)) return each(left(), *x);
      return product(left(), right());
    case Operation::divide:
      return quotient(left(), right());
    case Operation::power:
      return power(left(), step.number);
    case Operation::sin:
    case Operation::cos:
      return turned(step);
    case Operation::exp:
      return exp(left());
    case Operation::log:
      return by_slope(models_.log(left()[0]), left(), left());
    case Operation::sqrt:
      return sqrt(left());
    case Operation::atan:
      return by_slope(models_.atan(left()[0]), left(), sum(product(left(), left()), number(1)));
  }
  return {};
}

/// C′ = −a′S, S′ = a′C.
ModelJet FormulaJets::turned(const Step& step) {
  const ModelJet& a = jets_[step.left];
  auto [cos, sin] = models_.cos_sin(a[0]);
  ModelJet C(a.size());
  ModelJet S(a.size());
  C[0] = std::move(cos);
  S[0] = std::move(sin);
  const auto weight = [](std::size_t j) { return j; };
  for (std::size_t k = 1; k < a.size(); ++k) {
    const TaylorModel c = sum_of(k, a, S, weight);
    S[k] = models_.multiply(Rational(1, static_cast<long>(k)), sum_of(k, a, C, weight));
    C[k] = models_.multiply(Rational(-1, static_cast<long>(k)), c);
  }
  return step.operation == Operation::cos ? C : S;
}

ModelJet FormulaJets::number(const Rational& x) const {
  ModelJet jet(variable_.size());
  jet[0] = models_.number(x);
  return jet;
}

ModelJet FormulaJets::each(const ModelJet& a, const Rational& by) const {
  ModelJet out;
  for (const TaylorModel& x : a) out.push_back(models_.multiply(by, x));
  return out;
}

/// Σ weight(j)·aⱼ·b_{k−j}.
template <class Weight>
TaylorModel FormulaJets::sum_of(std::size_t k, const ModelJet& a, const ModelJet& b,
                                Weight weight) const {
  TaylorModel total;
  for (std::size_t j = 0; j <= k; ++j)
    if (const auto by = static_cast<long>(weight(j)); by != 0)
      total = models_.add(total, models_.multiply(by, models_.multiply(a[j], b[k - j])));
  return total;
}

/// first, next(1, so far), …
template <class Next>
ModelJet FormulaJets::recursive(TaylorModel first, const Next& next) const {
  ModelJet out(variable_.size());
  out[0] = std::move(first);
  for (std::size_t k = 1; k < out.size(); ++k) out[k] = next(k, out);
  return out;
}

ModelJet FormulaJets::sum(const ModelJet& a, const ModelJet& b) const {
  ModelJet out;
  for (std::size_t k = 0; k < a.size(); ++k) out.push_back(models_.add(a[k], b[k]));
  return out;
}

ModelJet FormulaJets::product(const ModelJet& a, const ModelJet& b) const {
  ModelJet out;
  for (std::size_t k = 0; k < a.size(); ++k)
    out.push_back(sum_of(k, a, b, [](std::size_t) { return 1; }));
  return out;
}

/// b·q = a.
ModelJet FormulaJets::quotient(const ModelJet& a, const ModelJet& b) const {
  const TaylorModel inverse = models_.inverse(b[0]);
  return recursive(models_.multiply(a[0], inverse), [&](std::size_t k, const ModelJet& q) {
    return models_.multiply(
        inverse,
        models_.subtract(a[k], sum_of(k, q, b, [k](std::size_t j) { return j < k ? 1 : 0; })));
  });
}

/// R·R = a.
ModelJet FormulaJets::sqrt(const ModelJet& a) const {
  TaylorModel first = models_.sqrt(a[0]);
  const TaylorModel inverse = models_.inverse(first);
  return recursive(std::move(first), [&](std::size_t k, const ModelJet& R) {
    const TaylorModel rest = sum_of(k, R, R, [k](std::size_t j) { return j > 0 && j < k ? 1 : 0; });
    return models_.multiply(Rational(1, 2),
                            models_.multiply(inverse, models_.subtract(a[k], rest)));
  });
}

/// E′ = a′E.
ModelJet FormulaJets::exp(const ModelJet& a) const {
  return recursive(models_.exp(a[0]), [&](std::size_t k, const ModelJet& E) {
    return models_.multiply(Rational(1, static_cast<long>(k)),
                            sum_of(k, a, E, [](std::size_t j) { return j; }));
  });
}

/// L with L′w = a′.
ModelJet FormulaJets::by_slope(TaylorModel first, const ModelJet& a, const ModelJet& w) const {
  const TaylorModel inverse = models_.inverse(w[0]);
  return recursive(std::move(first), [&](std::size_t k, const ModelJet& L) {
    const TaylorModel rest = sum_of(k, L, w, [k](std::size_t j) { return j < k ? j : 0; });
    return models_.multiply(
        inverse, models_.subtract(a[k], models_.multiply(Rational(1, static_cast<long>(k)), rest)));
  });
}

/// By squares from the first bit on; with a fraction for exponent exp(k·log a).
ModelJet FormulaJets::power(const ModelJet& a, const Rational& k) const {
  if (denominator(k) != 1) return exp(each(by_slope(models_.log(a[0]), a, a), k));
  const auto n = static_cast<unsigned long>(static_cast<long>(numerator(abs(k))));
  ModelJet all = n == 0 ? number(1) : a;
  unsigned long bit = 1;
  while (bit <= n / 2) bit *= 2;
  for (bit /= 2; bit > 0; bit /= 2) {
    all = product(all, all);
    if ((n & bit) != 0) all = product(all, a);
  }
  return k.sign() >= 0 ? all : quotient(number(1), all);
}

}  // namespace phrame
