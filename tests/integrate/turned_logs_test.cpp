#include "phrame/integrate/turned_logs.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_log.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// The positive square root of x > 0.
RealAlgebraic root(const Rational& x) { return real_root(Polynomial{-x, 0, 1}, {0, std::nullopt}); }

}  // namespace

TEST_CASE("turned logs: over the whole line, known integrals") {
  const auto whole = [](const Polynomial& n, const Polynomial& d) {
    return turned_logs(simple_fractions(RationalFunction(n, d)), Infinity::negative,
                       Infinity::positive);
  };
  // ∫ 1/(x² + 1) = π, ∫ 1/(x⁴ + 1) = π/√2, ∫ x²/(x⁴ + x² + 1) = π/√3 [Gradshteyn, Ryzhik, 3.241].
  const auto circle = whole({1}, {1, 0, 1});
  REQUIRE(circle);
  CHECK(circle->sizes.empty());
  CHECK(circle->multiple == RealAlgebraic(1));
  const auto quartic = whole({1}, {1, 0, 0, 0, 1});
  REQUIRE(quartic);
  CHECK(quartic->multiple == root(Rational(1, 2)));
  const auto negative = whole({-1}, {2, 0, 1});
  REQUIRE(negative);
  CHECK(affine(negative->multiple, -1, 0) == root(Rational(1, 2)));
}

TEST_CASE("turned logs: to a place from which powers of the poles are rational") {
  // ∫₀¹ 1/(x² + 1) = π/4: (1 ∓ i)⁴ = −4. From 0 to 1/2 it is arctan(1/2), no multiple of π.
  const std::vector<SimpleFraction> circle{{{1}, {1, 0, 1}}};
  const auto quarter = turned_logs(circle, Rational(0), Rational(1));
  REQUIRE(quarter);
  CHECK(quarter->multiple == RealAlgebraic(Rational(1, 4)));
  CHECK(quarter->sizes.empty());
  CHECK_FALSE(turned_logs(circle, Rational(0), Rational(1, 2)));
  // ∫₀^∞ is half of the whole.
  const auto half = turned_logs(circle, Rational(0), Infinity::positive);
  REQUIRE(half);
  CHECK(half->multiple == RealAlgebraic(Rational(1, 2)));
}

TEST_CASE("turned logs: the sizes are those of the real part") {
  // ∫₀¹ x/(x² + 1) = log(2)/2, with |1 ∓ i|² = 2.
  const auto logs = turned_logs({SimpleFraction{{0, 1}, {1, 0, 1}}}, Rational(0), Rational(1));
  REQUIRE(logs);
  CHECK(logs->multiple == RealAlgebraic(0));
  RealBall sum;
  for (const Power& size : logs->sizes)
    sum =
        add(sum, multiply(RealBall(size.exponent, 100), log(RealBall(size.base.re, 100), 100), 100),
            100);
  const RealBall known = divide(log(RealBall(2, 100), 100), RealBall(2, 100), 100);
  CHECK(sum.overlaps(known));
}

TEST_CASE("turned logs: law: p/(x^2 + c) over the line is pi*p/sqrt(c)") {
  test::for_samples(20, [](test::Random& random) {
    const Rational c(random.integer(1, 40), random.integer(1, 9));
    const Rational p = random.rational();
    if (p == 0) return;
    const Rational shift = random.rational();
    const Polynomial x{shift, 1};
    const RationalFunction f(Polynomial{p}, x * x + Polynomial{c});
    const auto logs = turned_logs(simple_fractions(f), Infinity::negative, Infinity::positive);
    REQUIRE(logs);
    CHECK(logs->multiple == affine(root(p * p / c), p < 0 ? -1 : 1, 0));
  });
}
