#include "phrame/algebra/modular_algebra.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {

ModularAlgebra::ModularAlgebra(const ModularPolynomial& d)
    : modulus_(d),
      derivative_(d.prime()),
      derivative_inverse_{ModularPolynomial(d.prime()), 0},
      reversed_(d.prime()),
      reversed_inverse_(d.prime()),
      remainder_inverse_(d.prime()) {}

std::optional<ModularAlgebra> ModularAlgebra::make(const ModularPolynomial& d, long size) {
  ModularAlgebra a(d);
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

ModularPolynomial ModularAlgebra::variable() const {
  ModularPolynomial t(prime());
  nmod_poly_set_coeff_ui(t.raw(), 1, 1);
  nmod_poly_rem(t.raw(), t.raw(), modulus_.raw());
  return t;
}

ModularPolynomial ModularAlgebra::multiply(const ModularPolynomial& a,
                                           const ModularPolynomial& b) const {
  ModularPolynomial c(prime());
  nmod_poly_mulmod_preinv(c.raw(), a.raw(), b.raw(), modulus_.raw(), remainder_inverse_.raw());
  return c;
}

// Tr(tᵏ) are the coefficients of rev(d′)/rev(d), for d of degree N and d′ of degree N − 1.
ModularPolynomial ModularAlgebra::trace() const {
  ModularPolynomial form(prime());
  nmod_poly_reverse(form.raw(), derivative_.raw(), size());
  nmod_poly_mullow(form.raw(), form.raw(), reversed_inverse_.raw(), size());
  return form;
}

// The values ℓ(tᵏ), k < 2N, are the series U/rev(d) with U of degree < N; the new values are the
// middle coefficients of rev(a)·that series.
ModularPolynomial ModularAlgebra::compose(const ModularPolynomial& form,
                                          const ModularPolynomial& a) const {
  ModularPolynomial values(prime());
  ModularPolynomial reversed(prime());
  nmod_poly_mullow(values.raw(), form.raw(), reversed_.raw(), size());
  nmod_poly_mullow(values.raw(), values.raw(), reversed_inverse_.raw(), 2 * size() - 1);
  nmod_poly_reverse(reversed.raw(), a.raw(), size());
  nmod_poly_mullow(values.raw(), values.raw(), reversed.raw(), 2 * size() - 1);
  nmod_poly_shift_right(values.raw(), values.raw(), size() - 1);
  return values;
}

namespace {

struct ModularMatrix {
  nmod_mat_t value;
  ModularMatrix(slong rows, slong columns, ulong prime) {
    nmod_mat_init(value, rows, columns, prime);
  }
  ~ModularMatrix() { nmod_mat_clear(value); }
  ModularMatrix(const ModularMatrix&) = delete;
  ModularMatrix& operator=(const ModularMatrix&) = delete;

  ulong& entry(slong row, slong column) { return nmod_mat_entry(value, row, column); }
};

/// c⁰, …, c^count.
std::vector<ModularPolynomial> powers_of(const ModularAlgebra& algebra, const ModularPolynomial& c,
                                         slong count) {
  std::vector<ModularPolynomial> powers = {ModularPolynomial(c.prime(), std::vector<Word>{1})};
  for (slong k = 0; k < count; ++k) powers.push_back(algebra.multiply(powers.back(), c));
  return powers;
}

slong rounded_root(slong x) {
  return static_cast<slong>(std::ceil(std::sqrt(static_cast<double>(x))));
}

}  // namespace

Word value_of(const ModularPolynomial& form, const ModularPolynomial& a) {
  const nmod_t mod = a.raw()->mod;
  const slong length = std::min(form.degree(), a.degree()) + 1;
  Word sum = 0;
  for (slong k = 0; k < length; ++k)
    sum = nmod_add(sum, nmod_mul(form.raw()->coeffs[k], a.raw()->coeffs[k], mod), mod);
  return sum;
}

// With w = ⌈√count⌉, ℓ(c^{wj+i}) is in row j, column i of the product of the forms ℓ∘c^{wj} (rows)
// and the powers cⁱ (columns).
std::vector<ulong> values_of_powers(const ModularAlgebra& algebra, const ModularPolynomial& form,
                                    const ModularPolynomial& c, long count) {
  const slong n = algebra.size();
  const slong width = rounded_root(count);
  ModularMatrix forms(width, n, algebra.prime());
  ModularMatrix powers(n, width, algebra.prime());
  const std::vector<ModularPolynomial> power = powers_of(algebra, c, width);
  for (slong i = 0; i < width; ++i) {
    const ModularPolynomial& column = power[static_cast<std::size_t>(i)];
    for (slong k = 0; k <= column.degree(); ++k) powers.entry(k, i) = column.coefficient(k);
  }
  ModularPolynomial row = form;
  for (slong j = 0; j < width; ++j) {
    for (slong k = 0; k <= row.degree(); ++k) forms.entry(j, k) = row.coefficient(k);
    row = algebra.compose(row, power.back());
  }
  ModularMatrix result(width, width, algebra.prime());
  nmod_mat_mul(result.value, forms.value, powers.value);
  std::vector<ulong> values;
  for (slong k = 0; k < count; ++k) values.push_back(result.entry(k / width, k % width));
  return values;
}

// With f = Σ_b f_b·x^{wb}, deg f_b < w, the f_b(c) of all f are the rows of one product of
// matrices: the coefficients of the f_b, and 1, c, …, c^{w−1}.
std::vector<ModularPolynomial> values_at(const ModularAlgebra& algebra,
                                         const std::vector<ModularPolynomial>& list,
                                         const ModularPolynomial& c) {
  slong length = 1;
  for (const ModularPolynomial& f : list) length = std::max(length, f.degree() + 1);
  const auto count = static_cast<slong>(list.size());
  const slong width = std::min(length, rounded_root(length * count));
  const slong blocks = (length + width - 1) / width;
  const std::vector<ModularPolynomial> power = powers_of(algebra, c, width);
  ModularMatrix powers(width, algebra.size(), algebra.prime());
  for (slong i = 0; i < width; ++i) {
    const ModularPolynomial& row = power[static_cast<std::size_t>(i)];
    for (slong k = 0; k <= row.degree(); ++k) powers.entry(i, k) = row.coefficient(k);
  }
  ModularMatrix parts(count * blocks, width, algebra.prime());
  for (slong j = 0; j < count; ++j) {
    const ModularPolynomial& f = list[static_cast<std::size_t>(j)];
    for (slong k = 0; k <= f.degree(); ++k)
      parts.entry(j * blocks + k / width, k % width) = f.coefficient(k);
  }
  ModularMatrix at_c(count * blocks, algebra.size(), algebra.prime());
  nmod_mat_mul(at_c.value, parts.value, powers.value);
  std::vector<ModularPolynomial> values;
  for (slong j = 0; j < count; ++j) {
    ModularPolynomial sum(algebra.prime());
    for (slong b = blocks; b-- > 0;) {
      if (!sum.is_zero()) sum = algebra.multiply(sum, power.back());
      const ulong* row = &at_c.entry((j * blocks) + b, 0);
      sum += ModularPolynomial(algebra.prime(), std::vector<Word>(row, row + algebra.size()));
    }
    values.push_back(std::move(sum));
  }
  return values;
}

}  // namespace phrame
