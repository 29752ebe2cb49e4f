#include "phrame/ph/along/series_function.hpp"

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace series_function_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// 1/(c + t), by the series Σ (−z)ᵏ/(c + t)ᵏ⁺¹.
SeriesFunction reciprocal(const Rational& c) {
  return [c](const RealBall& t, long length, long bits) {
    const RealBall q = divide(RealBall(Rational(1), bits), add(RealBall(c, bits), t, bits), bits);
    std::vector<RealBall> series{q};
    while (static_cast<long>(series.size()) < length)
      series.push_back(subtract({}, multiply(series.back(), q, bits), bits));
    return BallPolynomial(std::move(series));
  };
}

}  // namespace

TEST_CASE("series_function: law: the integral of 1/(c + t) is a logarithm, to few bits and many") {
  for_samples(10, [](Random& random) {
    const Rational c = Rational(random.integer(1, 40), 16);
    const SeriesIntegral F(reciprocal(c), 0, 1);
    for (const long bits : {60L, 700L, 150L}) {
      const Rational t(random.integer(0, 64), 64);
      const RealBall found = F.enclose(RealBall(t, bits + 20), bits);
      const RealBall expected = log(RealBall(Rational(1 + t / c), bits + 40), bits + 40);
      CHECK(found.overlaps(expected));
      CHECK(found.is_accurate(bits - 4));
    }
  });
}

TEST_CASE("series_function: an integral up to a pole is undecided whenever it is asked for") {
  const SeriesIntegral F(reciprocal(Rational(-1, 2)), 0, 1);
  for (int k = 0; k < 2; ++k) CHECK_THROWS_AS(F.enclose(RealBall(Rational(1), 64), 60), Undecided);
}

}  // namespace series_function_test
