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
    parts.push_back({ring.multiply(f.numerator(), ring.inverse(ring.reduce(rest))), base});
  }
  return parts;
}

LogSum full_partial_fraction(const SimpleFraction& f) {
  const QuotientRing ring(f.denominator);
  const Polynomial slope = ring.reduce(differentiate(f.denominator));
  return {f.denominator, ring.multiply(f.numerator, ring.inverse(slope)),
          ring.reduce(Bivariate({Polynomial{0, -1}, Polynomial{1}}))};
}

}  // namespace phrame
