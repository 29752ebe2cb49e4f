#include "phrame/integrate/partial_fractions.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"

namespace phrame {

std::vector<SimpleFraction> simple_fractions(const RationalFunction& f) {
  if (!f.is_proper()) throw DomainError("simple_fractions: the function has a polynomial part");
  if (f.is_zero()) return {};
  const Factorization factors = factor(f.denominator());
  if (factors.factors.size() == 1 && factors.factors.front().exponent == 1)
    return {{f.numerator(), f.denominator()}};
  std::vector<SimpleFraction> parts;
  for (const auto& [base, exponent] : factors.factors) {
    if (exponent != 1) throw DomainError("simple_fractions: the function has a multiple pole");
    // f = n/(base·rest) has the part (n·rest⁻¹ mod base)/base.
    const QuotientRing ring(base);
    const Polynomial rest = exact_quotient(f.denominator(), base);
    parts.push_back({ring.divide(f.numerator(), rest), base});
  }
  return parts;
}

LogSum full_partial_fraction(const SimpleFraction& f) {
  const QuotientRing ring(f.denominator);
  return {f.denominator, ring.divide(f.numerator, differentiate(f.denominator)),
          ring.reduce(Bivariate({Polynomial{0, -1}, Polynomial{1}}))};
}

}  // namespace phrame
