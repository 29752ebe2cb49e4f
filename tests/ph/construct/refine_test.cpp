#include "phrame/ph/construct/refine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

using List = std::vector<Rational>;

/// x² + y² = 3, x·y = 1: x is the golden ratio, y its inverse.
List golden_defect(const List& v) { return {v[0] * v[0] + v[1] * v[1] - 3, v[0] * v[1] - 1}; }
const JacobianRows golden_jacobian{{2 * 1.618, 2 * 0.618}, {0.618, 1.618}};

/// With the least change that a step can be.
RefinedParameters refine(List parameters, const ExactDefect& defect, const JacobianRows& jacobian,
                         long bits) {
  return phrame::refine(std::move(parameters), defect, least_change(jacobian, 1e-10), bits);
}

bool is_within(const RefinedParameters& result, const Rational& tolerance) {
  return std::ranges::all_of(result.defect, [&](const Rational& x) { return abs(x) <= tolerance; });
}

bool is_multiple(const Rational& x, long bits) { return denominator(x * power_of_two(bits)) == 1; }

TEST_CASE(
    "refine: the parameters are multiples of 2^-bits, and the rounding is all that they lack") {
  for (const long bits : {20L, 60L, 200L, 1000L}) {
    CAPTURE(bits);
    const RefinedParameters found =
        refine({Rational(1618, 1000), Rational(618, 1000)}, golden_defect, golden_jacobian, bits);
    for (const Rational& x : found.parameters) CHECK(is_multiple(x, bits));
    CHECK(found.defect == golden_defect(found.parameters));
    // |J·δ| with every |δ| ≤ 2^−bits/2, and the step less than half way on.
    CHECK(is_within(found, 16 * power_of_two(-bits)));
    // (1 + √5)/2, whose square is 1 more.
    const Rational& x = found.parameters[0];
    CHECK(abs(x * x - x - 1) < 64 * power_of_two(-bits));
  }
}

TEST_CASE("refine: of many solutions the nearest one is taken") {
  // x + 2y = 5 from the origin: (1, 2).
  const auto defect = [](const List& v) { return List{v[0] + 2 * v[1] - 5}; };
  const RefinedParameters found = refine({0, 0}, defect, JacobianRows{{1, 2}}, 80);
  CHECK(abs(found.parameters[0] - 1) < power_of_two(-78));
  CHECK(abs(found.parameters[1] - 2) < power_of_two(-78));
}

TEST_CASE("refine: defects beyond the range of doubles are brought into it") {
  for (const long e : {-2000L, 2000L}) {
    const Rational size = power_of_two(e);
    const auto defect = [&](const List& v) { return List{size * (v[0] - Rational(1, 3))}; };
    // A J of size 2^e is no double, but the change it says may be given.
    const ParameterStep step = [](const std::vector<double>& d) { return std::vector{d[0]}; };
    const auto scaled = [&](const List& v) { return List{defect(v)[0] / size}; };
    CHECK(is_within(phrame::refine({0}, scaled, step, 100), power_of_two(-100)));
    // Parameters far below 1, too.
    const auto tiny = [&](const List& v) { return List{v[0] - size / 3}; };
    CHECK(is_within(refine({0}, tiny, JacobianRows{{1}}, 100 - e), power_of_two(e - 100)));
  }
}

TEST_CASE("refine: what does not help is not taken") {
  const List start{Rational(1618, 1000), Rational(618, 1000)};
  const List rounded_start{rounded_to_places(start[0], 30), rounded_to_places(start[1], 30)};
  const JacobianRows opposite{{-2 * 1.618, -2 * 0.618}, {-0.618, -1.618}};
  CHECK(refine(start, golden_defect, opposite, 30).parameters == rounded_start);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refine(start, golden_defect, JacobianRows{{nan, nan}, {nan, nan}}, 30).parameters ==
        rounded_start);
  const ParameterStep nowhere = [&](const std::vector<double>&) { return std::vector{nan, nan}; };
  CHECK(phrame::refine(start, golden_defect, nowhere, 30).parameters == rounded_start);
  CHECK(refine(start, golden_defect, JacobianRows{{0, 0}, {0, 0}}, 30).parameters == rounded_start);
  const ExactDefect fails = [](const List&) -> List { throw DomainError("a pole"); };
  CHECK_THROWS_AS(refine(start, fails, golden_jacobian, 30), DomainError);
}

TEST_CASE("refine: what is met stays") {
  const auto zero = [](const List&) { return List{0}; };
  CHECK(refine({Rational(1, 4)}, zero, JacobianRows{{1}}, 2).parameters == List{Rational(1, 4)});
}

}  // namespace
}  // namespace phrame
