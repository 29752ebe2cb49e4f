#include "phrame/ph/construct/exact_end.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Vector<Rational> integral(const QuadraticPreimage& a) {
  const Curve curve(
      {from_bernstein({a[0].u, a[1].u, a[2].u}), from_bernstein({a[0].v, a[1].v, a[2].v}),
       from_bernstein({a[0].p, a[1].p, a[2].p}), from_bernstein({a[0].q, a[1].q, a[2].q})});
  return evaluate(position(curve), 1);
}

/// Multiples of 2^−bits up to about 1.5; u + qk for the plane.
RationalQuaternion random_quaternion(Random& random, long bits, bool is_plane) {
  const auto x = [&] {
    return rounded_to_places(Rational(random.integer(-1'000'000, 1'000'000), 654'321), bits);
  };
  return is_plane ? RationalQuaternion{x(), 0, 0, x()} : RationalQuaternion{x(), x(), x(), x()};
}

Rational distance(const RationalQuaternion& a, const RationalQuaternion& b) {
  return std::max({abs(a.u - b.u), abs(a.v - b.v), abs(a.p - b.p), abs(a.q - b.q)});
}

}  // namespace

TEST_CASE("exact end: two halves of A have the integral that is wanted, as a fraction") {
  for_samples(6, [](Random& random) {
    const long bits = random.chance(2) ? 52 : 135;
    const auto quaternion = [&] { return random_quaternion(random, bits, false); };
    const QuadraticPreimage a{quaternion(), quaternion(), quaternion()};
    Vector<Rational> wanted = integral(a);
    for (Rational& x : wanted) x += Rational(random.integer(-99, 99), 7) * power_of_two(-bits);
    const auto [first, second] = exact_halves(a, wanted, bits);
    const Vector<Rational> before = integral(first);
    const Vector<Rational> after = integral(second);
    for (std::size_t k = 0; k < 3; ++k) CHECK((before[k] + after[k]) / 2 == wanted[k]);
    // The rest of A is where it was.
    const auto mean = [](const Rational& x, const Rational& y) { return Rational((x + y) / 2); };
    const auto between = [&](const RationalQuaternion& x, const RationalQuaternion& y) {
      return RationalQuaternion{mean(x.u, y.u), mean(x.v, y.v), mean(x.p, y.p), mean(x.q, y.q)};
    };
    const RationalQuaternion left = between(a[0], a[1]);
    const RationalQuaternion right = between(a[1], a[2]);
    CHECK(first[0] == a[0]);
    CHECK(first[2] == between(left, right));
    CHECK(second[0] == first[2]);
    CHECK(second[2] == a[2]);
    CHECK(distance(first[1], left) < power_of_two(16 - bits));
    CHECK(distance(second[1], right) < power_of_two(16 - bits));
  });
}

TEST_CASE("exact end: plane halves stay in the plane and have the integral that is wanted") {
  for_samples(20, [](Random& random) {
    constexpr long bits = 52;
    const auto quaternion = [&] { return random_quaternion(random, bits, true); };
    const QuadraticPreimage a{quaternion(), quaternion(), quaternion()};
    Vector<Rational> wanted = integral(a);
    wanted[0] += Rational(3, 7) * power_of_two(-bits);
    wanted[1] -= Rational(5, 7) * power_of_two(-bits);
    const auto [first, second] = exact_halves(a, wanted, bits);
    const Vector<Rational> before = integral(first);
    const Vector<Rational> after = integral(second);
    CHECK(before[2] == 0);
    for (std::size_t k = 0; k < 3; ++k) CHECK((before[k] + after[k]) / 2 == wanted[k]);
    CHECK(distance(first[0], a[0]) == 0);
    CHECK(distance(second[2], a[2]) == 0);
    const RationalQuaternion left{(a[0].u + a[1].u) / 2, 0, 0, (a[0].q + a[1].q) / 2};
    CHECK(distance(first[1], left) < power_of_two(16 - bits));
  });
}

TEST_CASE("exact end: two quaternions have the sum of vectors that is wanted") {
  for_samples(6, [](Random& random) {
    constexpr long bits = 60;
    const QuaternionPair near{random_quaternion(random, bits, false),
                              random_quaternion(random, bits, false)};
    Vector<Rational> c = rotated_i(near.x) + rotated_i(near.y);
    for (Rational& part : c) part += Rational(random.integer(-99, 99), 7) * power_of_two(-bits);
    const auto [a, b] = exact_pair(near, c, bits);
    CHECK(rotated_i(a) + rotated_i(b) == c);
    CHECK(distance(a, near.x) < power_of_two(16 - bits));
    CHECK(distance(b, near.y) < power_of_two(16 - bits));
  });
}

// With c = (k/59, …) and the other coordinates without 59 in the denominator, all R of one frame
// have that prime to an odd power.
TEST_CASE("exact end: where a prime bars one view, another one is taken") {
  constexpr long bits = 60;
  Random random(59);
  for (const long prime : {59L, 2741L}) {
    const QuaternionPair near{random_quaternion(random, bits, false),
                              random_quaternion(random, bits, false)};
    const RationalQuaternion u{Rational(2, 5), Rational(1, 5), Rational(2, 5), Rational(4, 5)};
    const Vector<Rational> sum = rotated_i(near.x) + rotated_i(near.y);
    const RationalQuaternion seen =
        u * RationalQuaternion{0, sum[0], sum[1], sum[2]} * conjugate(u);
    const Rational grid = prime * power_of_two(bits);
    const RationalQuaternion rounded{0, Rational(floor(seen.v * grid) / prime * prime + 1) / grid,
                                     rounded_to_places(seen.p, bits),
                                     rounded_to_places(seen.q, bits)};
    const RationalQuaternion c = conjugate(u) * rounded * u;
    const auto [a, b] = exact_pair(near, {c.v, c.p, c.q}, bits);
    CHECK(rotated_i(a) + rotated_i(b) == Vector<Rational>{c.v, c.p, c.q});
    CHECK(distance(a, near.x) < power_of_two(20 - bits));
  }
}

TEST_CASE("exact end: numbers that are too long are refused at once") {
  Random random(1);
  constexpr long bits = 3000;
  const QuaternionPair near{random_quaternion(random, 60, false),
                            random_quaternion(random, 60, false)};
  Vector<Rational> c = rotated_i(near.x) + rotated_i(near.y);
  for (Rational& part : c) part += Rational(1, 7) * power_of_two(-bits);
  CHECK_THROWS_AS(exact_pair(near, c, bits), Undecided);
}

TEST_CASE("exact end: six parts of A have the integral that is wanted, and A' is continuous") {
  for_samples(6, [](Random& random) {
    const bool is_plane = random.chance(2);
    constexpr long bits = 60;
    const auto quaternion = [&] { return random_quaternion(random, bits, is_plane); };
    const QuadraticPreimage a{quaternion(), quaternion(), quaternion()};
    Vector<Rational> wanted = integral(a);
    wanted[0] += Rational(3, 7) * power_of_two(-bits);
    const auto parts = exact_sixths(a, wanted, bits);
    Vector<Rational> sum{};
    for (const QuadraticPreimage& part : parts) sum = sum + Rational(1, 6) * integral(part);
    CHECK(sum == wanted);
    CHECK(parts.front()[0] == a[0]);
    CHECK(parts.back()[2] == a[2]);
    CHECK(Rational(6) * (parts.front()[1] - parts.front()[0]) == a[1] - a[0]);
    CHECK(Rational(6) * (parts.back()[2] - parts.back()[1]) == a[2] - a[1]);
    for (std::size_t k = 1; k < 6; ++k) {
      CHECK(parts[k - 1][2] == parts[k][0]);
      CHECK(parts[k - 1][2] - parts[k - 1][1] == parts[k][1] - parts[k][0]);
      CHECK(distance(parts[k][1],
                     Rational(static_cast<long>((5 - k) * (6 - k)), 36) * a[0] +
                         Rational(static_cast<long>(k * (5 - k) + (k + 1) * (6 - k)), 36) * a[1] +
                         Rational(static_cast<long>(k * (k + 1)), 36) * a[2]) <
            power_of_two(16 - bits));
    }
  });
}

TEST_CASE(
    "exact end: halves of a quartic A have the integral that is wanted, and A' is continuous") {
  for_samples(6, [](Random& random) {
    const bool is_plane = random.chance(2);
    constexpr long bits = 60;
    const auto quaternion = [&] { return random_quaternion(random, bits, is_plane); };
    const QuarticPreimage a{quaternion(), quaternion(), quaternion(), quaternion(), quaternion()};
    const auto end = [](const QuarticPreimage& b) {
      return evaluate(position(Curve(from_bernstein(std::vector(b.begin(), b.end())))), 1);
    };
    Vector<Rational> wanted = end(a);
    CHECK(phrame::integral(a) == wanted);
    wanted[1] += Rational(3, 7) * power_of_two(-bits);
    const auto [first, second] = exact_halves(a, wanted, bits);
    CHECK(Rational(1, 2) * (end(first) + end(second)) == wanted);
    const QuaternionPolynomial whole = from_bernstein(std::vector(a.begin(), a.end()));
    CHECK(first[0] == a[0]);
    CHECK(first[4] == evaluate(whole, Rational(1, 2)));
    CHECK(second[0] == first[4]);
    CHECK(second[4] == a[4]);
    CHECK(Rational(2) * (first[1] - first[0]) == a[1] - a[0]);
    CHECK(Rational(2) * (second[4] - second[3]) == a[4] - a[3]);
    CHECK(first[4] - first[3] == second[1] - second[0]);
    CHECK(
        distance(evaluate(from_bernstein(std::vector(first.begin(), first.end())), Rational(1, 2)),
                 evaluate(whole, Rational(1, 4))) < power_of_two(16 - bits));
  });
}
