// The greatest common divisor. For a prime p ≡ 1 mod 4 and ι² ≡ −1 there are two maps from ℤ[i] to
// 𝔽ₚ, i ↦ ι and i ↦ −ι; the images of a coefficient x + iy under both give back x and y modulo p.
// Where neither map lets the leading coefficient of a vanish, no image of a and b has a gcd of
// lower degree than a and b themselves: the gcd, primitive over ℤ[i], has a leading coefficient
// that divides that of a (Gauss). So a candidate of the least degree seen that divides a and b is
// the gcd.
#include "phrame/algebra/gaussian_polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/algebra/rational_lift.hpp"

namespace phrame::inline v0 {
namespace {

/// a times an integer, over ℤ[i].
struct Cleared {
  flint::FmpzPoly re;
  flint::FmpzPoly im;

  explicit Cleared(const GaussianPolynomial& a) {
    flint::Fmpz common;
    fmpz_lcm(common.get(), fmpq_poly_denref(a.re.raw()), fmpq_poly_denref(a.im.raw()));
    const Rational scale(common.get());
    fmpq_poly_get_numerator(re.get(), (scale * a.re).raw());
    fmpq_poly_get_numerator(im.get(), (scale * a.im).raw());
  }

  /// The image for i ↦ ι.
  ModularPolynomial modulo(ulong prime, ulong iota) const {
    ModularPolynomial image(prime, im);
    nmod_poly_scalar_mul_nmod(image.raw(), image.raw(), iota);
    nmod_poly_add(image.raw(), image.raw(), ModularPolynomial(prime, re).raw());
    return image;
  }
};

/// The monic gcd of the images, where that of a keeps its degree.
std::optional<ModularPolynomial> modular_gcd(const Cleared& a, const Cleared& b, long degree_a,
                                             ulong prime, ulong iota) {
  ModularPolynomial g = a.modulo(prime, iota);
  if (g.degree() != degree_a) return std::nullopt;
  nmod_poly_gcd(g.raw(), g.raw(), b.modulo(prime, iota).raw());
  return g;
}

/// Real and imaginary parts of the coefficients below the leading one, from both images.
std::vector<ulong> parts(const ModularPolynomial& plus, const ModularPolynomial& minus,
                         ulong iota) {
  const nmod_t mod = plus.raw()->mod;
  const ulong half = nmod_inv(2, mod);
  const ulong half_over_iota = nmod_div(half, iota, mod);
  std::vector<ulong> list;
  for (long k = 0; k < plus.degree(); ++k) {
    const ulong x = plus.coefficient(k);
    const ulong y = minus.coefficient(k);
    list.push_back(nmod_mul(nmod_add(x, y, mod), half, mod));
    list.push_back(nmod_mul(nmod_sub(x, y, mod), half_over_iota, mod));
  }
  return list;
}

/// The monic polynomial with these parts.
GaussianPolynomial monic_from_parts(const std::vector<Rational>& list) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  for (std::size_t k = 0; k < list.size(); k += 2) {
    re.push_back(list[k]);
    im.push_back(list[k + 1]);
  }
  re.emplace_back(1);
  return {Polynomial(re), Polynomial(im)};
}

/// a/b, b ≠ 0, where b divides a over ℚ: the primitive parts then divide over ℤ.
std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b) {
  flint::FmpzPoly q;
  if (fmpz_poly_divides(q.get(), integer_primitive_part(a).get(),
                        integer_primitive_part(b).get()) == 0)
    return std::nullopt;
  return Rational(content(a) / content(b)) * to_polynomial(q.get());
}

/// a/b = a·b̄/|b|².
std::optional<GaussianPolynomial> quotient(const GaussianPolynomial& a,
                                           const GaussianPolynomial& b) {
  const auto [re, im] = a * conjugate(b);
  const Polynomial n = norm(b);
  auto real = quotient(re, n);
  auto imaginary = quotient(im, n);
  if (!real || !imaginary) return std::nullopt;
  return GaussianPolynomial{*std::move(real), *std::move(imaginary)};
}

}  // namespace

bool is_zero(const GaussianPolynomial& a) { return a.re.is_zero() && a.im.is_zero(); }

long degree(const GaussianPolynomial& a) { return std::max(a.re.degree(), a.im.degree()); }

GaussianPolynomial differentiate(const GaussianPolynomial& a) {
  return {differentiate(a.re), differentiate(a.im)};
}

GaussianPolynomial monic(const GaussianPolynomial& a) {
  if (is_zero(a)) throw DomainError("monic: the zero polynomial has no leading coefficient");
  const long n = degree(a);
  const Rational re = a.re.coefficient(n);
  const Rational im = a.im.coefficient(n);
  const Rational scale = 1 / Rational(re * re + im * im);
  return GaussianPolynomial{{re * scale}, {-im * scale}} * a;
}

GaussianPolynomial exact_quotient(const GaussianPolynomial& a, const GaussianPolynomial& b) {
  if (is_zero(b)) throw DomainError("exact_quotient: the divisor is the zero polynomial");
  auto result = quotient(a, b);
  if (!result)
    throw DomainError(
        fmt::format("exact_quotient: a divisor of degree {} leaves a remainder", degree(b)));
  return *std::move(result);
}

GaussianPolynomial gcd(const GaussianPolynomial& a, const GaussianPolynomial& b) {
  if (is_zero(a)) return is_zero(b) ? b : monic(b);
  if (is_zero(b)) return monic(a);
  const Cleared integer_a(a);
  const Cleared integer_b(b);
  Primes primes;
  long least = degree(a) + 1;
  std::optional<RationalLift> lift;
  for (;;) {
    const ulong p = primes.next();
    if (p % 4 != 1) continue;
    const ulong iota = n_sqrtmod(p - 1, p);
    const auto plus = modular_gcd(integer_a, integer_b, degree(a), p, iota);
    const auto minus = modular_gcd(integer_a, integer_b, degree(a), p, p - iota);
    if (!plus || !minus) continue;
    const long found = std::min(plus->degree(), minus->degree());
    if (found < least) {
      least = found;
      lift.emplace(static_cast<std::size_t>(2 * least));
    }
    if (plus->degree() != least || minus->degree() != least) continue;
    const auto list = lift->include(parts(*plus, *minus, iota), p);
    if (!list) continue;
    GaussianPolynomial candidate = monic_from_parts(*list);
    if (quotient(a, candidate) && quotient(b, candidate)) return candidate;
  }
}

std::ostream& operator<<(std::ostream& out, const GaussianPolynomial& p) {
  return out << '(' << p.re << ") + (" << p.im << ")*i";
}

}  // namespace phrame
