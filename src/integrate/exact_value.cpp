#include "phrame/integrate/exact_value.hpp"

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/integrate/log_change.hpp"

namespace phrame::inline v0 {

ExactValue exact_value(const Rational& x) { return {x, 0, {}, {}}; }

bool is_rational(const ExactValue& x) { return x == exact_value(x.rational); }

std::optional<ExactValue> sum_of(const std::vector<ExactValue>& values) {
  Rational rational = 0;
  LogChange change;
  std::optional<RealAlgebraic> irrational_pi;
  for (const ExactValue& x : values) {
    if (x.irrational_pi && irrational_pi) return std::nullopt;
    if (x.irrational_pi) irrational_pi = x.irrational_pi;
    rational += x.rational;
    change.turns.push_back({{{-1, 0}, x.pi}, 0});
    for (const auto& [factor, of] : x.logarithms) change.sizes.push_back({{of, 0}, factor});
    for (const auto& [factor, of] : x.arctangents) change.turns.push_back({{{1, of}, factor}, 0});
  }
  return exact_value(rational, change, irrational_pi.value_or(RealAlgebraic(0)));
}

ExactValue operator+(const ExactValue& a, const ExactValue& b) {
  auto sum = sum_of({a, b});
  if (!sum) throw DomainError("ExactValue: a sum of two irrational multiples of π");
  return *std::move(sum);
}

ExactValue operator*(const Rational& c, const ExactValue& x) {
  if (c == 0) return {};
  ExactValue result = x;
  result.rational *= c;
  result.pi *= c;
  for (auto* terms : {&result.logarithms, &result.arctangents})
    for (ExactValue::Term& term : *terms) term.factor *= c;
  if (x.irrational_pi) result.irrational_pi = affine(*x.irrational_pi, c, 0);
  return result;
}

}  // namespace phrame
