#include "phrame/algebra/gaussian_integer.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

bool divides(const GaussianInteger& b, const GaussianInteger& a) {
  const GaussianInteger c = a * conjugate(b);
  return c.re % norm(b) == 0 && c.im % norm(b) == 0;
}

Integer rest(const Integer& x) {
  const NormFactor s = split_norm(x);
  CHECK(norm(s.root) * s.rest == x);
  return s.rest;
}

}  // namespace

TEST_CASE("gaussian integer: (2 + i)² = 3 + 4i, and 2 + i is its gcd with 5") {
  CHECK(GaussianInteger{2, 1} * GaussianInteger{2, 1} == GaussianInteger{3, 4});
  CHECK(gcd(GaussianInteger{3, 4}, {5, 0}) == GaussianInteger{2, 1});
  CHECK(gcd(GaussianInteger{3, -4}, {5, 0}) == GaussianInteger{1, 2});  // i(2 − i)
  CHECK(gcd(GaussianInteger{0, 0}, {0, -7}) == GaussianInteger{7, 0});
  CHECK(gcd(GaussianInteger{0, 0}, {0, 0}) == GaussianInteger{0, 0});
  for (const auto& a : {GaussianInteger{3, 0}, GaussianInteger{0, 3}, GaussianInteger{-3, 0},
                        GaussianInteger{0, -3}})
    CHECK(first_quadrant(a) == GaussianInteger{3, 0});
  for (const auto& a : {GaussianInteger{3, 2}, GaussianInteger{-2, 3}, GaussianInteger{-3, -2},
                        GaussianInteger{2, -3}})
    CHECK(first_quadrant(a) == GaussianInteger{3, 2});
}

TEST_CASE("gaussian integer: law: the gcd divides both, and c goes through it") {
  for_samples(200, [](Random& random) {
    const long size = random.chance(4) ? 1'000'000'000'000'000 : 30;
    const auto integer = [&] {
      return GaussianInteger{random.integer(-size, size), random.integer(-size, size)};
    };
    const GaussianInteger a = integer();
    const GaussianInteger b = integer();
    const GaussianInteger c = integer();
    const GaussianInteger g = gcd(a, b);
    CHECK(g == first_quadrant(g));
    CHECK(gcd(b, a) == g);
    CHECK(gcd(a * c, b * c) == first_quadrant(g * c));
    if (norm(g) == 0) return;
    CHECK(divides(g, a));
    CHECK(divides(g, b));
  });
}

TEST_CASE("split_norm: law: up to 2000, rest is 1 just for sums of two squares, found by trial") {
  for (long x = 1; x <= 2000; ++x) {
    bool is_sum = false;
    for (long a = 0; a * a <= x; ++a)
      for (long b = 0; a * a + b * b <= x; ++b) is_sum = is_sum || a * a + b * b == x;
    CAPTURE(x);
    const Integer left = rest(x);
    CHECK((left == 1) == is_sum);
    for (long p = 2; p < 50; ++p) CHECK(left % (p * p) != 0);
    for (const long p : {2, 5, 13, 17, 29, 37, 41}) CHECK(left % p != 0);
  }
}

// 10¹² + 39 ≡ 3 and 10¹² + 61 ≡ 1 mod 4 are prime, and so are 2¹²⁷ − 1 ≡ 3 and 2⁶⁴ − 59 ≡ 1 mod 4.
TEST_CASE("split_norm: large primes, their products and squares") {
  const Integer three = Integer("1000000000039");
  const Integer one = Integer("1000000000061");
  const Integer mersenne = (Integer(1) << 127U) - 1;
  const Integer word = (Integer(1) << 64U) - 59;
  CHECK(rest(one) == 1);
  CHECK(rest(three) == three);
  CHECK(rest(one * three) == three);
  CHECK(rest(3 * one * 49) == 3);
  CHECK(rest(word) == 1);
  CHECK(rest(mersenne) == mersenne);
  CHECK(rest(mersenne * mersenne * 2) == 1);
  CHECK(rest(mersenne * mersenne * 7) != 1);
  CHECK_THROWS_AS(split_norm(0), DomainError);
  CHECK_THROWS_AS(split_norm(-5), DomainError);
}

TEST_CASE(
    "easy norm root: law: |z|² = n, and there is one for all sums of two squares up to 4000") {
  for (long n = 0; n <= 4000; ++n) {
    bool is_sum = false;
    for (long a = 0; a * a <= n; ++a) {
      const long b = std::lround(std::sqrt(static_cast<double>(n - a * a)));
      is_sum = is_sum || a * a + b * b == n;
    }
    CAPTURE(n);
    const auto root = easy_norm_root(n);
    CHECK(root.has_value() == is_sum);
    if (root) CHECK(norm(*root) == n);
  }
}

// The primes are those above; 10009 ≡ 1 and 10007 ≡ 3 mod 4 are primes above 10000.
TEST_CASE("easy norm root: with a large prime or a square, but not with two") {
  const Integer three = Integer("1000000000039");
  const Integer one = Integer("1000000000061");
  const auto check = [](const Integer& n) {
    const auto root = easy_norm_root(n);
    REQUIRE(root.has_value());
    CHECK(norm(*root) == n);
  };
  check(one);
  check(one * 2 * 9 * 5 * 9973);
  check(three * three * 13);
  check(one * one);
  for (const Integer& n : {three, Integer(3 * one), Integer(three * 10007), Integer(one * 10009),
                           Integer(-5), Integer(9967 * one)})
    CHECK(!easy_norm_root(n).has_value());
}
