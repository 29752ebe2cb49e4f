// Euclid's algorithm on r = q and s = a keeps u, v with r ≡ u·a, s ≡ v·a modulo q. Where the
// degrees fall by one, from deg r = k + 1 to deg s = k with leading coefficients m and l, one step
// is
//
//   (r, u) ← (l²·(r, u) − (m·l·t + r_k·l − m·s_{k−1})·(s, v)) / 2⁶⁴,
//
// which needs no division: the factor 1/2⁶⁴ is what makes Montgomery's reduction of the three
// products cheap. The step multiplies the true remainder by l²/2⁶⁴, hence
//   res(r, s) = l²·(l²/2⁶⁴)^{−k}·res(s, new r),
// and with n = deg q, l_k the leading coefficient in degree k and c = s at the end,
//   res(q, a) = c·2^{64·n(n−1)/2} / ∏ l_k^{2(k−1)},  k = n − 1, …, 1.
#include "phrame/algebra/modular.hpp"

#include <algorithm>
#include <array>

namespace phrame::inline v0 {
namespace {

/// (x·a + y·b + z·c)/2⁶⁴ mod p [Montgomery 1985]. The sum is below 3p² < 2⁶⁴p for p < 2⁶², so that
/// its upper word and the word subtracted are both below p.
class Combination {
 public:
  explicit Combination(ulong prime) : prime_(prime), inverse_(prime) {
    for (int k = 0; k < 5; ++k) inverse_ *= 2 - prime * inverse_;  // bits 3, 6, …, 96
  }

  void set(ulong x, ulong y, ulong z) {
    x_ = x;
    y_ = y;
    z_ = z;
  }

  ulong operator()(ulong a, ulong b, ulong c) const {
    ulong high;
    ulong low;
    ulong h;
    ulong l;
    umul_ppmm(high, low, x_, a);
    umul_ppmm(h, l, y_, b);
    add_ssaaaa(high, low, high, low, h, l);
    umul_ppmm(h, l, z_, c);
    add_ssaaaa(high, low, high, low, h, l);
    umul_ppmm(h, l, low * inverse_, prime_);
    const ulong difference = high - h;
    return difference + (prime_ & -(difference >> 63U));  // a branch here would be taken at random
  }

 private:
  ulong prime_;
  ulong inverse_;  ///< of the prime modulo 2⁶⁴
  ulong x_ = 0;
  ulong y_ = 0;
  ulong z_ = 0;
};

/// Coefficients of 1, …, tⁿ, and that of 1/t, which is 0.
class Coefficients {
 public:
  explicit Coefficients(slong n) : words_(static_cast<std::size_t>(n + 2)) {}
  ulong* from_constant() { return &words_[1]; }
  ulong& operator[](slong k) { return words_[static_cast<std::size_t>(k + 1)]; }

 private:
  std::vector<ulong> words_;
};

/// r ← combination(r, s, t·s) for the coefficients of 1, …, t^{length−1}.
void combine(Coefficients& r, Coefficients& s, slong length, const Combination& combination) {
  ulong* a = r.from_constant();
  const ulong* b = s.from_constant();
  for (slong k = 0; k < length; ++k) a[k] = combination(a[k], b[k], b[k - 1]);
}

/// For any degrees, by FLINT.
std::optional<ModularInverse> general_inverse(const ModularPolynomial& a,
                                              const ModularPolynomial& q) {
  ModularPolynomial inverse(q.prime());
  if (nmod_poly_invmod(inverse.raw(), a.raw(), q.raw()) == 0) return std::nullopt;
  return ModularInverse{std::move(inverse), nmod_poly_resultant(q.raw(), a.raw())};
}

}  // namespace

ModularPolynomial::ModularPolynomial(Word prime, const std::vector<Word>& ascending)
    : ModularPolynomial(prime) {
  for (std::size_t k = ascending.size(); k-- > 0;)
    nmod_poly_set_coeff_ui(raw(), static_cast<slong>(k), ascending[k]);
}

ModularPolynomial differentiate(const ModularPolynomial& a) {
  ModularPolynomial derivative(a.prime());
  nmod_poly_derivative(derivative.raw(), a.raw());
  return derivative;
}

ModularPolynomial shifted_down(const ModularPolynomial& a, long k) {
  ModularPolynomial quotient(a.prime());
  nmod_poly_shift_right(quotient.raw(), a.raw(), k);
  return quotient;
}

ModularPolynomial numerator_of_series(std::vector<Word> values, const ModularPolynomial& q) {
  const auto count = static_cast<long>(values.size());
  std::reverse(values.begin(), values.end());
  ModularPolynomial product(q.prime(), values);
  product *= q;
  return shifted_down(product, count);
}

// Reversed it is exp(−Σ s_k zᵏ/k) (Newton).
ModularPolynomial from_power_sums(Word prime, const std::vector<Word>& sums) {
  const auto n = static_cast<slong>(sums.size());
  ModularPolynomial series(prime);
  const nmod_t mod = series.raw()->mod;
  for (slong k = 1; k <= n; ++k) {
    const ulong over_k =
        nmod_div(sums[static_cast<std::size_t>(k - 1)], static_cast<ulong>(k), mod);
    nmod_poly_set_coeff_ui(series.raw(), k, nmod_neg(over_k, mod));
  }
  nmod_poly_exp_series(series.raw(), series.raw(), n + 1);
  nmod_poly_reverse(series.raw(), series.raw(), n + 1);
  return series;
}

Word evaluate(const ModularPolynomial& a, Word x) { return nmod_poly_evaluate_nmod(a.raw(), x); }

long common_degree(const ModularPolynomial& a, const ModularPolynomial& b) {
  ModularPolynomial common(a.prime());
  nmod_poly_gcd(common.raw(), a.raw(), b.raw());
  return common.degree();
}

// res(a, b) = lc(a)^deg b · ∏ b(τ).
std::optional<Word> product_of_values(const ModularPolynomial& a, const ModularPolynomial& b,
                                      const ModularPolynomial& c) {
  if (a.is_zero()) return std::nullopt;
  const nmod_t mod = a.raw()->mod;
  ModularPolynomial monic(a.prime());
  nmod_poly_make_monic(monic.raw(), a.raw());
  const Word below = nmod_poly_resultant(monic.raw(), c.raw());
  if (below == 0) return std::nullopt;
  return nmod_div(nmod_poly_resultant(monic.raw(), b.raw()), below, mod);
}

Word power(Word x, long n, Word p) {
  nmod_t mod;
  nmod_init(&mod, p);
  return nmod_pow_ui(x, static_cast<ulong>(n), mod);
}

bool are_coprime(const ModularPolynomial& a, const ModularPolynomial& b) {
  return common_degree(a, b) == 0;
}

// A common divisor has a leading coefficient that divides that of a: where the prime does not, it
// has its degree modulo the prime, too.
bool are_seen_coprime(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  const Word prime = Primes().next();
  const ModularPolynomial a_there(prime, a);
  return a_there.degree() == fmpz_poly_degree(a.get()) &&
         are_coprime(a_there, ModularPolynomial(prime, b));
}

bool is_seen_squarefree(const IntegerPolynomial& a) {
  const ModularPolynomial there(Primes().next(), a);
  return there.degree() == fmpz_poly_degree(a.get()) && are_coprime(there, differentiate(there));
}

// Of a square of denominators prime to p the root has such, too (Gauss), so that values are
// squares.
bool sum_of_squares_is_seen_no_square(const Polynomial& a, const Polynomial& b,
                                      const Polynomial& c) {
  constexpr Word prime = 2147483647;
  constexpr Word places = 8;
  const std::array<const Polynomial*, 3> all{&a, &b, &c};
  std::array<ModularPolynomial, 3> reduced{ModularPolynomial(prime), ModularPolynomial(prime),
                                           ModularPolynomial(prime)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (fmpz_fdiv_ui(all[k]->raw()->den, prime) == 0) return false;
    fmpq_poly_get_nmod_poly(reduced[k].raw(), all[k]->raw());
  }
  for (Word t = 0; t < places; ++t) {
    Word sum = 0;  // of three numbers below 2^31
    for (const ModularPolynomial& p : reduced) {
      const Word value = evaluate(p, t);
      sum += value * value % prime;
    }
    if (n_jacobi_unsigned(sum % prime, prime) == -1) return true;
  }
  return false;
}

std::vector<FactorShape> shapes_of_factors(const ModularPolynomial& a) {
  nmod_poly_factor_t factors;
  nmod_poly_factor_init(factors);
  nmod_poly_factor(factors, a.raw());
  std::vector<FactorShape> shapes(static_cast<std::size_t>(factors->num));
  for (slong k = 0; k < factors->num; ++k)
    shapes[static_cast<std::size_t>(k)] = {nmod_poly_degree(factors->p + k), factors->exp[k]};
  nmod_poly_factor_clear(factors);
  return shapes;
}

Word residue(const Integer& x, Word p) { return fmpz_fdiv_ui(x.raw(), p); }

// The quotient is a power series: with e = deg a − deg q, at t = 1/z, rev(a)/rev(q) modulo z^{e+1}.
void reduce(ModularPolynomial& a, const ModularPolynomial& q) {
  const slong n = q.degree();
  const slong e = a.degree() - n;
  if (e < 0) return;
  ModularPolynomial quotient(q.prime());
  ModularPolynomial reversed(q.prime());
  nmod_poly_reverse(quotient.raw(), a.raw(), a.degree() + 1);
  nmod_poly_reverse(reversed.raw(), q.raw(), n + 1);
  nmod_poly_div_series(quotient.raw(), quotient.raw(), reversed.raw(), e + 1);
  nmod_poly_reverse(quotient.raw(), quotient.raw(), e + 1);
  nmod_poly_mullow(quotient.raw(), quotient.raw(), q.raw(), n);
  nmod_poly_truncate(a.raw(), n);
  nmod_poly_sub(a.raw(), a.raw(), quotient.raw());
}

ModularPolynomial multiply_modulo(const ModularPolynomial& a, const ModularPolynomial& b,
                                  const ModularPolynomial& q) {
  ModularPolynomial product(q.prime());
  nmod_poly_mul(product.raw(), a.raw(), b.raw());
  reduce(product, q);
  return product;
}

std::optional<ModularInverse> modular_inverse(const ModularPolynomial& a,
                                              const ModularPolynomial& q) {
  const slong n = q.degree();
  if (n < 2 || a.degree() != n - 1) return general_inverse(a, q);
  const nmod_t mod = q.raw()->mod;
  Coefficients r(n);
  Coefficients s(n);
  Coefficients u(n);
  Coefficients v(n);
  std::copy_n(q.raw()->coeffs, n + 1, r.from_constant());
  std::copy_n(a.raw()->coeffs, n, s.from_constant());
  v[0] = 1;
  Combination combination(mod.n);
  ulong leads = 1;    // ∏ l_j, j ≥ k
  ulong product = 1;  // ∏ l_j^{j−k}, j > k
  for (slong k = n - 1; k > 0; --k) {
    const ulong l = s[k];
    const ulong m = r[k + 1];
    combination.set(nmod_mul(l, l, mod),
                    nmod_sub(nmod_mul(m, s[k - 1], mod), nmod_mul(r[k], l, mod), mod),
                    nmod_neg(nmod_mul(m, l, mod), mod));
    combine(r, s, k, combination);
    combine(u, v, n - k + 1, combination);
    std::swap(r, s);
    std::swap(u, v);
    product = nmod_mul(product, leads, mod);
    leads = nmod_mul(leads, l, mod);
  }
  const ulong c = s[0];  // 0 also where one of the l_k, k ≥ 2, is
  if (c == 0) return general_inverse(a, q);
  ModularInverse result{ModularPolynomial(mod.n), 0};
  nmod_poly_fit_length(result.inverse.raw(), n);
  _nmod_vec_scalar_mul_nmod(result.inverse.raw()->coeffs, v.from_constant(), n, nmod_inv(c, mod),
                            mod);
  result.inverse.raw()->length = n;
  _nmod_poly_normalise(result.inverse.raw());
  const ulong powers = nmod_mul(c, nmod_pow_ui(2, static_cast<ulong>(32 * n * (n - 1)), mod), mod);
  result.resultant = nmod_div(powers, nmod_mul(product, product, mod), mod);
  return result;
}

ulong Primes::next() {
  thread_local std::vector<ulong> known;
  if (used_ == known.size())
    known.push_back(n_nextprime(known.empty() ? 1UL << 61U : known.back(), 0));
  return known[used_++];
}

}  // namespace phrame
