#include "phrame/algebra/numerical_integral.hpp"

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace numerical_integral_test {

using namespace phrame;

namespace {

constexpr long bits = 100;

}  // namespace

// ∫₁² log t dt = 2·log 2 − 1.
TEST_CASE("numerical integral: of a logarithm") {
  const auto f = [](const ComplexBall& z, long precision) { return log(z, precision); };
  const RealBall one(1, bits);
  const RealBall two(2, bits);
  const RealBall value = numerical_integral(f, one, two, {80, bits, 10'000});
  CHECK(value.overlaps(subtract(multiply(two, log(two, bits), bits), one, bits)));
  CHECK(value.radius() < power_of_two(-70));
  const RealBall back = numerical_integral(f, two, one, {80, bits, 10'000});
  CHECK(add(value, back, bits).contains_zero());
}

TEST_CASE("numerical integral: few values give a wide ball, an unknown function none") {
  const auto f = [](const ComplexBall& z, long precision) { return inverse(z, precision); };
  const RealBall near(power_of_two(-60), bits);
  const RealBall value = numerical_integral(f, near, RealBall(1, bits), {80, bits, 20});
  CHECK((!value.is_finite() || value.radius() > power_of_two(-60)));
  const auto unknown = [](const ComplexBall&, long) { return ComplexBall::unknown(); };
  CHECK_FALSE(numerical_integral(unknown, {}, RealBall(1, bits), {80, bits, 100}).is_finite());
}

}  // namespace numerical_integral_test
