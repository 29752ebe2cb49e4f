#include "phrame/algebra/polynomial.hpp"

#include <climits>
#include <type_traits>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

static_assert(std::is_nothrow_move_constructible_v<Polynomial>);
static_assert(std::is_nothrow_move_assignable_v<Polynomial>);
static_assert(std::is_nothrow_swappable_v<Polynomial>);

TEST_CASE("polynomial: a moved-from one is 0, assigning to itself changes nothing") {
  Polynomial p{1, 2, 3};
  const Polynomial q = std::move(p);
  CHECK(p == Polynomial());  // NOLINT(bugprone-use-after-move): the promise under test
  Polynomial r = q;
  const Polynomial& same = r;
  r = same;
  CHECK(r == q);
  r += r;
  CHECK(r == Rational(2) * q);
  r -= q;
  CHECK(r == q);
}

TEST_CASE("polynomial: degree, coefficients and value of a known one") {
  const Polynomial p{Rational(1, 2), 0, -3};
  CHECK(p.degree() == 2);
  CHECK(p.coefficient(2) == -3);
  CHECK(p.coefficient(7) == 0);
  CHECK(p.coefficients() == std::vector<Rational>{Rational(1, 2), 0, -3});
  CHECK(p(Rational(1, 3)) == Rational(1, 6));
  CHECK(Polynomial().degree() == -1);
  CHECK(Polynomial{0, 0}.is_zero());
  CHECK(Polynomial::monomial(5, 3) == Polynomial{0, 0, 0, 5});
}

TEST_CASE("polynomial: law: values are a ring homomorphism") {
  for_samples(200, [](Random& random) {
    const Polynomial a = random.polynomial(6);
    const Polynomial b = random.polynomial(6);
    const Rational t = random.rational();
    CHECK((a + b)(t) == a(t) + b(t));
    CHECK((a - b)(t) == a(t) - b(t));
    CHECK((a * b)(t) == a(t) * b(t));
    CHECK((-a)(t) == -a(t));
    CHECK((t * a)(t) == t * a(t));
    CHECK(compose(a, b)(t) == a(b(t)));
    CHECK(pow(a, 3)(t) == a(t) * a(t) * a(t));
    CHECK(pow(a, 0) == Polynomial{1});
  });
  CHECK_THROWS_AS(pow(Polynomial{1, 1}, -1), DomainError);
}

TEST_CASE("polynomial: law: a = quotient·b + remainder with a small remainder") {
  for_samples(200, [](Random& random) {
    const Polynomial a = random.polynomial(9);
    const Polynomial b = random.nonzero_polynomial(5);
    const auto [quotient, remainder] = divide(a, b);
    CHECK(quotient * b + remainder == a);
    CHECK(remainder.degree() < b.degree());
    CHECK(a % b == remainder);
    CHECK(exact_quotient(a * b, b) == a);
  });
  CHECK_THROWS_AS(divide(Polynomial{1}, {}), DomainError);
  CHECK_THROWS_AS(Polynomial{1} % Polynomial(), DomainError);
  CHECK_THROWS_AS(exact_quotient(Polynomial{1, 0, 1}, Polynomial{1, 1}), DomainError);
}

TEST_CASE("polynomial: law: the gcd divides both, and cofactors have none") {
  for_samples(200, [](Random& random) {
    const Polynomial f = random.nonzero_polynomial(3);
    const Polynomial a = f * random.nonzero_polynomial(4);
    const Polynomial b = f * random.nonzero_polynomial(4);
    const Polynomial g = gcd(a, b);
    CHECK((g % f).is_zero());
    CHECK(gcd(exact_quotient(a, g), exact_quotient(b, g)) == Polynomial{1});
    CHECK(lcm(a, b) * g == a * b);
    CHECK(g == primitive_part(g));
  });
  CHECK(gcd(Polynomial(), Polynomial()).is_zero());
  CHECK(gcd(Polynomial(), Polynomial{-2, -4}) == Polynomial{1, 2});
}

TEST_CASE("polynomial: law: content times primitive part") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    CHECK(content(p) * primitive_part(p) == p);
    CHECK(primitive_part(p).leading_coefficient() >= 0);
    for (const Rational& c : primitive_part(p).coefficients()) CHECK(denominator(c) == 1);
  });
  CHECK(content(Polynomial{Rational(-4, 3), Rational(-2, 3)}) == Rational(-2, 3));
}

TEST_CASE("polynomial: law: derivative and antiderivative") {
  for_samples(200, [](Random& random) {
    const Polynomial a = random.polynomial(6);
    const Polynomial b = random.polynomial(6);
    CHECK(differentiate(antiderivative(a)) == a);
    CHECK(antiderivative(a)(0) == 0);
    CHECK(differentiate(a * b) == differentiate(a) * b + a * differentiate(b));
  });
}

TEST_CASE("polynomial: law: the squarefree part has the same roots, each once") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.repeated_polynomial(3);
    const Polynomial radical = squarefree_part(p);
    CHECK(is_squarefree(radical));
    CHECK((pow(radical, p.degree()) % p).is_zero());
    CHECK((p % radical).is_zero());
  });
  CHECK_FALSE(is_squarefree(pow(Polynomial{1, 1}, 2)));
  CHECK_THROWS_AS(squarefree_part({}), DomainError);
}

namespace {

/// Of so many words; not seldom with the factors of 720.
Rational long_integer(Random& random, long words) {
  Rational x = random.integer(1, 20);
  for (long k = 0; k < words; ++k) x = x * Rational(1L << 62) * 4 + random.integer(0, LONG_MAX);
  return random.chance(3) ? x * 720 : random.chance(6) ? Rational(0) : -x;
}

/// With coefficients as long, over one denominator.
Polynomial long_polynomial(Random& random, long degree, long words) {
  std::vector<Rational> c;
  for (long k = random.integer(0, degree); k >= 0; --k) c.push_back(long_integer(random, words));
  return Polynomial(c) * Polynomial{1 / (720 * abs(long_integer(random, words)) + 720)};
}

}  // namespace

// From 16 words on long coefficients beside short ones have ways of their own.
TEST_CASE("polynomial: law: long coefficients are multiplied, divided and listed like short ones") {
  for_samples(60, [](Random& random) {
    const Polynomial a = long_polynomial(random, 6, random.integer(12, 40));
    const Polynomial b = random.nonzero_polynomial(5);
    const Polynomial product = a * b;
    CHECK(product == b * a);
    const Rational t = random.rational();
    CHECK(product(t) == a(t) * b(t));
    CHECK(exact_quotient(product, b) == a);
    if (!a.is_zero()) CHECK(exact_quotient(product, a) == b);
    if (b.degree() > 0) {
      CHECK_THROWS_WITH_AS(exact_quotient(product + Polynomial{1}, b),
                           doctest::Contains("leaves a remainder of degree 0"), DomainError);
      CHECK(short_remainder(product + Polynomial{7}, b) == Polynomial{7});
      CHECK(short_remainder(a, b) == a % b);
    }
    const auto list = product.coefficients();
    REQUIRE(list.size() == static_cast<std::size_t>(product.degree() + 1));
    for (std::size_t k = 0; k < list.size(); ++k)
      CHECK(list[k] == product.coefficient(static_cast<long>(k)));  // both in lowest terms
  });
  CHECK_THROWS_AS(exact_quotient(Polynomial{1}, Polynomial{}), DomainError);
}

TEST_CASE("polynomial: law: a short remainder is the remainder, whether it is short or not") {
  for_samples(100, [](Random& random) {
    const Polynomial a = random.polynomial(8);
    const Polynomial b = random.nonzero_polynomial(4);
    CHECK(short_remainder(a, b) == a % b);
    const Polynomial short_one = random.polynomial(4) % b;  // the quotient is nearly integral
    const Polynomial sum = Rational(1, 6) * (a * b + short_one);
    CHECK(short_remainder(sum, b) == sum % b);
  });
  CHECK_THROWS_AS(short_remainder({1}, {}), DomainError);
}

TEST_CASE("polynomial: as text in messages") {
  CHECK(to_string(Polynomial{}) == "0");
  CHECK(to_string(Polynomial{Rational(-1, 2)}) == "-1/2");
  CHECK(to_string(Polynomial{3, -1, 0, Rational(2, 3)}) == "2/3*t^3 - t + 3");
  CHECK(to_string(Polynomial{0, 0, -1}) == "-t^2");
}

TEST_CASE("polynomial: the square root is exact, or there is none") {
  CHECK(square_root(Polynomial{1, -2, 1}) == Polynomial{-1, 1});
  CHECK(square_root(Polynomial{Rational(4, 9)}) == Polynomial{Rational(2, 3)});
  CHECK(square_root(Polynomial()) == Polynomial());
  for (const auto& p : {Polynomial{-1, 2, -1}, Polynomial{2, -4, 2}, Polynomial{0, 1},
                        Polynomial{1, 0, 1}, Polynomial{3}, Polynomial{-4}})
    CHECK_FALSE(square_root(p));
  for_samples(60, [](Random& random) {
    const Polynomial p = random.nonzero_polynomial(6);
    const Polynomial root = p.leading_coefficient() < 0 ? -p : p;
    CHECK(square_root(p * p) == root);
    CHECK_FALSE(square_root(p * p * Polynomial{1, 1}));
  });
}

TEST_CASE("polynomial: law: g = s·a + t·b") {
  for_samples(100, [](Random& random) {
    const Polynomial common = random.nonzero_polynomial(3);
    const Polynomial a = common * random.nonzero_polynomial(4);
    const Polynomial b = common * random.polynomial(4);
    const auto [g, s, t] = extended_gcd(a, b);
    CHECK(s * a + t * b == g);
    CHECK(primitive_part(g) == gcd(a, b));
    CHECK(g.leading_coefficient() == 1);
  });
}

TEST_CASE("polynomial: law: the least common denominator, and the numerator over it") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    Integer common = 1;
    for (const Rational& c : p.coefficients()) common = lcm(common, denominator(c));
    CHECK(denominator(p) == common);
    CHECK(to_polynomial(integer_numerator(p).get()) == Rational(common) * p);
    long bits = 0;
    const Polynomial q = primitive_part(p);
    for (const Rational& c : q.coefficients()) bits = std::max(bits, bit_length(numerator(c)));
    CHECK(primitive_bits(p) == bits);
  });
}
