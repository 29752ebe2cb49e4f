// The determinant of Sylvester's matrix, with polynomials in x for entries: for |x| = 1 it is at
// most the product of the Euclidean norms of the rows, where an entry is at most the sum of the
// absolute values of its coefficients; and no coefficient of a polynomial is greater than its
// greatest value there.
#include "phrame/algebra/eliminant.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/modular_lift.hpp"

namespace phrame::inline v0 {
namespace {

long bits_above(long x) { return static_cast<long>(FLINT_BIT_COUNT(static_cast<ulong>(x))); }

/// What is known of one of the two.
struct Rows {
  std::vector<IntegerPolynomial> rows;  ///< the coefficients of t⁰, t¹, …
  long degree = 0;                      ///< in x
  long bits = 0;                        ///< the norm of a row of Sylvester's matrix is ≤ 2^bits

  explicit Rows(const Bivariate& v) : rows(integer_rows(v)) {
    for (const IntegerPolynomial& row : rows) {
      degree = std::max(degree, static_cast<long>(fmpz_poly_degree(row.get())));
      bits = std::max(bits, std::abs(static_cast<long>(fmpz_poly_max_bits(row.get()))));
    }
    bits += bits_above(degree + 1) + bits_above(height());
  }

  long height() const { return static_cast<long>(rows.size()) - 1; }  ///< the degree in t
};

/// @{ Of the resultant at most: its degree in x, and the bits of a coefficient.
long degree_of(const Rows& a, const Rows& b) {
  return b.height() * a.degree + a.height() * b.degree;
}
long bits_of(const Rows& a, const Rows& b) { return b.height() * a.bits + a.height() * b.bits; }
/// @}

/// v(x, t) modulo a prime; no value where its degree in t is less there.
std::optional<ModularPolynomial> at(const ModularPolynomial* rows, long height, Word x,
                                    Word prime) {
  ModularPolynomial value(prime);
  for (long k = height; k >= 0; --k)
    nmod_poly_set_coeff_ui(value.raw(), k, nmod_poly_evaluate_nmod(rows[k].raw(), x));
  if (value.degree() != height) return std::nullopt;
  return value;
}

}  // namespace

long eliminant_size(const Bivariate& a, const Bivariate& b) {
  const Rows first(a);
  const Rows second(b);
  return bits_of(first, second) * (degree_of(first, second) + 1);
}

Polynomial eliminant(const Bivariate& a, const Bivariate& b) {
  const Rows first(a);
  const Rows second(b);
  const long degree = degree_of(first, second);
  std::vector<IntegerPolynomial> inputs = first.rows;
  inputs.insert(inputs.end(), second.rows.begin(), second.rows.end());
  const auto image =
      [&](const std::vector<ModularPolynomial>& rows) -> std::optional<ModularPolynomial> {
    const Word prime = rows.front().prime();
    std::vector<Word> places;
    std::vector<Word> values;
    const long most = degree + 1 + first.degree + second.degree;
    for (Word x = 1; static_cast<long>(places.size()) <= degree; ++x) {
      if (static_cast<long>(x) > most) return std::nullopt;
      const auto p = at(rows.data(), first.height(), x, prime);
      const auto q = at(rows.data() + first.rows.size(), second.height(), x, prime);
      if (!p || !q) continue;
      places.push_back(x);
      values.push_back(nmod_poly_resultant(p->raw(), q->raw()));
    }
    ModularPolynomial found(prime);
    nmod_poly_interpolate_nmod_vec(found.raw(), places.data(), values.data(), degree + 1);
    return found;
  };
  const Polynomial lifted =
      to_polynomial(modular_lift(inputs, degree + 1, bits_of(first, second), image).get());
  return lifted.is_zero() ? lifted : primitive_part(lifted);
}

Bivariate swapped(const Bivariate& v) {
  long degree = -1;
  for (const Polynomial& row : v.coefficients()) degree = std::max(degree, row.degree());
  std::vector<Polynomial> columns;
  for (long k = 0; k <= degree; ++k) {
    std::vector<Rational> column;
    for (const Polynomial& row : v.coefficients()) column.push_back(row.coefficient(k));
    columns.emplace_back(column);
  }
  return Bivariate(columns);
}

Bivariate exact_quotient(const Bivariate& a, const Bivariate& b) {
  std::vector<Polynomial> rest = a.coefficients();
  const std::vector<Polynomial>& divisor = b.coefficients();
  std::vector<Polynomial> quotient(rest.size() < divisor.size() ? 0
                                                                : rest.size() + 1 - divisor.size());
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = exact_quotient(rest[k + divisor.size() - 1], divisor.back());
    for (std::size_t j = 0; j < divisor.size(); ++j) rest[k + j] -= quotient[k] * divisor[j];
  }
  if (!Bivariate(rest).is_zero()) throw DomainError("exact_quotient: there is a remainder");
  return Bivariate(quotient);
}

}  // namespace phrame
