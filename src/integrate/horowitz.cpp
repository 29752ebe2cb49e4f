#include "phrame/integrate/horowitz.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/linear_system.hpp"

namespace phrame::inline v0 {

RationalPart horowitz_reduce(const RationalFunction& f) {
  if (!f.is_proper()) throw DomainError("horowitz_reduce: the function has a polynomial part");
  const Polynomial& q = f.denominator();
  const Polynomial q1 = gcd(q, differentiate(q));
  const Polynomial q2 = exact_quotient(q, q1);
  const Polynomial s = exact_quotient(differentiate(q1) * q2, q1);
  // Unknown: the coefficients of p₁ (degree < deg q₁), then of p₂ (degree < deg q₂).
  std::vector<Polynomial> columns;
  for (long k = 0; k < q1.degree(); ++k) {
    const Polynomial power = Polynomial::monomial(1, k);
    columns.push_back(q2 * differentiate(power) - s * power);
  }
  for (long k = 0; k < q2.degree(); ++k) columns.push_back(q1 * Polynomial::monomial(1, k));
  const auto solution = solve_for_coefficients(columns, f.numerator(), q.degree());
  if (!solution) throw DomainError("horowitz_reduce: the linear system is singular");
  const auto split = solution->begin() + q1.degree();
  const Polynomial p1(std::vector(solution->begin(), split));
  const Polynomial p2(std::vector(split, solution->end()));
  return {{p1, q1}, {p2, q2}};
}

}  // namespace phrame
