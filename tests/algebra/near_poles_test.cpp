#include "phrame/algebra/near_poles.hpp"

#include <array>
#include <cfenv>

#include "phrame/algebra/near_elementary.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace phrame::inline v0 {
namespace {

using test::for_samples;
using test::Random;

/// −2h and σ of a random preimage.
std::pair<Polynomial, Polynomial> random_rate(long degree, long height, Random& random) {
  const auto any = [&] {
    std::vector<Rational> c;
    for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-height, height));
    return Polynomial(c);
  };
  const Polynomial u = any();
  const Polynomial v = any();
  const Polynomial p = any();
  const Polynomial q = any();
  return {Rational(2) * (differentiate(u) * v - u * differentiate(v) + p * differentiate(q) -
                         differentiate(p) * q),
          u * u + v * v + p * p + q * q};
}

ComplexBall ball_of(const NearComplex& z) {
  return {phrame::ball_of(NearNumber{z.re, z.error}), phrame::ball_of(NearNumber{z.im, z.error})};
}

bool are_equal(const NearComplex& z, const NearComplex& w) {
  const auto parts = [](const NearComplex& x) {
    return std::array{x.re.high, x.re.low, x.im.high, x.im.low, x.error};
  };
  return parts(z) == parts(w);
}

/// Are they those that isolate_roots() and balls of 300 bits find?
void check_poles(const std::vector<NearPole>& found, const Polynomial& n, const Polynomial& d) {
  constexpr long bits = 300;
  const Roots roots = isolate_roots(d, bits);
  REQUIRE(roots.real.empty());
  REQUIRE(roots.upper.size() == found.size());
  for (const NearPole& pole : found) {
    long matches = 0;
    for (const ComplexBall& z : roots.upper) {
      if (!ball_of(pole.place).contains(z)) continue;
      ++matches;
      CHECK(ball_of(pole.inverse).contains(inverse(z, bits)));
      CHECK(ball_of(pole.residue)
                .contains(divide(evaluate(n, z, bits), evaluate(differentiate(d), z, bits), bits)));
    }
    CHECK(matches == 1);
  }
}

}  // namespace

TEST_CASE("near poles: law: they contain the poles and residues that balls find") {
  for_samples(60, [](Random& random) {
    const long height = random.chance(2) ? 9 : random.chance(2) ? 1'000'000 : 2'000'000'000;
    const auto [n, d] = random_rate(random.integer(1, 7), height, random);
    if (const auto found = near_poles(n, d)) check_poles(*found, n, d);
  });
}

TEST_CASE("near poles: those of curves with small coefficients are found, to 70 bits and more") {
  for_samples(60, [](Random& random) {
    const auto [n, d] = random_rate(random.integer(1, 10), 9, random);
    if (!is_squarefree(d)) return;
    const auto found = near_poles(n, d);
    REQUIRE(found);
    for (const NearPole& pole : *found) CHECK(ball_of(pole.place).accuracy_bits() > 70);
  });
}

TEST_CASE("near poles: fractions, next to the axis, and roots that n and d have in common") {
  const Polynomial i{1, 0, 1};
  for (const long k : {3, 8, 12}) {
    // (t − 1/3)² + 10⁻ᵏ
    const Polynomial near{Rational(1, 9) + Rational(1, pow(Integer(10), static_cast<ulong>(k))),
                          Rational(-2, 3), 1};
    const Polynomial n{Rational(1, 7), 5};
    const auto found = near_poles(n, near * i);
    REQUIRE(found);
    check_poles(*found, n, near * i);
    const auto common = near_poles(n * i, near * i);
    REQUIRE(common);
    check_poles(*common, n * i, near * i);
  }
}

TEST_CASE("near poles: a common factor of n and d, of whatever size, changes nothing") {
  const Polynomial n{3, 1, 4};
  const Polynomial d = Polynomial{3, 0, 1} * Polynomial{5, -2, 1};
  for (const long k : {-2000, -400, 400, 2000}) {
    const Rational c = 3 * power_of_two(k);
    const auto found = near_poles(c * n, c * d);
    REQUIRE(found);
    check_poles(*found, n, d);
  }
}

TEST_CASE("near poles: residues that are equal, or conjugate ones, are not distinct") {
  const auto are_distinct = [](const Polynomial& n, const Polynomial& d) {
    const auto poles = near_poles(n, d);
    REQUIRE(poles);
    return have_distinct_residues(*poles);
  };
  const Polynomial d{3, 0, 1, 0, 1};
  CHECK(are_distinct({1, 2}, d));
  CHECK_FALSE(are_distinct({0, 2}, d));  // at z and at −z, so that at −z̄ it is the conjugate
  CHECK_FALSE(are_distinct(differentiate(d), d));  // all are 1
}

TEST_CASE("near poles: none where doubles do not prove them") {
  const Polynomial i{1, 0, 1};
  const Polynomial n{1, 1};
  CHECK_FALSE(near_poles(n, i * i));
  CHECK_FALSE(near_poles(n, i * Polynomial{-2, 0, 1}));
  CHECK_FALSE(near_poles(n, i * Polynomial{0, 0, 1}));
  CHECK_FALSE(near_poles(n, Polynomial{1, 1}));
  CHECK_FALSE(near_poles(n, Polynomial{1}));
  // A pair 10⁻⁴⁰ apart, and coefficients that overflow.
  const Rational tiny(1, pow(Integer(10), 80));
  CHECK_FALSE(near_poles(n, i * i + Polynomial{tiny}));
  CHECK_FALSE(near_poles(n, i * Polynomial{Rational(pow(Integer(10), 400)), 0, 1}));
  CHECK_FALSE(near_poles(n, pow(i, 2) * Polynomial::monomial(1, 61) + i));
}

TEST_CASE("near poles: the same in any rounding mode") {
  const Polynomial d{5, -2, 3, 1, 7};
  const Polynomial n{1, 2, 3};
  const auto found = near_poles(n, d);
  std::fesetround(FE_UPWARD);
  const auto upward = near_poles(n, d);
  const bool is_kept = std::fegetround() == FE_UPWARD;
  std::fesetround(FE_TONEAREST);
  CHECK(is_kept);
  REQUIRE(upward);
  for (std::size_t k = 0; k < found->size(); ++k) {
    CHECK(are_equal((*upward)[k].place, (*found)[k].place));
    CHECK(are_equal((*upward)[k].residue, (*found)[k].residue));
  }
}

}  // namespace phrame
