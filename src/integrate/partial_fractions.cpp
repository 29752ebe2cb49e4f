#include "phrame/integrate/partial_fractions.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/known_factor.hpp"

namespace phrame::inline v0 {

std::vector<SimpleFraction> simple_fractions(const RationalFunction& f, const Polynomial& divisor) {
  if (!f.is_proper()) throw DomainError("simple_fractions: the function has a polynomial part");
  if (f.is_zero()) return {};
  const Factorization factors = factor(f.denominator(), divisor);
  if (factors.factors.size() == 1 && factors.factors.front().exponent == 1)
    return {{f.numerator(), f.denominator()}};
  // f = n/(base·rest) has the part (n·rest⁻¹ mod base)/base. The one of the highest degree would
  // cost most: it is what the others leave.
  const auto of_degree = [](const Factor& a, const Factor& b) {
    return a.base.degree() < b.base.degree();
  };
  const auto highest = std::max_element(factors.factors.begin(), factors.factors.end(), of_degree);
  std::vector<SimpleFraction> parts;
  Polynomial left = f.numerator();
  const auto rest_of = [&](const Polynomial& base) {
    return exact_quotient(f.denominator(), base);
  };
  for (const Factor& factor : factors.factors) {
    if (factor.exponent != 1)
      throw DomainError("simple_fractions: the function has a multiple pole");
    parts.push_back({{}, factor.base});
    if (&factor == &*highest) continue;
    const Polynomial rest = rest_of(factor.base);
    parts.back().numerator = QuotientRing(factor.base).divide(f.numerator(), rest);
    left = left - parts.back().numerator * rest;
  }
  SimpleFraction& last = parts[static_cast<std::size_t>(highest - factors.factors.begin())];
  last.numerator = exact_quotient(left, rest_of(last.denominator));
  return parts;
}

LogSum full_partial_fraction(const SimpleFraction& f) {
  const QuotientRing ring(f.denominator);
  return {f.denominator, ring.divide(f.numerator, differentiate(f.denominator)),
          ring.reduce(Bivariate({Polynomial{0, -1}, Polynomial{1}}))};
}

}  // namespace phrame
