// By FLINT's polynomials in two unknowns, t before x. Its factors have integer coefficients without
// a common divisor.
#include "phrame/algebra/bivariate_factor.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/flint_multivariate.hpp"

namespace phrame::inline v0 {
namespace {

/// ℤ[t, x].
struct IntegerRing {
  fmpz_mpoly_ctx_t value;
  IntegerRing() { fmpz_mpoly_ctx_init(value, 2, ORD_LEX); }
  ~IntegerRing() { fmpz_mpoly_ctx_clear(value); }
  IntegerRing(const IntegerRing&) = delete;
  IntegerRing& operator=(const IntegerRing&) = delete;
};

/// An element of it.
class IntegerBivariate {
 public:
  explicit IntegerBivariate(const IntegerRing& ring) : ring_(ring) {
    fmpz_mpoly_init(value_, ring_.value);
  }
  /// primitive_part(v), or 0.
  IntegerBivariate(const IntegerRing& ring, const Bivariate& v) : IntegerBivariate(ring) {
    if (v.is_zero()) return;
    const std::vector<IntegerPolynomial> rows = integer_rows(v);
    flint::Fmpz c;
    for (std::size_t k = rows.size(); k-- > 0;)
      for (slong j = fmpz_poly_degree(rows[k].get()); j >= 0; --j) {
        fmpz_poly_get_coeff_fmpz(c.get(), rows[k].get(), j);
        const ulong exponents[2] = {k, static_cast<ulong>(j)};
        if (!fmpz_is_zero(c.get()))
          fmpz_mpoly_push_term_fmpz_ui(value_, c.get(), exponents, ring_.value);
      }
  }
  ~IntegerBivariate() { fmpz_mpoly_clear(value_, ring_.value); }
  IntegerBivariate(const IntegerBivariate&) = delete;
  IntegerBivariate& operator=(const IntegerBivariate&) = delete;

  fmpz_mpoly_struct* get() { return value_; }

  /// primitive_part() of it, or 0.
  Bivariate primitive() const {
    std::vector<IntegerPolynomial> rows;
    flint::Fmpz c;
    for (slong k = 0; k < fmpz_mpoly_length(value_, ring_.value); ++k) {
      ulong exponents[2];
      fmpz_mpoly_get_term_exp_ui(exponents, value_, k, ring_.value);
      fmpz_mpoly_get_term_coeff_fmpz(c.get(), value_, k, ring_.value);
      rows.resize(std::max<std::size_t>(rows.size(), exponents[0] + 1));
      fmpz_poly_set_coeff_fmpz(rows[exponents[0]].get(), static_cast<slong>(exponents[1]), c.get());
    }
    std::vector<Polynomial> found;
    for (const IntegerPolynomial& row : rows) found.push_back(to_polynomial(row.get()));
    const Bivariate v(std::move(found));
    return v.is_zero() ? v : primitive_part(v);
  }

 private:
  const IntegerRing& ring_;
  fmpz_mpoly_t value_;
};

struct IntegerFactors {
  const IntegerRing& ring;
  fmpz_mpoly_factor_t value;
  explicit IntegerFactors(const IntegerRing& of) : ring(of) {
    fmpz_mpoly_factor_init(value, ring.value);
  }
  ~IntegerFactors() { fmpz_mpoly_factor_clear(value, ring.value); }
  IntegerFactors(const IntegerFactors&) = delete;
  IntegerFactors& operator=(const IntegerFactors&) = delete;
};

/// In x.
long inner_degree(const Bivariate& v) {
  long degree = 0;
  for (const Polynomial& row : v.coefficients()) degree = std::max(degree, row.degree());
  return degree;
}

}  // namespace

std::vector<BivariateFactor> factor(const Bivariate& v) {
  if (v.is_zero()) throw DomainError("factor: the zero polynomial has no factors");
  const IntegerRing ring;
  IntegerBivariate whole(ring, v);
  IntegerFactors factors(ring);
  if (fmpz_mpoly_factor(factors.value, whole.get(), ring.value) == 0)
    throw Undecided("factor: FLINT does not factor the polynomial");
  std::vector<BivariateFactor> found;
  for (slong k = 0; k < fmpz_mpoly_factor_length(factors.value, ring.value); ++k) {
    IntegerBivariate base(ring);
    fmpz_mpoly_factor_get_base(base.get(), factors.value, k, ring.value);
    found.push_back({base.primitive(), static_cast<long>(fmpz_mpoly_factor_get_exp_si(
                                           factors.value, k, ring.value))});
  }
  std::ranges::stable_sort(found, {}, [](const BivariateFactor& x) {
    return std::pair(x.base.degree(), inner_degree(x.base));
  });
  return found;
}

Bivariate gcd(const Bivariate& a, const Bivariate& b) {
  const IntegerRing ring;
  IntegerBivariate x(ring, a);
  IntegerBivariate y(ring, b);
  IntegerBivariate common(ring);
  if (fmpz_mpoly_gcd(common.get(), x.get(), y.get(), ring.value) == 0)
    throw Undecided("gcd: FLINT does not find the greatest common divisor");
  return common.primitive();
}

}  // namespace phrame
