// The characteristic polynomial χ of c = n/d′ in A = 𝔽ₚ[t]/(d) from its power sums
// s_k = Tr(cᵏ), k ≤ N = deg d: χ reversed is exp(−Σ s_k zᵏ/k) (Newton). The power sums are a
// "power projection" (Shoup 1999): with w = ⌈√N⌉, Tr(c^{i+wj}) = (Tr∘c^{wj})(cⁱ), so about 2√N
// products in A and one matrix product are enough. Over ℤ,
//   res_t(d, n − x·d′) = lead(d)^{N−1} ∏ (n(z) − x d′(z)) = (−1)^N · res(d, d′) · χ(x).
#include "phrame/algebra/resultant.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/hadamard.hpp"
#include "phrame/algebra/modular_lift.hpp"

namespace phrame {
namespace {

/// 𝔽ₚ[t]/(d) with the linear forms on it; a form is the list of its values at 1, t, …, t^{N−1},
/// kept as a polynomial in z: Σ ℓ(tᵏ) zᵏ.
class Algebra {
 public:
  /// d modulo p; no value where p divides lead(d), so that the degree is not `size`, or the
  /// discriminant.
  static std::optional<Algebra> make(const ModularPolynomial& d, slong size) {
    Algebra a(d);
    if (a.size() != size) return std::nullopt;
    nmod_poly_derivative(a.derivative_.raw(), d.raw());
    if (a.derivative_.degree() != size - 1) return std::nullopt;
    auto inverse = modular_inverse(a.derivative_, d);
    if (!inverse) return std::nullopt;
    a.derivative_inverse_ = std::move(*inverse);
    nmod_poly_reverse(a.reversed_.raw(), a.modulus_.raw(), a.size() + 1);
    nmod_poly_inv_series(a.reversed_inverse_.raw(), a.reversed_.raw(), 2 * a.size());
    nmod_poly_reverse(a.remainder_inverse_.raw(), a.modulus_.raw(), a.size() + 1);
    nmod_poly_inv_series(a.remainder_inverse_.raw(), a.remainder_inverse_.raw(), a.size() + 1);
    return a;
  }

  long size() const { return modulus_.degree(); }
  ulong prime() const { return modulus_.prime(); }
  ulong discriminant() const { return derivative_inverse_.resultant; }  ///< res(d, d′)

  ModularPolynomial residue(const ModularPolynomial& n) const {
    return multiply(n, derivative_inverse_.inverse);
  }

  ModularPolynomial multiply(const ModularPolynomial& a, const ModularPolynomial& b) const {
    ModularPolynomial c(prime());
    nmod_poly_mulmod_preinv(c.raw(), a.raw(), b.raw(), modulus_.raw(), remainder_inverse_.raw());
    return c;
  }

  /// Tr(tᵏ) are the coefficients of rev(d′)/rev(d), for d of degree N and d′ of degree N − 1.
  ModularPolynomial trace() const {
    ModularPolynomial form(prime());
    nmod_poly_reverse(form.raw(), derivative_.raw(), size());
    nmod_poly_mullow(form.raw(), form.raw(), reversed_inverse_.raw(), size());
    return form;
  }

  /// The form b ↦ ℓ(a·b). The values ℓ(tᵏ), k < 2N, are the series U/rev(d) with U of degree < N;
  /// the new values are the middle coefficients of rev(a)·that series.
  ModularPolynomial compose(const ModularPolynomial& form, const ModularPolynomial& a) const {
    ModularPolynomial values(prime());
    ModularPolynomial reversed(prime());
    nmod_poly_mullow(values.raw(), form.raw(), reversed_.raw(), size());
    nmod_poly_mullow(values.raw(), values.raw(), reversed_inverse_.raw(), 2 * size() - 1);
    nmod_poly_reverse(reversed.raw(), a.raw(), size());
    nmod_poly_mullow(values.raw(), values.raw(), reversed.raw(), 2 * size() - 1);
    nmod_poly_shift_right(values.raw(), values.raw(), size() - 1);
    return values;
  }

 private:
  explicit Algebra(const ModularPolynomial& d)
      : modulus_(d),
        derivative_(d.prime()),
        derivative_inverse_{ModularPolynomial(d.prime()), 0},
        reversed_(d.prime()),
        reversed_inverse_(d.prime()),
        remainder_inverse_(d.prime()) {}

  ModularPolynomial modulus_;
  ModularPolynomial derivative_;
  ModularInverse derivative_inverse_;
  ModularPolynomial reversed_;
  ModularPolynomial reversed_inverse_;   ///< 1/rev(d) modulo z^{2N}
  ModularPolynomial remainder_inverse_;  ///< 1/rev(d) modulo z^{N+1}, for FLINT's remainder
};

struct Matrix {
  nmod_mat_t value;
  Matrix(slong rows, slong columns, ulong prime) { nmod_mat_init(value, rows, columns, prime); }
  ~Matrix() { nmod_mat_clear(value); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;

  ulong& entry(slong row, slong column) { return nmod_mat_entry(value, row, column); }
};

/// Tr(cᵏ) for 0 ≤ k ≤ N: with w = ⌈√(N+1)⌉, Tr(c^{wj+i}) is in row j, column i of the product of
/// the forms Tr∘c^{wj} (rows) and the powers cⁱ (columns).
std::vector<ulong> traces_of_powers(const Algebra& algebra, const ModularPolynomial& c) {
  const slong n = algebra.size();
  const auto width = static_cast<slong>(std::ceil(std::sqrt(static_cast<double>(n + 1))));
  Matrix forms(width, n, algebra.prime());
  Matrix powers(n, width, algebra.prime());
  ModularPolynomial power(algebra.prime());
  nmod_poly_one(power.raw());
  for (slong i = 0; i < width; ++i) {
    for (slong k = 0; k <= power.degree(); ++k) powers.entry(k, i) = power.coefficient(k);
    power = algebra.multiply(power, c);
  }
  ModularPolynomial form = algebra.trace();
  for (slong j = 0; j < width; ++j) {
    for (slong k = 0; k <= form.degree(); ++k) forms.entry(j, k) = form.coefficient(k);
    form = algebra.compose(form, power);
  }
  Matrix result(width, width, algebra.prime());
  nmod_mat_mul(result.value, forms.value, powers.value);
  std::vector<ulong> traces;
  for (slong k = 0; k <= n; ++k) traces.push_back(result.entry(k / width, k % width));
  return traces;
}

/// χ, monic. Needs p > N.
ModularPolynomial characteristic_polynomial(const Algebra& algebra, const ModularPolynomial& c) {
  const slong n = algebra.size();
  const std::vector<ulong> s = traces_of_powers(algebra, c);
  ModularPolynomial series(algebra.prime());  // −Σ s_k zᵏ/k
  const nmod_t mod = series.raw()->mod;
  for (slong k = 1; k <= n; ++k) {
    const ulong over_k = nmod_div(s[static_cast<std::size_t>(k)], static_cast<ulong>(k), mod);
    nmod_poly_set_coeff_ui(series.raw(), k, nmod_neg(over_k, mod));
  }
  nmod_poly_exp_series(series.raw(), series.raw(), n + 1);
  nmod_poly_reverse(series.raw(), series.raw(), n + 1);
  return series;
}

/// n/d scaled to integer polynomials: n = numerator/scale, d primitive.
struct IntegerFraction {
  flint::FmpzPoly numerator;
  flint::Fmpz scale;
  flint::FmpzPoly denominator;
};

IntegerFraction integer_fraction(const Polynomial& n, const Polynomial& d) {
  if (d.is_constant()) throw DomainError("residue_polynomial: the denominator is constant");
  if (n.degree() >= d.degree()) throw DomainError("residue_polynomial: the fraction is not proper");
  if (!is_squarefree(d))
    throw DomainError("residue_polynomial: the denominator has a repeated root");
  const Polynomial scaled = (1 / content(d)) * n;
  IntegerFraction f;
  fmpq_poly_get_numerator(f.numerator.get(), scaled.raw());
  fmpz_set(f.scale.get(), fmpq_poly_denref(scaled.raw()));
  f.denominator = integer_primitive_part(d);
  return f;
}

}  // namespace

Polynomial residue_polynomial(const Polynomial& n, const Polynomial& d) {
  const IntegerFraction f = integer_fraction(n, d);
  const auto image =
      [&](const std::vector<ModularPolynomial>& at) -> std::optional<ModularPolynomial> {
    const auto algebra = Algebra::make(at[1], d.degree());
    if (!algebra) return std::nullopt;
    ModularPolynomial r = characteristic_polynomial(*algebra, algebra->residue(at[0]));
    nmod_poly_scalar_mul_nmod(r.raw(), r.raw(), algebra->discriminant());
    return r;
  };
  const flint::FmpzPoly lifted = modular_lift({f.numerator, f.denominator}, d.degree() + 1,
                                              residue_bits(f.numerator, f.denominator), image);
  // The residues of n/d are those of numerator/d over `scale`: substitute x → scale·x.
  const Polynomial residues = to_polynomial(lifted.get());
  return primitive_part(compose(residues, Polynomial{0, to_rational(f.scale.get())}));
}

bool residues_are_distinct(const Polynomial& n, const Polynomial& d) {
  const IntegerFraction f = integer_fraction(n, d);
  Primes primes;
  for (int attempt = 0; attempt < 2; ++attempt) {
    const ulong p = primes.next();
    const auto algebra = Algebra::make(ModularPolynomial(p, f.denominator), d.degree());
    if (!algebra) continue;
    const ModularPolynomial chi =
        characteristic_polynomial(*algebra, algebra->residue(ModularPolynomial(p, f.numerator)));
    if (nmod_poly_is_squarefree(chi.raw()) != 0) return true;
  }
  return is_squarefree(residue_polynomial(n, d));
}

}  // namespace phrame
