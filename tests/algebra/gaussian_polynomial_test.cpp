#include "phrame/algebra/gaussian_polynomial.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/modular.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("gaussian polynomial: i² = −1 and (1 + it)(1 − it) = 1 + t²") {
  const GaussianPolynomial i{{}, {1}};
  CHECK(i * i == GaussianPolynomial{{-1}, {}});
  const GaussianPolynomial a{{1}, {0, 1}};
  CHECK(a * conjugate(a) == GaussianPolynomial{{1, 0, 1}, {}});
  CHECK(norm(a) == Polynomial{1, 0, 1});
  CHECK(degree(a) == 1);
  CHECK(degree(GaussianPolynomial{}) == -1);
}

TEST_CASE("gaussian polynomial: law: product, conjugate, norm and derivative") {
  for_samples(100, [](Random& random) {
    const auto a = random.gaussian_polynomial(4);
    const auto b = random.gaussian_polynomial(4);
    CHECK(conjugate(a * b) == conjugate(a) * conjugate(b));
    CHECK(norm(a * b) == norm(a) * norm(b));
    CHECK(differentiate(a * b) == differentiate(a) * b + a * differentiate(b));
    CHECK(a + b - b == a);
    CHECK(b.re * a == GaussianPolynomial{b.re, {}} * a);
    if (is_zero(a)) return;
    const auto m = monic(a);
    const long n = degree(a);
    CHECK(m.re.coefficient(n) == 1);
    CHECK(m.im.coefficient(n) == 0);
    const GaussianPolynomial lead{{a.re.coefficient(n)}, {a.im.coefficient(n)}};
    CHECK(lead * m == a);
  });
  CHECK_THROWS_AS(monic({}), DomainError);
}

namespace {

/// Euclid's algorithm over ℚ(i), step by step.
GaussianPolynomial euclid(GaussianPolynomial a, GaussianPolynomial b) {
  while (!is_zero(b)) {
    const GaussianPolynomial divisor = monic(b);
    const long n = degree(divisor);
    for (long k = degree(a); k >= n; k = degree(a))
      a = a - GaussianPolynomial{Polynomial::monomial(a.re.coefficient(k), k - n),
                                 Polynomial::monomial(a.im.coefficient(k), k - n)} *
                  divisor;
    std::swap(a, b);
  }
  return is_zero(a) ? a : monic(a);
}

}  // namespace

TEST_CASE("gaussian gcd: (t + i)(t − 2i) and (t + i)(t + 3) share t + i, which t² + 4 does not") {
  const GaussianPolynomial common{{0, 1}, {1}};
  const GaussianPolynomial a = common * GaussianPolynomial{{0, 1}, {-2}};
  CHECK(gcd(a, common * GaussianPolynomial{{3, 1}, {}}) == common);
  CHECK(gcd(a, {{4, 0, 1}, {}}) == GaussianPolynomial{{0, 1}, {-2}});
  CHECK(gcd(a, {}) == a);
  CHECK(gcd({}, Polynomial{2} * a) == a);
  CHECK(gcd(GaussianPolynomial{}, {}) == GaussianPolynomial{});
  CHECK(gcd(a, {{}, {5}}) == GaussianPolynomial{{1}, {}});
  CHECK(exact_quotient(a, common) == GaussianPolynomial{{0, 1}, {-2}});
  CHECK_THROWS_AS(exact_quotient(a, {{4, 1}, {}}), DomainError);
  CHECK_THROWS_AS(exact_quotient(a, conjugate(common)), DomainError);
  CHECK_THROWS_AS(exact_quotient(a, {}), DomainError);
}

// Modulo p, t and t + p have a common root and pt + 1 has none.
TEST_CASE("gaussian gcd: primes that see too much or too little do no harm") {
  Primes primes;
  Integer p = 1;
  for (int k = 0; k < 4; ++k) p *= primes.next();
  const GaussianPolynomial common{{0, 1}, {1}};
  const GaussianPolynomial t{{0, 1}, {}};
  const GaussianPolynomial shifted{{Rational(p), 1}, {}};
  const GaussianPolynomial steep{{1, Rational(p)}, {}};
  CHECK(gcd(t, shifted) == GaussianPolynomial{{1}, {}});
  CHECK(gcd(t * common, shifted * common) == common);
  CHECK(gcd(t * steep, shifted * steep) == monic(steep));
}

// The factor needs several primes. The third sees one zero more in both maps, or, as p = |π|²
// divides t − (t + π) in one of the maps only, in one.
TEST_CASE("gaussian gcd: a prime that sees too much after others have not is left out") {
  Primes primes;
  ulong p = 0;
  for (int seen = 0; seen < 3;) {
    p = primes.next();
    if (p % 4 == 1) ++seen;
  }
  const GaussianInteger pi = split_norm(Integer(p)).root;
  const Rational large = parse_rational("1e120");
  const GaussianPolynomial common{{3, 1}, {large}};
  const GaussianPolynomial t{{0, 1}, {}};
  for (const auto& shift : {GaussianInteger{Integer(p), 0}, pi, conjugate(pi)}) {
    const GaussianPolynomial shifted{{Rational(shift.re), 1}, {Rational(shift.im)}};
    CHECK(gcd(t * common, shifted * common) == common);
  }
}

TEST_CASE("gaussian gcd: law: that of Euclid, also with a common factor and huge coefficients") {
  for_samples(60, [](Random& random) {
    const auto c = random.gaussian_polynomial(random.chance(3) ? 0 : 3);
    const auto a = random.gaussian_polynomial(3) * c;
    const auto b = random.gaussian_polynomial(3) * c;
    const GaussianPolynomial g = gcd(a, b);
    CHECK(g == euclid(a, b));
    CHECK(gcd(b, a) == g);
    if (is_zero(g)) return;
    CHECK(exact_quotient(a, g) * g == a);
    CHECK(exact_quotient(b, g) * g == b);
  });
}
