#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

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
    const Surd x = quadratic_root(p);
    CHECK(x.b > 0);
    CHECK(p(x.a) + p.coefficient(2) * x.b * x.b * Rational(x.d) == 0);
    CHECK(differentiate(p)(x.a) == 0);
  });
  CHECK(quadratic_root({-3, 2}) == Surd{Rational(3, 2), 0, 1});
  CHECK_THROWS_AS(quadratic_root({1, 1, 1, 1}), DomainError);
}

TEST_CASE("surd: law: arithmetic is that of ℚ[x]/(x² − d)") {
  for_samples(200, [](Random& random) {
    const Integer d(random.integer(2, 3));
    const Surd x{random.rational(), random.rational(), d};
    const Surd y{random.rational(), random.rational(), d};
    const auto polynomial = [](const Surd& s) { return Polynomial{s.a, s.b}; };
    const Polynomial modulus{-Rational(d), 0, 1};
    CHECK(polynomial(x + y) == polynomial(x) + polynomial(y));
    CHECK(polynomial(x - y) == polynomial(x) - polynomial(y));
    CHECK(polynomial(x * y) == (polynomial(x) * polynomial(y)) % modulus);
    if (!(norm(y) == 0)) CHECK(polynomial((x / y) * y) == polynomial(x));
    CHECK(x * conjugate(x) == Surd{norm(x), 0, 1});
    // The sign is that of the root next to it.
    const Rational root =
        d == 2 ? Rational(Integer("14142135623730950488"), Integer("10000000000000000000"))
               : Rational(Integer("17320508075688772935"), Integer("10000000000000000000"));
    const Rational near = x.a + x.b * root;
    CHECK(sign(x) == (near > 0 ? 1 : near < 0 ? -1 : 0));
  });
  CHECK_THROWS_AS((Surd{0, 1, 2} + Surd{0, 1, 3}), DomainError);
  CHECK_THROWS_AS((Surd{1, 0} / Surd{0, 0}), DomainError);
}
