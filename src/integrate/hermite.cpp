#include "phrame/integrate/hermite.hpp"

#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

// With D = D⁻·D*, D⁻ = gcd(D, D′), D* squarefree: every step lowers the order of the poles of A/D
// by one. B is chosen with A ≡ −B·D*·(D⁻)′/D⁻ modulo the squarefree part of D⁻; then A/D − (B/D⁻)′
// has no pole of the highest order any more.
RationalPart hermite_reduce(const RationalFunction& f) {
  if (!f.is_proper()) throw DomainError("hermite_reduce: the function has a polynomial part");
  Polynomial a = f.numerator();
  Polynomial repeated = gcd(f.denominator(), differentiate(f.denominator()));
  if (repeated.is_constant()) return {{}, f};
  const Polynomial simple = exact_quotient(f.denominator(), repeated);
  RationalFunction rational;
  while (!repeated.is_constant()) {
    const Polynomial next = gcd(repeated, differentiate(repeated));
    const Polynomial radical = exact_quotient(repeated, next);
    const Polynomial slope = -exact_quotient(simple * differentiate(repeated), repeated);
    const QuotientRing ring(radical);
    const Polynomial b = ring.divide(a, slope);
    const Polynomial c = exact_quotient(a - b * slope, radical);
    a = c - differentiate(b) * exact_quotient(simple, radical);
    rational = rational + RationalFunction(b, repeated);
    repeated = next;
  }
  return {rational, {a, simple}};
}

}  // namespace phrame
