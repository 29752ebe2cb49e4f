#include "phrame/algebra/gaussian_polynomial.hpp"

#include "phrame/algebra/error.hpp"
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
