#include "phrame/algebra/complex_series.hpp"

#include "phrame/algebra/ball_series.hpp"
#include "support/random.hpp"

namespace complex_series_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 128;
constexpr long length = 6;

ComplexBall random_number(Random& random) {
  return {RealBall(random.rational(), bits), RealBall(random.rational(), bits)};
}

ComplexSeries random_complex_series(Random& random) {
  std::vector<ComplexBall> c;
  for (long k = 0; k < length; ++k) c.push_back(random_number(random));
  return ComplexSeries(c);
}

bool overlap(const ComplexSeries& p, const ComplexSeries& q) {
  for (long k = 0; k < length; ++k)
    if (!p.coefficient(k).overlaps(q.coefficient(k))) return false;
  return true;
}

bool is_finite(const ComplexSeries& p) {
  for (long k = 0; k < length; ++k)
    if (!p.coefficient(k).re().is_finite() || !p.coefficient(k).im().is_finite()) return false;
  return true;
}

ComplexSeries times(const ComplexSeries& p, const ComplexSeries& q) {
  return multiply_series(p, q, length, bits);
}

}  // namespace

TEST_CASE("complex series: law: quotients, roots, powers and logarithms, by going back") {
  for_samples(100, [](Random& random) {
    const ComplexSeries p = random_complex_series(random);
    const ComplexSeries q = random_complex_series(random);
    const ComplexSeries quotient = divide_series(p, q, length, bits);
    if (is_finite(quotient)) CHECK(overlap(times(quotient, q), p));
    const ComplexSeries root = sqrt_series(p, length, bits);
    if (is_finite(root)) CHECK(overlap(times(root, root), p));
    const ComplexSeries log = log_series(p, length, bits);
    if (is_finite(log)) CHECK(overlap(exp_series(log, length, bits), p));
    CHECK(overlap(pow_series(p, 3, length, bits), times(p, times(p, p))));
    const auto [cos, sin] = cos_sin_series(p, length, bits);
    const ComplexSeries one({ComplexBall(RealBall(1, bits), {})});
    CHECK(overlap(add(times(cos, cos), times(sin, sin), bits), one));
    CHECK(overlap(multiply(RealBall(2, bits), p, bits), add(p, p, bits)));
    const ComplexSeries angle = atan_series(p, length, bits);
    if (!is_finite(angle)) return;
    const auto turned = cos_sin_series(angle, length, bits);
    CHECK(overlap(times(turned.cos, p), turned.sin));
  });
}

TEST_CASE("complex series: p(z + t) is that of a polynomial at z, and what is left without p(z)") {
  for_samples(20, [](Random& random) {
    const Polynomial p = random.polynomial(9);
    const ComplexBall z = random_number(random);
    const ComplexSeries at = series_at(BallPolynomial(p, bits), z, length, bits);
    Polynomial derivative = p;
    Rational factorial = 1;
    for (long k = 0; k < length; ++k) {
      const ComplexBall expected =
          multiply(RealBall(1 / factorial, bits), evaluate(derivative, z, bits), bits);
      CHECK(at.coefficient(k).overlaps(expected));
      CHECK(without_constant(at).coefficient(k).is_same_ball(at.coefficient(k + 1)));
      derivative = differentiate(derivative);
      factorial *= k + 1;
    }
  });
}

TEST_CASE("complex series: on branch cuts and poles nothing is finite") {
  const auto around = [](const Rational& re, const Rational& im, double radius) {
    const ComplexBall wide(widened(RealBall(re, bits), radius),
                           widened(RealBall(im, bits), radius));
    return ComplexSeries({wide, ComplexBall(RealBall(1, bits), {})});
  };
  const auto infinite = [](const ComplexSeries& p) {
    for (long k = 0; k < length; ++k)
      if (p.coefficient(k).re().is_finite()) return false;
    return true;
  };
  CHECK(infinite(log_series(around(-1, 0, 0.1), length, bits)));
  CHECK(infinite(sqrt_series(around(-1, 0, 0.1), length, bits)));
  CHECK(infinite(log_series(around(0, 0, 0.1), length, bits)));
  CHECK(infinite(atan_series(around(0, 2, 0.1), length, bits)));
  CHECK(infinite(atan_series(around(0, -1, 0.1), length, bits)));
  CHECK(is_finite(log_series(around(-1, 1, 0.1), length, bits)));
  CHECK(is_finite(atan_series(around(0, Rational(1, 2), 0.1), length, bits)));
  CHECK(is_finite(atan_series(around(1, 2, 0.1), length, bits)));
}

}  // namespace complex_series_test
