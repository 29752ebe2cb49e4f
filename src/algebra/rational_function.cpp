#include "phrame/algebra/rational_function.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {

RationalFunction::RationalFunction(Polynomial numerator, Polynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.is_zero()) throw DomainError("RationalFunction: the denominator is 0");
  const Polynomial common = gcd(numerator_, denominator_);
  if (!common.is_constant()) {
    numerator_ = exact_quotient(numerator_, common);
    denominator_ = exact_quotient(denominator_, common);
  }
  numerator_ *= 1 / content(denominator_);
  denominator_ = denominator_.is_constant() ? Polynomial() : primitive_part(denominator_);
}

RationalFunction::RationalFunction(Polynomial polynomial) : numerator_(std::move(polynomial)) {}

const Polynomial& RationalFunction::denominator() const {
  static const Polynomial one{1};
  return denominator_.is_zero() ? one : denominator_;
}

Rational RationalFunction::operator()(const Rational& t) const {
  const Rational below = denominator()(t);
  if (below == 0)
    throw DomainError(fmt::format("value of a rational function: pole at t = {}", to_string(t)));
  return numerator_(t) / below;
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.denominator() == b.denominator()) return {a.numerator() + b.numerator(), a.denominator()};
  return {a.numerator() * b.denominator() + b.numerator() * a.denominator(),
          a.denominator() * b.denominator()};
}

RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) {
  return a + (-b);
}

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator() * b.numerator(), a.denominator() * b.denominator()};
}

RationalFunction operator-(const RationalFunction& a) {
  RationalFunction result = a;
  result.numerator_ *= -1;
  return result;
}

RationalFunction differentiate(const RationalFunction& f) {
  if (f.is_polynomial()) return RationalFunction(differentiate(f.numerator()));
  const Polynomial& n = f.numerator();
  const Polynomial& d = f.denominator();
  return {differentiate(n) * d - n * differentiate(d), d * d};
}

}  // namespace phrame
