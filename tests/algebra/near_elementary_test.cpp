#include "phrame/algebra/near_elementary.hpp"

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/rational.hpp"
#include "support/random.hpp"

namespace phrame::inline v0 {
namespace {

using test::for_samples;
using test::Random;

constexpr long ball_bits = 300;

Rational sum_of(const DoubleDouble& x) { return exact_rational(x.high) + exact_rational(x.low); }

/// A number of two doubles of about this size, known to 2^−100 or exactly.
NearNumber any_number(Random& random, int exponent) {
  const double high =
      std::ldexp(static_cast<double>(random.integer(-1L << 53, 1L << 53)), exponent - 53);
  const double low = high * 0x1p-53 * static_cast<double>(random.integer(-1000, 1000)) / 1024;
  return {two_sum(high, low), random.chance(2) ? std::abs(high) * 0x1p-100 : 0};
}

/// A number that x may be, at an end of what it may be or between.
Rational any_of(const NearNumber& x, Random& random) {
  return sum_of(x.value) + exact_rational(x.error) * Rational(random.integer(-1, 1));
}

/// Is the number of the ball within what x may be?
bool contains(const NearNumber& x, const RealBall& of) {
  const RealBall off = absolute(subtract(of, RealBall(sum_of(x.value), ball_bits), ball_bits));
  return off.upper() <= exact_rational(x.error);
}

}  // namespace

TEST_CASE(
    "near elementary: law: balls as pairs of doubles, cosine, sine and root contain those of "
    "balls") {
  for_samples(2000, [](Random& random) {
    const NearNumber x = any_number(random, static_cast<int>(random.integer(-60, 19)));
    const Rational at = any_of(x, random);
    const CosSin turn = cos_sin(RealBall(at, ball_bits), ball_bits);
    const NearCosSin found = cos_sin(x);
    CHECK(contains(found.cos, turn.cos));
    CHECK(contains(found.sin, turn.sin));
    CHECK(found.cos.error <= x.error + 0x1p-94 * (1 + std::abs(x.value.high)));
    CHECK(contains(near_number(turn.cos), turn.cos));
    const NearNumber root = inverse_root(
        {{std::abs(x.value.high), x.value.high < 0 ? -x.value.low : x.value.low}, x.error});
    if (x.value.high == 0) return;
    CHECK(contains(root, divide(RealBall(1, ball_bits),
                                sqrt(RealBall(abs(at), ball_bits), ball_bits), ball_bits)));
    CHECK(root.error <= 0x1p-96 * root.value.high);
  });
}

TEST_CASE(
    "near elementary: law: logarithms contain those of balls, near 1 and near their cut, too") {
  for_samples(2000, [](Random& random) {
    const int exponent = static_cast<int>(random.integer(-200, 200));
    NearNumber re = any_number(random, exponent);
    NearNumber im = any_number(random, exponent - static_cast<int>(random.integer(0, 40)));
    if (random.chance(3)) re = {{1.0, re.value.high * 0x1p-260}, 0};
    if (im.value.high == 0) return;
    const NearComplex z{re.value, im.value, re.error + im.error};
    const ComplexBall truth = log(
        ComplexBall(RealBall(sum_of(re.value), ball_bits), RealBall(sum_of(im.value), ball_bits)),
        ball_bits);
    const NearComplex found = log(z);
    REQUIRE(std::isfinite(found.error));
    CHECK(contains({found.re, found.error}, truth.re()));
    CHECK(contains({found.im, found.error}, truth.im()));
    const double size = std::hypot(re.value.high, im.value.high);
    CHECK(found.error <= 2 * z.error / size + 0x1p-95 * (2 + std::abs(found.re.high)));
  });
}

TEST_CASE("near elementary: what is of no use is not finite") {
  CHECK_FALSE(std::isfinite(log(NearComplex{{-1}, {}, 0}).error));
  CHECK_FALSE(std::isfinite(log(NearComplex{{-1}, {0x1p-80}, 0x1p-80}).error));
  CHECK_FALSE(std::isfinite(log(NearComplex{}).error));
  CHECK_FALSE(std::isfinite(cos_sin(NearNumber{{0x1p30}}).cos.error));
  CHECK_FALSE(std::isfinite(inverse_root(NearNumber{}).error));
  CHECK_FALSE(std::isfinite(near_number(RealBall::unknown()).error));
}

}  // namespace phrame
