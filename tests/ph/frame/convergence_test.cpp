#include "phrame/ph/frame/convergence.hpp"

#include <doctest/doctest.h>

using namespace phrame;

namespace convergence_test {
namespace {

StepError at(long n, const Rational& error) {
  return {static_cast<std::size_t>(n + 1), Rational(1, n), RealBall(error, 64)};
}

}  // namespace

// Errors 5·step³, by hand: the rates are 3 whatever the steps are.
TEST_CASE("convergence: the rate of errors c·stepᵖ is p, in any order of the tables") {
  const Convergence found = convergence({at(30, Rational(5, 27000)), at(10, Rational(5, 1000)),
                                         at(20, Rational(5, 8000)), at(20, Rational(5, 8000))});
  REQUIRE(found.steps.size() == 3);
  CHECK(found.steps.front().samples == 11);
  REQUIRE(found.rates.size() == 2);
  for (const auto& rate : found.rates) {
    REQUIRE(rate);
    CHECK(rate->contains(Rational(3)));
    CHECK(rate->upper() - rate->lower() < Rational(1, 1000000));
  }
  REQUIRE(found.order);
  CHECK(found.order->contains(Rational(3)));
}

TEST_CASE("convergence: errors of rounding have no rate") {
  const Rational tiny(1, 10'000'000'000'000);
  const Convergence found =
      convergence({at(10, Rational(1, 100)), at(20, Rational(1, 400)), at(40, tiny), at(80, tiny)});
  REQUIRE(found.rates.size() == 3);
  CHECK(found.order->contains(Rational(2)));
  CHECK_FALSE(found.rates[1]);
  CHECK_FALSE(found.rates[2]);
  CHECK_FALSE(convergence({at(10, Rational(1, 100))}).order);
  CHECK_FALSE(convergence({at(10, 0), at(20, 0)}).order);
  // Frames at one t have no step.
  const StepError one{1, Rational(0), RealBall(Rational(1, 8), 64)};
  CHECK_FALSE(convergence({at(10, Rational(1, 100)), one}).order);
}

TEST_CASE("convergence: the step is the greatest between neighbouring t, whatever their order") {
  const Vector<Rational> f2{0, 1, 0};
  FrameVerdict verdict;
  verdict.max_error = RealBall(Rational(1, 8), 64);
  const StepError found = step_error(
      {{Rational(1), f2}, {Rational(0), f2}, {Rational(1, 4), f2}, {Rational(1, 4), f2}}, verdict);
  CHECK(found.samples == 4);
  CHECK(found.step == Rational(3, 4));
  CHECK(found.error.contains(Rational(1, 8)));
}

}  // namespace convergence_test
