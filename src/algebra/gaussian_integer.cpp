// A prime p ≡ 1 mod 4 is a norm: with g no square modulo p and r = g^{(p−1)/4}, r² ≡ −1, p divides
// (r + i)(r − i) but neither factor, so that gcd(p, r + i) has the norm p. 2 = |1 + i|². The norm
// of a + bi holds a prime p ≡ 3 mod 4 to an even power only, as p then divides a and b. So the part
// of x that is no norm is the product of its primes ≡ 3 mod 4 of odd exponent.
//
// That |π|² = p is checked; it does not matter whether p is proved to be prime.
#include "phrame/algebra/gaussian_integer.hpp"

#include <limits>
#include <ostream>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/handle.hpp"
#include "phrame/algebra/integer_factors.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long two_squares_bits = 4096;  ///< a power modulo p of this size takes as long

/// The integer nearest to x/n, n > 0.
Integer rounded_quotient(const Integer& x, const Integer& n) {
  return floor_quotient(2 * x + n, 2 * n);
}

GaussianInteger remainder(const GaussianInteger& a, const GaussianInteger& b) {
  const GaussianInteger c = a * conjugate(b);
  const Integer n = norm(b);
  const GaussianInteger product =
      b * GaussianInteger{rounded_quotient(c.re, n), rounded_quotient(c.im, n)};
  return {a.re - product.re, a.im - product.im};
}

/// π with |π|² = p in the first quadrant, re > im; no value for p ≡ 3 mod 4, and hardly for a p
/// that is not prime; one power modulo p says so.
std::optional<GaussianInteger> prime_above(const Integer& p) {
  if (p == 2) return GaussianInteger{1, 1};
  if (p % 4 != 1 || bit_length(p) > two_squares_bits) return std::nullopt;
  Integer g = 2;
  while (g < 1000 && fmpz_jacobi(g.raw(), p.raw()) != -1) ++g;
  const Integer exponent = (p - 1) / 4;
  Integer r;
  fmpz_powm(r.raw(), g.raw(), exponent.raw(), p.raw());
  if ((r * r + 1) % p != 0) return std::nullopt;
  const GaussianInteger pi = gcd(GaussianInteger{p, 0}, GaussianInteger{r, 1});
  if (norm(pi) != p) return std::nullopt;
  return pi.re > pi.im ? pi : GaussianInteger{pi.im, pi.re};
}

/// Primes whose product fits a word, so that one division tells which of them divide a number.
struct PrimeGroup {
  unsigned long product = 1;
  std::vector<unsigned> primes;
};

std::vector<PrimeGroup> prime_groups(unsigned below) {
  std::vector<PrimeGroup> groups(1);
  for (unsigned p = 2; p < below; ++p) {
    bool is_prime = true;
    for (unsigned d = 2; d * d <= p && is_prime; ++d) is_prime = p % d != 0;
    if (!is_prime) continue;
    if (groups.back().product > std::numeric_limits<unsigned long>::max() / p)
      groups.emplace_back();
    groups.back().product *= p;
    groups.back().primes.push_back(p);
  }
  return groups;
}

}  // namespace

GaussianInteger primitive_multiple(const GaussianRational& z) {
  const Integer m = lcm(Integer(denominator(z.re)), Integer(denominator(z.im)));
  const Integer re(numerator(Rational(z.re * m)));
  const Integer im(numerator(Rational(z.im * m)));
  const Integer common = gcd(re, im);
  return {re / common, im / common};
}

GaussianInteger first_quadrant(const GaussianInteger& a) {
  if (a.re > 0 && a.im >= 0) return a;
  if (a.re <= 0 && a.im > 0) return {a.im, -a.re};
  if (a.re < 0) return {-a.re, -a.im};
  return {-a.im, a.re};
}

std::optional<GaussianInteger> exact_quotient(const GaussianInteger& a, const GaussianInteger& b) {
  const GaussianInteger c = a * conjugate(b);
  const Integer n = norm(b);
  if (c.re % n != 0 || c.im % n != 0) return std::nullopt;
  return GaussianInteger{c.re / n, c.im / n};
}

// A common divisor d divides |d|² and with it the greatest common divisor g of |a|² and |b|².
GaussianInteger gcd(GaussianInteger a, GaussianInteger b) {
  const auto euclid = [](GaussianInteger x, GaussianInteger y) {
    while (norm(y) != 0) {
      x = remainder(x, y);
      std::swap(x, y);
    }
    return x;
  };
  const GaussianInteger g{gcd(norm(a), norm(b)), 0};
  if (g.re == 0) return {};
  a = remainder(a, g);
  b = remainder(b, g);
  return first_quadrant(euclid(euclid(g, a), b));
}

NormFactor split_norm(const Integer& x) {
  if (x < 1) throw DomainError("split_norm: the number is not positive");
  NormFactor result{{1, 0}, 1};
  for (const auto& [base, exponent] : factors(x)) {
    const Integer root = pow(base, static_cast<unsigned>(exponent / 2));
    result.root = result.root * GaussianInteger{root, 0};
    if (exponent % 2 == 0) continue;
    if (const auto pi = prime_above(base))
      result.root = result.root * *pi;
    else
      result.rest *= base;
  }
  return result;
}

std::optional<GaussianInteger> easy_norm_root(const Integer& n) {
  static const std::vector<PrimeGroup> groups = prime_groups(largest_divisor);
  if (n == 0) return GaussianInteger{0, 0};
  if (n < 0) return std::nullopt;
  GaussianInteger root{1, 0};
  Integer rest = n;
  for (const PrimeGroup& group : groups) {
    const unsigned long residue = fmpz_fdiv_ui(n.raw(), group.product);
    for (const unsigned p : group.primes) {
      if (residue % p != 0) continue;
      unsigned exponent = 0;
      for (; rest % p == 0; rest /= p) ++exponent;
      if (exponent % 2 == 1 && p % 4 == 3) return std::nullopt;
      root = root * GaussianInteger{pow(Integer(p), exponent / 2), 0};
      if (exponent % 2 == 1) root = root * *prime_above(p);
    }
  }
  if (rest == 1) return root;
  if (const Integer square_root = sqrt(rest); square_root * square_root == rest)
    return root * GaussianInteger{square_root, 0};
  const auto pi = prime_above(rest);
  if (!pi) return std::nullopt;
  return root * *pi;
}

std::ostream& operator<<(std::ostream& out, const GaussianInteger& z) {
  return out << GaussianRational{z.re, z.im};
}

std::ostream& operator<<(std::ostream& out, const GaussianRational& z) {
  if (z.im == 0) return out << z.re;
  if (z.re != 0) out << z.re << (z.im < 0 ? " - " : " + ");
  if (z.re == 0 && z.im < 0) out << '-';
  if (const Rational size = abs(z.im); size != 1) out << size << '*';
  return out << 'i';
}

}  // namespace phrame
