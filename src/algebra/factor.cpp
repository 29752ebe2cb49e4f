#include "phrame/algebra/factor.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/known_factor.hpp"
#include "phrame/algebra/modular.hpp"

namespace phrame::inline v0 {
namespace {

struct Factors {
  fmpz_poly_factor_t value;
  Factors() { fmpz_poly_factor_init(value); }
  ~Factors() { fmpz_poly_factor_clear(value); }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
};

bool comes_before(const Factor& a, const Factor& b) {
  if (a.base.degree() != b.base.degree()) return a.base.degree() < b.base.degree();
  if (a.exponent != b.exponent) return a.exponent < b.exponent;
  for (long k = a.base.degree(); k >= 0; --k) {
    const Rational x = a.base.coefficient(k);
    const Rational y = b.base.coefficient(k);
    if (abs(x) != abs(y)) return abs(x) < abs(y);
    if (x != y) return x < y;
  }
  return false;
}

template <class Split>
Factorization factorization(const Polynomial& p, const char* name, Split split) {
  if (p.is_zero()) throw DomainError(std::string(name) + ": the zero polynomial has none");
  Factorization result{content(p), {}};
  if (p.is_constant()) return result;
  Factors found;
  split(found.value, integer_primitive_part(p).get());
  for (slong k = 0; k < found.value->num; ++k)
    result.factors.push_back({primitive_part(to_polynomial(&found.value->p[k])),
                              static_cast<long>(found.value->exp[k])});
  std::sort(result.factors.begin(), result.factors.end(), comes_before);
  return result;
}

}  // namespace

Factorization squarefree_factorization(const Polynomial& p) {
  if (!p.is_constant() && is_seen_squarefree(integer_numerator(p)))
    return {content(p), {{primitive_part(p), 1}}};
  return factorization(p, "squarefree_factorization", fmpz_poly_factor_squarefree);
}

Factorization factor(const Polynomial& p) { return factorization(p, "factor", fmpz_poly_factor); }

Factorization factor(const Polynomial& p, const Polynomial& divisor) {
  if (divisor.is_constant() || divisor.degree() == p.degree()) return factor(p);
  Factorization result{content(p), factor(divisor).factors};
  for (Factor& other : factor(exact_quotient(p, divisor)).factors)
    result.factors.push_back(std::move(other));
  std::sort(result.factors.begin(), result.factors.end(), comes_before);
  return result;
}

}  // namespace phrame
