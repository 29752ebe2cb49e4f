#include "phrame/ph/twist/frame_weight.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"

using namespace phrame;

namespace {

/// The quintic of [Peng, Pang, Pan 2023].
const Curve paper({from_bernstein({0, 0, 0}), from_bernstein({1, 2, 3}), from_bernstein({0, 1, -2}),
                   from_bernstein({2, -1, -1})});

void check_moment(const RealBall& moment, const Rational& truth, long digits) {
  CAPTURE(moment);
  CHECK(abs(moment.lower() - truth) < power_of_ten(-digits));
  CHECK(abs(moment.upper() - truth) < power_of_ten(-digits));
}

}  // namespace

TEST_CASE("frame weight: 1, and the speed, whose integral is the length 17/3") {
  const auto ones = weight_moments(paper, FrameWeight::one, 5, 100);
  for (long k = 0; k < 5; ++k)
    check_moment(ones[static_cast<std::size_t>(k)], Rational(1, k + 1), 25);
  check_moment(weight_moments(paper, FrameWeight::speed, 1, 100)[0], Rational(17, 3), 25);
}

// ∫|2t² − 1|tᵏ with a kink at √½, by hand: for k = 0 it is (2√2 − 1)/3, for k = 1 1/4.
TEST_CASE("frame weight: the speed has kinks where f changes its sign") {
  const Curve back({{1}, {}, {}, {}}, Polynomial{-1, 0, 2});
  const auto moments = weight_moments(back, FrameWeight::speed, 2, 100);
  const RealBall truth = divide(
      subtract(multiply(RealBall(2, 200), sqrt(RealBall(2, 200), 200), 200), RealBall(1, 200), 200),
      RealBall(3, 200), 200);
  check_moment(moments[0], truth.midpoint(), 25);
  check_moment(moments[1], Rational(1, 4), 25);
}

// By mpmath's quadrature of |(r′ × r″)·r‴|/(|r′ × r″||r′|³), divided at its kink 0.17394….
TEST_CASE("frame weight: |τκ|") {
  const auto moments = weight_moments(paper, FrameWeight::torsion_curvature, 17, 110);
  check_moment(moments[0], parse_rational("0.3185101263456932639514326059365167725741"), 30);
  check_moment(moments[1], parse_rational("0.1218197654975241820162187025329390980048"), 30);
  check_moment(moments[16], parse_rational("0.0004727527781400378804058508746942028771915"), 30);
}

// 10^100 times as large: |τκ| is less by 10^−200.
TEST_CASE("frame weight: |τκ| of huge curves") {
  const Rational c = power_of_ten(50);
  const auto& [u, v, p, q] = paper.preimage();
  const Curve huge({c * u, c * v, c * p, c * q});
  const RealBall moment = weight_moments(huge, FrameWeight::torsion_curvature, 1, 110)[0];
  check_moment(multiply(moment, RealBall(power_of_ten(200), 300), 300),
               parse_rational("0.3185101263456932639514326059365167725741"), 30);
}

// A = 1 + t²i + t³j + …: where g has a real factor it cancels, and what is left has a kink.
TEST_CASE("frame weight: |τκ| at an inflection") {
  const Polynomial x{Rational(-1, 2), 1};
  const Curve inflected({Polynomial{1}, x * x, Polynomial{1} + x * x * x, x * x});
  REQUIRE(rho(inflected.preimage())(Rational(1, 2)) == 0);
  const RealBall moment = weight_moments(inflected, FrameWeight::torsion_curvature, 1, 80)[0];
  // By sums over 4000 midpoints of the same quotient, in doubles.
  double sum = 0;
  const Polynomial triple = triple_product(inflected);
  const Polynomial s = sigma(inflected.preimage());
  const Polynomial r = rho(inflected.preimage());
  for (long k = 0; k < 4000; ++k) {
    const Rational t(2 * k + 1, 8000);
    const double speed = static_cast<double>(s(t));
    sum += std::abs(static_cast<double>(triple(t))) /
           (std::sqrt(static_cast<double>(r(t))) * std::pow(speed, 4)) / 4000;
  }
  CHECK(moment.radius() < power_of_two(-70));
  CHECK(approximate(moment) == doctest::Approx(sum).epsilon(1e-5));
}

TEST_CASE("frame weight: what |τκ| is not for") {
  const Curve plane({{1}, {}, {}, {0, 1}});
  CHECK_THROWS_WITH_AS(weight_moments(plane, FrameWeight::torsion_curvature, 1, 64),
                       "the weight |τκ| is 0 everywhere: the curve is plane", DomainError);
  const Polynomial x{-1, 3};
  const auto& [u, v, p, q] = paper.preimage();
  const Curve cusp({x * u, x * v, x * p, x * q});
  CHECK_THROWS_WITH_AS(weight_moments(cusp, FrameWeight::torsion_curvature, 1, 64),
                       "the weight |τκ| is infinite at t = 1/3: a cusp", DomainError);
  CHECK(with_primitive_preimage(cusp).multiplier() == x * x);
}
