#include "phrame/algebra/ball_log.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 100;

RealBall real(const Rational& x) { return {x, bits}; }

}  // namespace

TEST_CASE("ball log: law: log xy = log x + log y, and the imaginary part is the argument") {
  for_samples(200, [](Random& random) {
    const Rational x = abs(random.rational()) + Rational(1, 1000);
    const Rational y = abs(random.rational()) + Rational(1, 1000);
    const RealBall sum = add(log(real(x), bits), log(real(y), bits), bits);
    CHECK(log(real(x * y), bits).overlaps(sum));
    CHECK(log1p(real(x), bits).overlaps(log(real(1 + x), bits)));

    const ComplexBall z(real(x), real(random.rational()));
    const ComplexBall w = log(z, bits);
    CHECK(w.im().overlaps(argument(z, bits)));
    CHECK(w.re().overlaps(log(absolute(z, bits), bits)));
    const ComplexBall one_more(add(z.re(), real(1), bits), z.im());
    CHECK(log1p(z, bits).overlaps(log(one_more, bits)));
  });
}

// log(1 + x) = x − x²/2 + …
TEST_CASE("ball log: log1p keeps the digits of what is small") {
  const Rational tiny = power_of_two(-1000);
  CHECK(log1p(real(tiny), bits).accuracy_bits() > 90);
  CHECK(log1p(real(tiny), bits).overlaps(real(tiny)));
  CHECK(log1p(ComplexBall({}, real(tiny)), bits).im().accuracy_bits() > 90);
}

TEST_CASE("ball log: 0 has no logarithm, and −1 has πi") {
  CHECK_FALSE(log(RealBall(), bits).is_finite());
  CHECK_FALSE(log(ComplexBall(), bits).re().is_finite());
  CHECK(log(ComplexBall(real(-1), {}), bits).im().overlaps(pi(bits)));
}
