#include "phrame/algebra/ball_series.hpp"

#include "support/random.hpp"

namespace ball_series_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 160;
constexpr long length = 9;

Polynomial first_coefficients(const Polynomial& p) { return p % Polynomial::monomial(1, length); }

/// Does every ball contain the coefficient of p, modulo t^length?
bool contains_series(const BallPolynomial& set, const Polynomial& p) {
  for (long k = 0; k < length; ++k)
    if (!set.coefficient(k).contains(p.coefficient(k))) return false;
  return set.degree_bound() < length;
}

/// A polynomial with the value `constant` at 0.
Polynomial random_series(Random& random, const Rational& constant) {
  return Polynomial{0, 1} * random.polynomial(10) + Polynomial{constant};
}

}  // namespace

TEST_CASE("ball series: law: products, quotients and roots, by multiplying back") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.polynomial(11);
    const Polynomial q = random_series(random, random.integer(1, 9));
    const BallPolynomial a(p, bits);
    const BallPolynomial b(q, bits);
    CHECK(contains_series(multiply_series(a, b, length, bits), first_coefficients(p * q)));
    const BallPolynomial quotient = divide_series(a, b, length, bits);
    CHECK(contains_series(multiply_series(quotient, b, length, bits), first_coefficients(p)));
    const BallPolynomial root = inverse_sqrt_series(b, length, bits);
    const BallPolynomial square = multiply_series(root, root, length, bits);
    CHECK(contains_series(multiply_series(square, b, length, bits), Polynomial{1}));
  });
}

TEST_CASE("ball series: law: cos² + sin² = 1, cos 0 = 1 and cos′ = −p′·sin") {
  for_samples(100, [](Random& random) {
    const BallPolynomial p(random_series(random, random.rational()), bits);
    const auto [cos, sin] = cos_sin_series(p, length, bits);
    const auto times = [](const BallPolynomial& f, const BallPolynomial& g) {
      return multiply_series(f, g, length - 1, bits);
    };
    CHECK(contains_series(add(times(cos, cos), times(sin, sin), bits), Polynomial{1}));
    const BallPolynomial slope = times(differentiate(p, bits), sin);
    CHECK(contains_series(add(differentiate(cos, bits), slope, bits), {}));
    CHECK(cos.coefficient(0).overlaps(cos_sin(p.coefficient(0), bits).cos));
  });
}

TEST_CASE("ball series: there is no quotient by 0 and no root of a negative number") {
  const BallPolynomial t(Polynomial{0, 1}, bits);
  CHECK_FALSE(divide_series(t, t, length, bits).coefficient(0).is_finite());
  CHECK_FALSE(inverse_sqrt_series(-BallPolynomial(Polynomial{1, 1}, bits), length, bits)
                  .coefficient(0)
                  .is_finite());
}

TEST_CASE("ball series: law: exp, log, atan, roots and powers, by going back") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random_series(random, random.rational());
    const Polynomial q = random_series(random, random.integer(1, 9));
    const BallPolynomial a(p, bits);
    const BallPolynomial b(q, bits);
    CHECK(contains_series(exp_series(log_series(b, length, bits), length, bits),
                          first_coefficients(q)));
    const BallPolynomial root = sqrt_series(b, length, bits);
    CHECK(contains_series(multiply_series(root, root, length, bits), first_coefficients(q)));
    CHECK(sign(root.coefficient(0)) > 0);
    const auto [cos, sin] = cos_sin_series(atan_series(a, length, bits), length, bits);
    CHECK(contains_series(divide_series(sin, cos, length, bits), first_coefficients(p)));
    CHECK(sign(cos.coefficient(0)) > 0);
    CHECK(contains_series(pow_series(a, 4, length, bits), first_coefficients(p * p * p * p)));
  });
}

TEST_CASE("ball series: no coefficient of a logarithm or root of what may be 0 is finite") {
  const BallPolynomial t(Polynomial{0, 1}, bits);
  for (long k = 0; k < length; ++k) {
    CHECK_FALSE(log_series(t, length, bits).coefficient(k).is_finite());
    CHECK_FALSE(sqrt_series(t, length, bits).coefficient(k).is_finite());
  }
}

TEST_CASE("ball series: one coefficient of a product") {
  const BallPolynomial p(Polynomial{1, 2, 3}, 64);
  const BallPolynomial q(Polynomial{5, 7, 11, 13}, 64);  // 5 + 17t + 40t² + 56t³ + 59t⁴ + 39t⁵
  CHECK(coefficient_of_product(p, q, 0, 64).contains(5));
  CHECK(coefficient_of_product(p, q, 3, 64).contains(56));
  CHECK(coefficient_of_product(q, p, 4, 64).contains(59));
  CHECK(coefficient_of_product(p, q, 5, 64).contains(39));
  CHECK(coefficient_of_product(p, q, 6, 64).is_zero());
  CHECK(coefficient_of_product(p, {}, 2, 64).is_zero());
  BallPolynomial r = p;
  set_coefficient(r, 4, RealBall(9, 64));
  CHECK(r.degree_bound() == 4);
  CHECK(r.coefficient(4).contains(9));
}

}  // namespace ball_series_test
