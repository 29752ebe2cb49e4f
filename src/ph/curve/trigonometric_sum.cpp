#include "phrame/ph/curve/trigonometric_sum.hpp"

#include <algorithm>
#include <vector>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {
namespace {

const Rational half(1, 2);

}  // namespace

TrigonometricSum::TrigonometricSum(const Rational& number, const Rational& pi_multiple) {
  add({}, number);
  add({1, 0, 0, 0, 0}, pi_multiple);
}

TrigonometricSum TrigonometricSum::variable() {
  TrigonometricSum x;
  x.add({0, 1, 0, 0, 0}, 1);
  return x;
}

void TrigonometricSum::add(Term term, const Rational& c) {
  const Integer halves = floor(term.turns);
  term.turns -= Rational(halves);
  Rational& sum = terms_[term];
  sum += halves % Integer(2) == 0 ? c : -c;
  if (sum == 0) terms_.erase(term);
}

/// cos(f − turned_back·π) = (e^{i…} + e^{−i…})/2.
std::optional<TrigonometricSum> TrigonometricSum::cosine(const Rational& turned_back) const {
  Term angle{0, 0, 0, -turned_back, 0};
  for (const auto& [term, c] : terms_) {
    if (term == Term{0, 1, 0, 0, 0})
      angle.frequency = c;
    else if (term == Term{1, 0, 0, 0, 0})
      angle.turns += c;
    else if (term == Term{})
      angle.phase = c;
    else
      return std::nullopt;
  }
  TrigonometricSum sum;
  sum.add(angle, half);
  sum.add({0, 0, -angle.frequency, -angle.turns, -angle.phase}, half);
  return sum;
}

std::optional<TrigonometricSum> TrigonometricSum::cosine() const { return cosine(0); }

std::optional<TrigonometricSum> TrigonometricSum::sine() const { return cosine(half); }

TrigonometricSum operator+(TrigonometricSum f, const TrigonometricSum& g) {
  for (const auto& [term, c] : g.terms_) f.add(term, c);
  return f;
}

TrigonometricSum operator-(TrigonometricSum f, const TrigonometricSum& g) {
  for (const auto& [term, c] : g.terms_) f.add(term, -c);
  return f;
}

TrigonometricSum operator*(const Rational& x, TrigonometricSum f) {
  if (x == 0) return {};
  for (auto& [term, c] : f.terms_) c *= x;
  return f;
}

TrigonometricSum operator*(const TrigonometricSum& f, const TrigonometricSum& g) {
  TrigonometricSum product;
  for (const auto& [a, c] : f.terms_)
    for (const auto& [b, d] : g.terms_)
      product.add({a.pi_power + b.pi_power, a.power + b.power, a.frequency + b.frequency,
                   a.turns + b.turns, a.phase + b.phase},
                  c * d);
  return product;
}

/// i is e^{iπ/2}.
TrigonometricSum differentiate(const TrigonometricSum& f) {
  TrigonometricSum slope;
  for (const auto& [term, c] : f.terms_) {
    TrigonometricSum::Term part = term;
    part.turns += half;
    slope.add(part, c * term.frequency);
    if (term.power == 0) continue;
    part = term;
    --part.power;
    slope.add(part, c * Rational(term.power));
  }
  return slope;
}

long TrigonometricSum::bits() const {
  long most = 0;
  for (const auto& [term, c] : terms_)
    most = std::max(
        {most, bits_of(c), bits_of(term.frequency), bits_of(term.turns), bits_of(term.phase)});
  return most;
}

bool TrigonometricArithmetic::spends(std::size_t count, const Sum& f, const Sum& g) {
  const Integer bits(f.bits() + g.bits() + 200);
  if (is_within_limit()) room_ -= Integer(count) * bits * bits;
  return is_within_limit();
}

TrigonometricSum TrigonometricArithmetic::add(const Sum& f, const Sum& g) {
  return spends(f.size() + g.size(), f, g) ? f + g : Sum();
}

TrigonometricSum TrigonometricArithmetic::subtract(const Sum& f, const Sum& g) {
  return spends(f.size() + g.size(), f, g) ? f - g : Sum();
}

TrigonometricSum TrigonometricArithmetic::multiply(const Sum& f, const Sum& g) {
  return spends(f.size() * g.size(), f, g) ? f * g : Sum();
}

TrigonometricSum TrigonometricArithmetic::dot(const Vector<Sum>& f, const Vector<Sum>& g) {
  return add(add(multiply(f[0], g[0]), multiply(f[1], g[1])), multiply(f[2], g[2]));
}

Vector<TrigonometricSum> TrigonometricArithmetic::cross(const Vector<Sum>& f,
                                                        const Vector<Sum>& g) {
  const auto part = [&](std::size_t i, std::size_t j) {
    return subtract(multiply(f[i], g[j]), multiply(f[j], g[i]));
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

std::optional<TrigonometricSum> TrigonometricArithmetic::value(const DistinctSteps& steps,
                                                               const Formula::Step& step,
                                                               const std::vector<Sum>& values,
                                                               const Sum& variable) {
  using Operation = Formula::Operation;
  switch (step.operation) {
    case Operation::number:
      return Sum(step.number, step.pi_multiple);
    case Operation::variable:
      return variable;
    case Operation::add:
      return add(values[step.left], values[step.right]);
    case Operation::multiply:
      return multiply(values[step.left], values[step.right]);
    case Operation::divide: {
      const auto& by = steps.number(step.right);
      if (!by || *by == 0) return std::nullopt;
      return multiply(values[step.left], 1 / *by);
    }
    case Operation::power: {
      if (denominator(step.number) != 1 || step.number < 0) return std::nullopt;
      Sum product(Rational(1));
      for (Integer k = 0; k < numerator(step.number) && is_within_limit(); k += 1)
        product = multiply(product, values[step.left]);
      return product;
    }
    case Operation::sin:
      return values[step.left].sine();
    case Operation::cos:
      return values[step.left].cosine();
    case Operation::exp:
    case Operation::log:
    case Operation::sqrt:
    case Operation::atan:
      break;
  }
  return std::nullopt;
}

std::optional<std::vector<TrigonometricSum>> TrigonometricArithmetic::values(
    const DistinctSteps& steps, const Sum& variable) {
  std::vector<Sum> found;
  for (std::size_t k = 0; k < steps.steps().size(); ++k) {
    const auto& number = steps.number(k);
    auto next =
        number ? std::optional(Sum(*number)) : value(steps, steps.steps()[k], found, variable);
    if (!next) return std::nullopt;
    found.push_back(*std::move(next));
  }
  return found;
}

}  // namespace phrame
