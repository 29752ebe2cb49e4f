#include <algorithm>

#include "phrame/integrate/short_integral.hpp"

#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// Is the radius ≤ 2^−bits times the number, however small that is?
bool is_relatively_accurate(const RealBall& x, long bits) {
  return x.radius() * power_of_two(bits) <= std::min(abs(x.lower()), abs(x.upper()));
}

}  // namespace

TEST_CASE("short integral: of 1/(1 + t²) it is an arctangent, relatively as accurate as asked") {
  for (const char* text : {"1e-3", "-1e-50", "1e-3000", "1e-100000"}) {
    const Rational t = parse_rational(text);
    const auto value = short_integral({{1}, {1, 0, 1}}, Rational(0), t, 170);
    REQUIRE(value);
    CHECK(is_relatively_accurate(*value, 170));
    RealBall expected(t, 400);
    arb_atan(expected.raw(), expected.raw(), 400);
    CHECK(value->overlaps(expected));
  }
}

TEST_CASE("short integral: zeros of the integrand at the end make it smaller, not less accurate") {
  // ∫ (t − 1/3)⁷ from 1/3 to 1/3 + h over 1 + (t − 1/3) is h⁸/8·(1 − 8h/9 + …).
  const Polynomial zero{Rational(-1, 3), 1};
  const Rational h = parse_rational("1e-500");
  const auto value =
      short_integral({pow(zero, 7), zero + Polynomial{1}}, Rational(1, 3), Rational(1, 3) + h, 100);
  REQUIRE(value);
  CHECK(is_relatively_accurate(*value, 100));
  Rational power = h;
  for (int k = 0; k < 3; ++k) power *= power;
  const Rational leading = power / 8;
  CHECK(abs(value->midpoint() / leading - 1) < power_of_two(-99));
}

TEST_CASE("short integral: between algebraic ends") {
  // ∫ dt/t from √2 to √(2 + δ) is log(1 + δ/2)/2 = δ/4·(1 − δ/4 + …).
  const Rational delta = parse_rational("1e-300");
  const Endpoint a = real_root({-2, 0, 1}, closed_interval(1, 2));
  const Endpoint b = real_root({-2 - delta, 0, 1}, closed_interval(1, 2));
  const auto value = short_integral({{1}, {0, 1}}, a, b, 100);
  REQUIRE(value);
  CHECK(is_relatively_accurate(*value, 100));
  CHECK(abs(value->midpoint() * 4 / delta - 1) < power_of_two(-99));
  CHECK(short_integral({{1}, {0, 1}}, a, a, 100)->contains(0));
}

TEST_CASE("short integral: where terms cancel to 0 it is as accurate as they are") {
  // An odd integrand around 1/2, from 1/2 − h to 1/2 + h.
  const Rational h = parse_rational("1e-100");
  const RationalFunction odd({Rational(-1, 2), 1}, {Rational(5, 4), -1, 1});
  const auto value = short_integral(odd, Rational(1, 2) - h, Rational(1, 2) + h, 100);
  REQUIRE(value);
  CHECK(value->contains(0));
  CHECK(value->radius() < h * h * power_of_two(-98));
}

TEST_CASE("short integral: there is none where poles are near, or at an end") {
  const Rational h = parse_rational("1e-100");
  CHECK_FALSE(short_integral({{1}, {1, 0, 1}}, Rational(0), Rational(1), 60));
  CHECK_FALSE(short_integral({{1}, {h * h, 0, 1}}, Rational(0), h, 60));
  CHECK_FALSE(short_integral({{1}, {0, 1}}, Rational(0), h, 60));
  CHECK(short_integral({{1}, {h * h, 0, 1}}, Rational(0), h * h, 60));
}

TEST_CASE("short integral: law: it is what the poles and residues give") {
  for_samples(80, [](Random& random) {
    const RationalFunction f(random.polynomial(6), random.repeated_polynomial(2));
    const Rational a = random.chance(3) ? Rational(0) : random.rational();
    if (f.denominator()(a) == 0) return;
    const Rational h = random.rational() * power_of_two(-random.integer(20, 300));
    const auto value = short_integral(f, a, a + h, 80);
    if (!value) return;
    CHECK(value->is_accurate(80));
    Evaluator evaluator(integrate(f), f);
    evaluator.set_route(Route::roots);
    CHECK(value->overlaps(evaluator.difference(a, a + h, 3000)));
  });
}
