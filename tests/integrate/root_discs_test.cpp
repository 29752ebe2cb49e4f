#include <algorithm>

#include "phrame/integrate/root_discs.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// |z − center| ≤ radius on the grid, for every number of the ball z.
bool holds(const GaussianInteger& center, const Integer& radius, long bits, const ComplexBall& z) {
  const Rational unit = power_of_two(-bits);
  const auto distance = [](const RealBall& x, const Rational& c) {
    return std::max(abs(x.lower() - c), abs(x.upper() - c));
  };
  const Rational x = distance(z.re(), center.re * unit);
  const Rational y = distance(z.im(), center.im * unit);
  return x * x + y * y <= radius * radius * unit * unit;
}

/// A polynomial without real roots, of even degree.
Polynomial rootless(Random& random) {
  Polynomial q{1};
  for (long k = random.integer(1, 4); k > 0; --k)
    q *= pow(random.polynomial(2), 2) + Polynomial{abs(random.rational()) + Rational(1, 7)};
  q = squarefree_part(q);
  return q.is_constant() ? Polynomial{1, 0, 1} : q;
}

}  // namespace

TEST_CASE("root discs: exact points are found as such") {
  // (t² + 1)(2t² − 2t + 1): i and (1 + i)/2; the residues of 1/q there are 1/q′.
  const auto discs = *root_discs({1, -2, 3, -2, 2}, {1}, 64);
  const Integer one = Integer(1) << 64;
  REQUIRE(discs.size() == 2);
  CHECK(discs[0].center == GaussianInteger{0, one});
  CHECK(discs[0].radius == 0);
  CHECK(discs[1].center == GaussianInteger{one / 2, one / 2});
  CHECK(discs[1].radius == 0);
  // q′(i) = 2i·(−1 − 2i) = 4 − 2i, 1/q′(i) = (2 + i)/10.
  CHECK(discs[0].residue.re == (one * 2 + 5) / 10);
  CHECK(discs[0].residue_radius > 0);
}

TEST_CASE("root discs: half way between two points of the grid the lower one is taken") {
  // i + 1/4, on a grid of halves: q = (t − 1/4)² + 1.
  const auto discs = *root_discs({17, -8, 16}, {1}, 1);
  CHECK(discs[0].center == GaussianInteger{0, 2});
}

TEST_CASE("root discs: a grid that is too coarse has none, a real root is refused") {
  const Rational near(1, 1 << 20);
  CHECK_FALSE(root_discs(primitive_part(Polynomial{near * near, 0, 1}), {1}, 10));
  CHECK(root_discs(primitive_part(Polynomial{near * near, 0, 1}), {1}, 40));
  CHECK_THROWS_AS(root_discs({-1, 0, 1}, {1}, 64), DomainError);
}

// The discs against enclosures of roots and residues that are far narrower.
TEST_CASE("root discs: law: each holds its root and residue, none more than it must") {
  for_samples(60, [](Random& random) {
    const Polynomial q = rootless(random);
    const Polynomial n = random.polynomial(q.degree() - 1);
    CAPTURE(to_string(q));
    CAPTURE(to_string(n));
    long bits = random.integer(40, 200);
    auto discs = root_discs(q, n, bits);
    while (!discs) discs = root_discs(q, n, bits *= 2);
    const Roots roots = isolate_roots(q, 4 * bits + 4000);
    REQUIRE(discs->size() == roots.upper.size());
    for (const RootDisc& disc : *discs) {
      long held = 0;
      for (const ComplexBall& z : roots.upper) {
        if (!holds(disc.center, disc.radius + 1, bits, z)) continue;
        ++held;
        if (disc.radius > 0) CHECK(holds(disc.center, disc.radius, bits, z));
        const long precision = 4 * bits + 2000;
        const ComplexBall c =
            divide(evaluate(n, z, precision), evaluate(differentiate(q), z, precision), precision);
        // An exact one is a point, which no ball is; one unit is as good a proof of its place.
        CHECK(holds(disc.residue, std::max(disc.residue_radius, Integer(1)), bits, c));
      }
      CHECK(held == 1);
      CHECK(disc.radius <= q.degree());  // the center is the nearest point of the grid
    }
  });
}

// (t − z)/(−z) at the true roots against the centers.
TEST_CASE("root discs: law: the error of the logarithms is bounded") {
  for_samples(40, [](Random& random) {
    const Polynomial q = rootless(random);
    const Polynomial n = random.polynomial(q.degree() - 1);
    long bits = 30;
    auto discs = root_discs(q, n, bits);
    while (!discs) discs = root_discs(q, n, bits *= 2);
    const Rational t = random.rational();
    constexpr long precision = 2000;
    const auto term = [&](const ComplexBall& z, const ComplexBall& c) {
      ComplexBall ratio;
      acb_sub_arb(ratio.raw(), z.raw(), RealBall(t, precision).raw(), precision);
      acb_div(ratio.raw(), ratio.raw(), z.raw(), precision);
      acb_log(ratio.raw(), ratio.raw(), precision);
      acb_mul(ratio.raw(), ratio.raw(), c.raw(), precision);
      return ratio.re();
    };
    RealBall off;
    const Rational unit = power_of_two(-bits);
    const auto point = [&](const GaussianInteger& z) {
      return ComplexBall(RealBall(z.re * unit, precision), RealBall(z.im * unit, precision));
    };
    for (const RootDisc& disc : *discs)
      off = subtract(off, term(point(disc.center), point(disc.residue)), precision);
    for (const ComplexBall& z : isolate_roots(q, precision).upper)
      off = add(off,
                term(z, divide(evaluate(n, z, precision), evaluate(differentiate(q), z, precision),
                               precision)),
                precision);
    CHECK(2 * std::max(abs(off.lower()), abs(off.upper())) <=
          log_error(*discs, bits, abs(t)) + power_of_two(-1000));
  });
}
