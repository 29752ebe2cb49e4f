#include "phrame/ph/curve/rational_form.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/sturm.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long most_degree = 400;
constexpr long most_bits = 1L << 17;  // of a coefficient

long degree_of(const RationalFunction& f) {
  return std::max(f.numerator().degree(), f.denominator().degree());
}

/// Of its longest coefficient.
long size_of(const RationalFunction& f) {
  long bits = 0;
  for (const Polynomial* p : {&f.numerator(), &f.denominator()})
    for (long k = 0; k <= p->degree(); ++k) bits = std::max(bits, bits_of(p->coefficient(k)));
  return bits;
}

std::optional<RationalFunction> inverse_of(const RationalFunction& f) {
  if (f.is_zero()) return std::nullopt;
  return RationalFunction(f.denominator(), f.numerator());
}

std::optional<RationalFunction> power_of(const RationalFunction& f, const Rational& exponent) {
  if (denominator(exponent) != 1) return std::nullopt;
  if (degree_of(f) * abs(exponent) > most_degree || abs(exponent) > most_degree)
    return std::nullopt;
  if (size_of(f) * abs(exponent) > most_bits) return std::nullopt;
  const auto n = static_cast<long>(numerator(abs(exponent)));
  const RationalFunction power(pow(f.numerator(), n), pow(f.denominator(), n));
  return exponent.sign() < 0 ? inverse_of(power) : power;
}

/// A step, where it is a rational function of values that are.
std::optional<RationalFunction> value_of_step(const Formula::Step& step,
                                              const std::vector<RationalFunction>& values) {
  using Operation = Formula::Operation;
  const auto left = [&]() -> const RationalFunction& { return values[step.left]; };
  const auto right = [&]() -> const RationalFunction& { return values[step.right]; };
  switch (step.operation) {
    case Operation::number:
      if (step.pi_multiple != 0) return std::nullopt;
      return RationalFunction(Polynomial{step.number});
    case Operation::variable:
      return RationalFunction(Polynomial{0, 1});
    case Operation::add:
      return left() + right();
    case Operation::multiply:
      return left() * right();
    case Operation::divide:
      if (const auto inverse = inverse_of(right())) return left() * *inverse;
      return std::nullopt;
    case Operation::power:
      return power_of(left(), step.number);
    default:
      return std::nullopt;
  }
}

std::optional<RationalFunction> rational_function(const Formula& f) {
  std::vector<RationalFunction> values;
  for (const Formula::Step& step : f.steps()) {
    auto value = value_of_step(step, values);
    if (!value || degree_of(*value) > most_degree || size_of(*value) > most_bits)
      return std::nullopt;
    values.push_back(*std::move(value));
  }
  return values.back();
}

std::optional<Rational> rational_number(const Formula& f) {
  const auto value = rational_function(f);
  return value ? constant(*value) : std::nullopt;
}

void require_no_pole(const RationalFunction& f, const Interval& way, char name,
                     const std::string& variable) {
  if (f.denominator().is_constant() || count_real_roots(f.denominator(), way) == 0) return;
  const RealAlgebraic first = real_roots(f.denominator(), way).front().at;
  throw DomainError(fmt::format("{} has a pole at {}", name, place_text(variable, first)));
}

}  // namespace

std::optional<RationalCurve> rational_form(const Vector<Formula>& position, const Formula& from,
                                           const Formula& to, const std::string& variable) {
  const auto a = rational_number(from);
  const auto b = rational_number(to);
  if (!a || !b || *a == *b) return std::nullopt;
  Vector<RationalFunction> r;
  Polynomial weight{1};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto f = rational_function(position[k]);
    if (!f) return std::nullopt;
    require_no_pole(*f, closed_interval(std::min(*a, *b), std::max(*a, *b)), "xyz"[k], variable);
    r[k] = compose(*f, Polynomial{*a, *b - *a});
    weight = lcm(weight, r[k].denominator());
  }
  if (weight.degree() > most_degree) return std::nullopt;
  Vector<Polynomial> numerator;
  for (std::size_t k = 0; k < 3; ++k)
    numerator[k] = r[k].numerator() * exact_quotient(weight, r[k].denominator());
  return RationalCurve(numerator, weight);
}

}  // namespace phrame
