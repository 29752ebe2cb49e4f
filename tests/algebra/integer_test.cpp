#include "phrame/algebra/integer.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <type_traits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/multiprecision.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

static_assert(std::is_nothrow_move_constructible_v<Integer>);
static_assert(std::is_nothrow_move_assignable_v<Integer>);
static_assert(std::is_nothrow_move_constructible_v<Rational>);
static_assert(!std::is_convertible_v<bool, Integer>);
static_assert(!std::is_convertible_v<double, Rational>);

namespace {

/// Of one word or of several, of both signs, or 0.
Integer any(Random& random) {
  Integer x = random.integer(-100, 100);
  if (random.chance(2)) x = x * pow(Integer(10), 30) + random.integer(-1000, 1000);
  return x;
}

// Boost's sums are expressions until they are numbers.
std::string text(const boost::multiprecision::mpz_int& x) { return x.str(); }
std::string fraction(const boost::multiprecision::mpq_rational& x) { return x.str(); }

}  // namespace

TEST_CASE("integer: law: the arithmetic is that of GMP") {
  for_samples(300, [](Random& random) {
    const Integer a = any(random);
    const Integer b = any(random);
    const auto x = to_boost(a);
    const auto y = to_boost(b);
    CHECK((a + b).str() == text(x + y));
    CHECK((a - b).str() == text(x - y));
    CHECK((a * b).str() == text(x * y));
    CHECK((-a).str() == text(-x));
    CHECK(abs(a).str() == text(abs(x)));
    CHECK((a < b) == (x < y));
    CHECK((a == b) == (x == y));
    CHECK(a.sign() == x.sign());
    CHECK(gcd(a, b).str() == text(gcd(x, y)));
    CHECK(lcm(a, b).str() == text(lcm(x, y)));
    CHECK((a << 70).str() == text(x << 70));
    CHECK((abs(a) >> 5).str() == text(abs(x) >> 5));
    CHECK(Integer(a.str(16), 16) == a);
    CHECK(abs(a).str(16) == to_boost(abs(a)).str(0, std::ios_base::hex));
    CHECK(bit_length(a) == (a == 0 ? 0 : static_cast<long>(msb(abs(x))) + 1));
    if (b == 0) return;
    CHECK((a / b).str() == text(x / y));
    CHECK((a % b).str() == text(x % y));
    const Integer q = floor_quotient(a, b);
    CHECK(q * b + (a - q * b) == a);
    CHECK(abs(a - q * b) < abs(b));
    CHECK((a - q * b).sign() * b.sign() >= 0);
  });
}

TEST_CASE("integer: law: the arithmetic of fractions is that of GMP") {
  for_samples(300, [](Random& random) {
    const Rational a = random.rational();
    const Rational b = random.rational();
    const auto x = to_boost(a);
    const auto y = to_boost(b);
    CHECK((a + b).str() == fraction(x + y));
    CHECK((a - b).str() == fraction(x - y));
    CHECK((a * b).str() == fraction(x * y));
    CHECK((-a).str() == fraction(-x));
    CHECK((a < b) == (x < y));
    CHECK(numerator(a).str() == text(numerator(x)));
    CHECK(denominator(a).str() == text(denominator(x)));
    CHECK(static_cast<double>(a) == x.convert_to<double>());
    CHECK(Rational(floor(a)) <= a);
    CHECK(a < Rational(floor(a) + 1));
    if (b != 0) CHECK((a / b).str() == fraction(x / y));
  });
}

TEST_CASE("integer: powers and roots") {
  CHECK(pow(Integer(-3), 5) == -243);
  CHECK(pow(Integer(0), 0) == 1);
  for_samples(100, [](Random& random) {
    const Integer x = abs(any(random));
    const Integer root = sqrt(x);
    CHECK(root * root <= x);
    CHECK(x < (root + 1) * (root + 1));
  });
  CHECK_THROWS_AS(sqrt(Integer(-1)), DomainError);
}

TEST_CASE("integer: shifts to the right round down") {
  CHECK((Integer(-5) >> 1) == -3);
  CHECK((Integer(5) >> 1) == 2);
}

TEST_CASE("integer: division by 0 throws and says what was divided") {
  Integer x = 7;
  CHECK_THROWS_WITH_AS(x /= 0, "division of 7 by 0", DomainError);
  CHECK_THROWS_AS(x %= 0, DomainError);
  CHECK_THROWS_AS(floor_quotient(x, 0), DomainError);
  CHECK_THROWS_WITH_AS(Rational(7, 0), "division of 7 by 0", DomainError);
  CHECK_THROWS_WITH_AS(Rational(1, 2) / 0, "division of 1/2 by 0", DomainError);
  CHECK(x == 7);
}

TEST_CASE("integer: to and from the machine's integers, and text") {
  constexpr long least = std::numeric_limits<long>::min();
  constexpr auto greatest = std::numeric_limits<unsigned long>::max();
  CHECK(Integer(least).str() == "-9223372036854775808");
  CHECK(Integer(greatest).str() == "18446744073709551615");
  CHECK(static_cast<long>(Integer(least)) == least);
  CHECK_THROWS_AS(static_cast<void>(static_cast<long>(Integer(greatest))), DomainError);
  CHECK(Integer("-123456789012345678901234567890").str() == "-123456789012345678901234567890");
  CHECK(Integer("ff", 16) == 255);
  for (const std::string& text : {std::string("12x"), std::string(), std::string(" 12"),
                                  std::string("1 2"), std::string("+1"), std::string("12\0", 3)})
    CHECK_THROWS_AS(Integer{text}, InputError);
}

TEST_CASE("integer: copies are their own, what was moved from is 0, and an operand may be itself") {
  Integer a = pow(Integer(10), 40);
  const Integer& itself = a;
  const Integer b = a;
  a += itself;
  CHECK(a == 2 * b);
  a *= itself;
  CHECK(a == 4 * b * b);
  a -= itself;
  CHECK(a == 0);
  Integer c = b;
  const Integer d = std::move(c);
  CHECK(d == b);
  CHECK(c == 0);  // NOLINT(bugprone-use-after-move)
  Rational x(b, 3);
  const Rational& x_itself = x;
  x /= x_itself;
  CHECK(x == 1);
}

TEST_CASE("integer: law: residues are in [0, m), and an inverse is one, where there is one") {
  for_samples(300, [](Random& random) {
    const Integer x = any(random);
    const Integer m = abs(any(random)) + 1;
    const Integer residue = modulo(x, m);
    CHECK(residue >= 0);
    CHECK(residue < m);
    CHECK((x - residue) % m == 0);
    const auto inverse = inverse_modulo(x, m);
    CHECK(inverse.has_value() == (gcd(x, m) == 1));
    if (!inverse) return;
    CHECK(*inverse == modulo(*inverse, m));
    CHECK(modulo(x * *inverse, m) == modulo(1, m));
  });
  CHECK_THROWS_AS(modulo(5, 0), DomainError);
  CHECK_THROWS_AS(inverse_modulo(5, -7), DomainError);
}

TEST_CASE("integer: Euler's function counts what is coprime") {
  for (long n = 1; n <= 60; ++n) {
    unsigned long count = 0;
    for (long k = 1; k <= n; ++k) count += gcd(Integer(k), Integer(n)) == 1 ? 1 : 0;
    CHECK(euler_phi(static_cast<unsigned long>(n)) == count);
  }
}
