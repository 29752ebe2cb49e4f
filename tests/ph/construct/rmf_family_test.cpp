#include "phrame/ph/construct/rmf_family.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "support/random.hpp"

namespace phrame::inline v0 {
namespace {

using test::Random;

RationalQuaternion quaternion(Random& random, long places) {
  const auto number = [&] {
    return Rational(random.integer(-(1L << places), 1L << places)) * power_of_two(-places);
  };
  return {number(), number(), number(), number()};
}

QuaternionPolynomial polynomial(const CubicPreimage<Rational>& a) {
  const auto component = [&](Rational RationalQuaternion::*part) {
    return from_bernstein({a[0].*part, a[1].*part, a[2].*part, a[3].*part});
  };
  return {component(&RationalQuaternion::u), component(&RationalQuaternion::v),
          component(&RationalQuaternion::p), component(&RationalQuaternion::q)};
}

long longest(const CubicPreimage<Rational>& a) {
  long bits = 0;
  for (const RationalQuaternion& x : a)
    for (const Rational* c : {&x.u, &x.v, &x.p, &x.q})
      bits = std::max({bits, bit_length(numerator(*c)), bit_length(denominator(*c))});
  return bits;
}

/// Is 3x an integer over a power of 2?
bool is_third_of_dyadic(const Rational& x) {
  const Integer d = denominator(3 * x);
  return d == Integer(1) << static_cast<unsigned long>(bit_length(d) - 1);
}

TEST_CASE("RM-ERF septics: whatever the numbers, h is 0 and the ends are those given") {
  test::for_samples(60, [](Random& random) {
    const long places = random.integer(1, 50);
    const RationalQuaternion a0 = quaternion(random, places);
    const RationalQuaternion a3 = quaternion(random, places);
    if (norm(a0) == 0 || norm(a3) == 0) return;
    const RmfFamily family(a0, a3);
    for (int k = 0; k < 3; ++k) {
      const CubicPreimage<Rational> a =
          family.member(quaternion(random, 30), quaternion(random, 30), random.integer(20, 80));
      CHECK(a[0] == a0);
      CHECK(a[3] == a3);
      CHECK(twist_numerator(polynomial(a)).is_zero());
      for (const RationalQuaternion& x : a)
        for (const Rational* c : {&x.u, &x.v, &x.p, &x.q}) CHECK(is_third_of_dyadic(*c));
    }
  });
}

TEST_CASE("RM-ERF septics: a member of the family is next to itself, and the numbers are short") {
  test::for_samples(30, [](Random& random) {
    const long places = 50;
    const RmfFamily family(quaternion(random, places), quaternion(random, places));
    const CubicPreimage<Rational> a =
        family.member(quaternion(random, 30), quaternion(random, 30), 60);
    for (const long bits : {30L, 100L}) {
      const CubicPreimage<Rational> near = family.member(a[1], a[2], bits);
      for (const std::size_t k : {1U, 2U}) {
        const RationalQuaternion off = near[k] - a[k];
        // Rounded are a, b and c; of the entries and their products some are greater than 1.
        CHECK(norm(off) < power_of_two(24 - 2 * bits) * std::max(Rational(1), norm(a[k])));
      }
      CHECK(longest(near) < 3 * bits + 2 * places + 40);
    }
  });
}

TEST_CASE("RM-ERF septics: the ends of plane curves have plane ones, and those of loops some") {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    // u + qk is the plane of x and y.
    RationalQuaternion a0 = quaternion(random, 40);
    RationalQuaternion a3 = quaternion(random, 40);
    a0.v = a0.p = a3.v = a3.p = 0;
    const CubicPreimage<Rational> a = RmfFamily(a0, a3).member(a0, a3, 50);
    for (const RationalQuaternion& x : a) {
      CHECK(x.v == 0);
      CHECK(x.p == 0);
    }
  }
  // The tangents are the same, but the frame comes back turned.
  const RationalQuaternion a0{1, 2, 3, 4};
  const RationalQuaternion turned_end = a0 * RationalQuaternion{3, 4, 0, 0};
  const CubicPreimage<Rational> loop =
      RmfFamily(a0, turned_end).member({1, 1, 0, 2}, {0, 1, 1, 5}, 40);
  CHECK(twist_numerator(polynomial(loop)).is_zero());
  CHECK_THROWS_AS(RmfFamily(a0, Rational(3) * a0), DomainError);
  CHECK_THROWS_AS(RmfFamily(a0, {}), DomainError);
}

}  // namespace
}  // namespace phrame
