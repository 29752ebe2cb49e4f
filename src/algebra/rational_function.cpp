#include "phrame/algebra/rational_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// p(n/d)·d^degree, degree ≥ deg p, by Horner's scheme.
Polynomial homogenized(const Polynomial& p, const RationalFunction& x, long degree) {
  Polynomial sum;
  Polynomial power{1};
  for (long k = degree; k >= 0; --k) {
    sum = sum * x.numerator() + p.coefficient(k) * power;
    power = power * x.denominator();
  }
  return sum;
}

}  // namespace

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
  const Polynomial common = gcd(a.denominator(), b.denominator());
  if (common.is_constant()) {
    // Then the sum is in lowest terms: a factor of one denominator divides one product only.
    RationalFunction sum;
    sum.numerator_ = a.numerator() * b.denominator() + b.numerator() * a.denominator();
    const Polynomial denominator = a.denominator() * b.denominator();
    if (!denominator.is_constant()) sum.denominator_ = denominator;
    return sum;
  }
  // What can cancel is in the common factor [Henrici 1956].
  const Polynomial rest = exact_quotient(a.denominator(), common);
  const Polynomial numerator =
      a.numerator() * exact_quotient(b.denominator(), common) + b.numerator() * rest;
  const Polynomial cancels = gcd(numerator, common);
  return {exact_quotient(numerator, cancels), rest * exact_quotient(b.denominator(), cancels)};
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
  // Every pole becomes of one order more: beyond gcd(d, d′) nothing cancels.
  const Polynomial repeated = gcd(d, differentiate(d));
  const Polynomial radical = exact_quotient(d, repeated);
  return {differentiate(n) * radical - n * exact_quotient(differentiate(d), repeated), d * radical};
}

RationalFunction compose(const RationalFunction& f, const Polynomial& g) {
  return {compose(f.numerator(), g), compose(f.denominator(), g)};
}

RationalFunction compose(const RationalFunction& f, const RationalFunction& g) {
  const long degree = std::max({f.numerator().degree(), f.denominator().degree(), 0L});
  return {homogenized(f.numerator(), g, degree), homogenized(f.denominator(), g, degree)};
}

std::optional<Rational> constant(const RationalFunction& f) {
  if (!f.is_polynomial() || !f.numerator().is_constant()) return std::nullopt;
  return f.numerator().coefficient(0);
}

long bits_of(const RationalFunction& f) {
  const auto bits = [](const Polynomial& p) {
    return std::abs(fmpz_poly_max_bits(integer_primitive_part(p).get()));
  };
  return bits(f.numerator()) + bits(f.denominator());
}

std::ostream& operator<<(std::ostream& out, const RationalFunction& f) {
  if (f.is_polynomial()) return out << f.numerator();
  const bool is_integer = f.numerator().is_constant() && denominator(f.numerator()) == 1;
  if (is_integer) return out << f.numerator() << "/(" << f.denominator() << ')';
  return out << '(' << f.numerator() << ")/(" << f.denominator() << ')';
}

}  // namespace phrame
