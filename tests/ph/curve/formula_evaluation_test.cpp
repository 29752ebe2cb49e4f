#include "phrame/ph/curve/formula_evaluation.hpp"

#include "phrame/io/read/formula.hpp"
#include "support/random.hpp"

namespace formula_evaluation_test {

using namespace phrame;

namespace {

constexpr long bits = 128;

const std::vector<const char*> defined_near_two_fifths{"s^3 - 2*s",
                                                       "sin(s)*cos(3*s)",
                                                       "exp(-s^2/2)/(1 + s^2)",
                                                       "log(2 + s)*sqrt(1 + s)",
                                                       "atan(s/3)^2",
                                                       "(1 + s)^(-2/3)",
                                                       "tan(s)/7",
                                                       "s^-3",
                                                       "pi*s + 2^s",
                                                       "sqrt(s)",
                                                       "asin(s) + acos(s/2)",
                                                       "sinh(s)/cosh(s) - tanh(s)/2"};

BallPolynomial real_series(const char* text, const RealBall& s, long length) {
  return evaluate_steps(parse_formula(text, "s").value.steps(),
                        BallPolynomial({s, RealBall(1, bits)}), length, bits)
      .back();
}

ComplexSeries complex_series(const char* text, const ComplexBall& s, long length) {
  const ComplexBall one(RealBall(1, bits), {});
  return evaluate_steps(parse_formula(text, "s").value.steps(), ComplexSeries({s, one}), length,
                        bits)
      .back();
}

}  // namespace

TEST_CASE("formula evaluation: law: a Taylor series moved is the series there") {
  const RealBall at(Rational(2, 5), bits);
  const RealBall by(Rational(1, 1L << 30), bits);
  for (const char* text : defined_near_two_fifths) {
    CAPTURE(text);
    const BallPolynomial moved = shifted(real_series(text, at, 8), by, bits);
    const BallPolynomial there = real_series(text, add(at, by, bits), 3);
    for (long k = 0; k < 3; ++k) {  // what is left out is below 2^−30·6 times 2^30
      const RealBall slack = times_power_of_two(RealBall(1, bits), -30 * (8 - k) + 40);
      CHECK(widened(moved.coefficient(k), slack).overlaps(there.coefficient(k)));
      CHECK(there.coefficient(k).accuracy_bits() > 90);
    }
  }
}

TEST_CASE("formula evaluation: law: the values in a disc are in the ball around it") {
  const RealBall zero;
  const RealBall around = widened(zero, 0.0625);
  const RealBall at(Rational(2, 5), bits);
  const ComplexBall disc(add(at, around, bits), around);
  test::for_samples(20, [&](test::Random& random) {
    const RealBall x = add(at, RealBall(Rational(random.integer(-44, 44), 1024), bits), bits);
    const ComplexBall z(x, RealBall(Rational(random.integer(-44, 44), 1024), bits));
    for (const char* text : defined_near_two_fifths) {
      CAPTURE(text);
      const ComplexSeries all = complex_series(text, disc, 4);
      const ComplexSeries there = complex_series(text, z, 4);
      const ComplexSeries real = complex_series(text, ComplexBall(x, zero), 4);
      for (long k = 0; k < 4; ++k) {
        CHECK(all.coefficient(k).contains(there.coefficient(k)));
        CHECK(real.coefficient(k).re().overlaps(real_series(text, x, 4).coefficient(k)));
      }
    }
  });
}

TEST_CASE("formula evaluation: what is undefined is not finite, in any coefficient") {
  for (const char* text :
       {"1/s", "log(s)", "sqrt(s)", "s^(1/3)", "s^-1", "1/s - 1/s", "0/s", "log(-1 - s)"}) {
    CAPTURE(text);
    const BallPolynomial series = real_series(text, RealBall(), 3);
    for (long k = 0; k < 3; ++k) CHECK_FALSE(series.coefficient(k).is_finite());
  }
}

TEST_CASE("formula evaluation: across a branch cut nothing is finite") {
  const RealBall around = widened(RealBall(), 0.5);
  for (const char* text : {"log(s)", "sqrt(s)", "s^(2/3)"})
    CHECK_FALSE(complex_series(text, ComplexBall(RealBall(-1, bits), around), 2)
                    .coefficient(1)
                    .re()
                    .is_finite());
  const ComplexBall two_i(around, RealBall(2, bits));
  CHECK_FALSE(complex_series("atan(s)", two_i, 2).coefficient(1).re().is_finite());
}

}  // namespace formula_evaluation_test
