#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"
#include "support/surds.hpp"

using namespace phrame;
using test::for_samples;
using test::norm;
using test::Random;
using test::value;

TEST_CASE("surd: square factors of 1, 2, 49, 72 and of the square of a large prime") {
  const auto split = [](const Integer& x) {
    const SquareFactor s = split_square(x);
    return std::pair(s.root, s.rest);
  };
  CHECK(split(1) == std::pair<Integer, Integer>(1, 1));
  CHECK(split(2) == std::pair<Integer, Integer>(1, 2));
  CHECK(split(49) == std::pair<Integer, Integer>(7, 1));
  CHECK(split(72) == std::pair<Integer, Integer>(6, 2));
  const Integer prime = (Integer(1) << 89U) - 1;
  CHECK(split(prime * prime * 3) == std::pair<Integer, Integer>(prime, 3));
  CHECK_THROWS_AS(split_square(0), DomainError);
}

TEST_CASE("surd: law: x = root²·rest, and no small square is left") {
  for_samples(200, [](Random& random) {
    const Integer x = random.integer(1, 100000);
    const SquareFactor s = split_square(x);
    CHECK(s.root * s.root * s.rest == x);
    for (long p = 2; p < 320; ++p) CHECK(s.rest % (p * p) != 0);
  });
}

TEST_CASE("surd: law: the quadratic root is one") {
  for_samples(200, [](Random& random) {
    const Polynomial p{random.rational(), random.rational(), random.integer(1, 9)};
    const Rational discriminant =
        p.coefficient(1) * p.coefficient(1) - 4 * p.coefficient(0) * p.coefficient(2);
    if (square_root(discriminant)) {
      CHECK_THROWS_AS(quadratic_root(p), DomainError);
      return;
    }
    // p(a + b√d) = p(a) + c₂·b²·d + (p′(a)·b)·√d.
    const QuadraticNumber x = quadratic_root(p);
    CHECK(x.b > 0);
    CHECK(p(x.a) + p.coefficient(2) * x.b * x.b * Rational(x.d) == 0);
    CHECK(differentiate(p)(x.a) == 0);
  });
  CHECK(quadratic_root({-3, 2}) == QuadraticNumber{Rational(3, 2), 0, 1});
  CHECK_THROWS_AS(quadratic_root({1, 1, 1, 1}), DomainError);
}

namespace {

/// A number of ℚ(√2, √3, √5), often of a smaller field.
Surd random_surd(Random& random, const std::vector<long>& radicands) {
  Surd x(random.rational());
  for (const long d : radicands)
    if (random.chance(2)) x.add(random.rational(), d);
  return x;
}

}  // namespace

TEST_CASE("surd: law: arithmetic in ℚ(√d) is that of ℚ[x]/(x² − d)") {
  for_samples(200, [](Random& random) {
    const Integer d(random.integer(2, 3));
    const Surd x{random.rational(), random.rational(), d};
    const Surd y{random.rational(), random.rational(), d};
    const auto polynomial = [&](const Surd& s) {
      return Polynomial{s.rational_part(), s.is_rational() ? Rational(0) : s.terms().at(d)};
    };
    const Polynomial modulus{-Rational(d), 0, 1};
    CHECK(polynomial(x + y) == polynomial(x) + polynomial(y));
    CHECK(polynomial(x - y) == polynomial(x) - polynomial(y));
    CHECK(polynomial(x * y) == (polynomial(x) * polynomial(y)) % modulus);
    if (!y.is_zero()) CHECK(polynomial((x / y) * y) == polynomial(x));
    const Rational a = x.rational_part();
    if (!x.is_rational()) CHECK(norm(x) == a * a - Rational(d) * x.terms().at(d) * x.terms().at(d));
  });
  CHECK_THROWS_AS(Surd(1) / Surd(0), DomainError);
  CHECK_THROWS_AS(Surd(0, 1, -2), DomainError);
  CHECK_THROWS_AS(Surd(0, 1, 0), DomainError);
}

TEST_CASE("surd: law: arithmetic with several roots is that of the real numbers, and a field's") {
  constexpr long bits = 300;
  for_samples(200, [](Random& random) {
    const std::vector<long> radicands = {2, 3, 5, 6, 10, 15, 30};
    const Surd x = random_surd(random, radicands);
    const Surd y = random_surd(random, radicands);
    CHECK(value(x + y, bits).overlaps(add(value(x, bits), value(y, bits), bits)));
    CHECK(value(x * y, bits).overlaps(multiply(value(x, bits), value(y, bits), bits)));
    if (!y.is_zero()) CHECK((x / y) * y == x);
    CHECK(norm(x * y - y * x) == 0);
    // The square of a difference has the sign of a square, and 0 only for 0.
    CHECK(sign((x - y) * (x - y)) == (x == y ? 0 : 1));
    const RealBall ball = value(x, bits);
    CHECK(sign(x) == (x.is_zero() ? 0 : arb_is_positive(ball.raw()) != 0 ? 1 : -1));
    if (!x.is_zero()) CHECK_FALSE(ball.contains_zero());
  });
}

// (√2 + √3 + √5)² = 10 + 2√6 + 2√10 + 2√15; the norm of √2 + √3 + √5 is the constant term of its
// minimal polynomial x⁸ − 40x⁶ + 352x⁴ − 960x² + 576 [a classical example, with the coefficients by
// SymPy's minimal_polynomial].
TEST_CASE("surd: √2 + √3 + √5") {
  const Surd x = Surd(0, 1, 2) + Surd(0, 1, 3) + Surd(0, 1, 5);
  CHECK(x * x == Surd(10) + Surd(0, 2, 6) + Surd(0, 2, 10) + Surd(0, 2, 15));
  CHECK(norm(x) == 576);
  CHECK(evaluate({576, 0, -960, 0, 352, 0, -40, 0, 1}, x).is_zero());
  CHECK(field_of(x).radicands().size() == 8);
  CHECK(field_of(x * x).radicands().size() == 4);
  CHECK(sign(x - Surd(Rational(538, 100))) == 1);  // 5.3823…
  CHECK(sign(x - Surd(Rational(539, 100))) == -1);
  CHECK(norm(surd_polynomial({-x, Surd(1)})) == Polynomial{576, 0, -960, 0, 352, 0, -40, 0, 1});
}

// √75 = 5√3; that two integers differ by a square is seen without their factors.
TEST_CASE("surd: roots of numbers that differ by a square are one root") {
  const Integer p = (Integer(1) << 89U) - 1;  // primes
  const Integer q = (Integer(1) << 107U) - 1;
  const Surd x(0, 1, 3 * p * p * q);
  CHECK(x - Surd(0, Rational(p), 3 * q) == Surd(0));
  CHECK((x + Surd(0, 1, 3 * q)).terms().size() == 1);
  CHECK(x * Surd(0, 1, 3 * q) == Surd(Rational(3 * p * q)));
  CHECK(Surd(0, 1, 75) + Surd(0, -5, 3) == Surd(0));
  CHECK(Surd(0, 1, 49) == Surd(7));
  CHECK_FALSE(x == Surd(0, Rational(p), 3 * q + 1));
}
