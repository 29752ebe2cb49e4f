#include "phrame/ph/along/frame_angle.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("frame angle: law: of a direction it is the principal argument") {
  for_samples(200, [](Random& random) {
    const GaussianRational z{random.rational(), random.rational()};
    if (z.re == 0 && z.im == 0) return;
    const FrameAngle angle = angle_of(z);
    CHECK((angle.direction.re > 0 || (angle.direction.re == 0 && angle.direction.im > 0)));
    CHECK(to_real(angle).enclose(100).overlaps(argument(z.re, z.im, 100)));
  });
  CHECK(angle_of(GaussianRational{-2, 0}) == FrameAngle{1, 0, {2, 0}});
  CHECK(angle_of(GaussianRational{0, -3}) == FrameAngle{-1, 0, {0, 3}});
  CHECK(to_real(angle_of(GaussianRational{5, 0})).exact() == Rational(0));
  CHECK_THROWS_AS(angle_of(GaussianRational{}), DomainError);
}

// r′ of the quintic of 2003 at 0 is (4, 4, 2); its Euler–Rodrigues frame there is rational.
TEST_CASE("frame angle: a vector is projected to the normal plane") {
  const Frame<Rational> erf = euler_rodrigues_frame(test::quintic, 0);
  CHECK(angle_of(erf.e2, erf) == FrameAngle{0, 0, {1, 0}});
  CHECK(angle_of(erf.e3, erf) == FrameAngle{0, 0, {0, 1}});
  Vector<Rational> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = 7 * erf.e1[k] - 2 * erf.e2[k] + 3 * erf.e3[k];
  CHECK(angle_of(v, erf) == FrameAngle{1, 0, {2, -3}});
  CHECK_THROWS_AS(angle_of(erf.e1, erf), DomainError);
}

TEST_CASE("frame angle: over pi, where that is rational; differences") {
  CHECK(over_pi({Rational(3, 7), 0}) == Rational(3, 7));
  CHECK(over_pi({Rational(1, 3), 0, {0, 5}}) == Rational(5, 6));
  CHECK(over_pi({0, 0, {2, 2}}) == Rational(1, 4));
  CHECK(over_pi({0, 0, {3, -3}}) == Rational(-1, 4));
  CHECK_FALSE(over_pi({0, 0, {2, 1}}));       // the root of unity would have order 8
  CHECK_FALSE(over_pi({0, Rational(1, 7)}));  // e^{i/7} is transcendental
  CHECK(over_pi(difference({Rational(1, 2), 0, {1, 2}}, {0, 0, {1, 2}})) == Rational(1, 2));
  CHECK(over_pi(difference({0, 3}, {2, 3})) == Rational(-2));
  // From −45° to 90°.
  CHECK(over_pi(difference(angle_of({0, 1}), angle_of({1, -1}))) == Rational(3, 4));
}

TEST_CASE("frame angle: law: it is the argument of its direction, where there is one") {
  for_samples(100, [](Random& random) {
    const FrameAngle angle{Rational(random.integer(-40, 40), random.chance(2) ? 4 : 12), 0,
                           angle_of({Rational(1), random.rational()}).direction};
    const auto z = direction_of(angle);
    CHECK(z.has_value() == (denominator(4 * angle.half_turns) == 1));
    if (!z) return;
    const FrameAngle difference = reduced(phrame::difference(angle, angle_of(*z)));
    CHECK(over_pi(difference) == Rational(0));
  });
  CHECK_FALSE(direction_of({0, 1}));
  CHECK(direction_of({}) == GaussianRational{1, 0});
}

TEST_CASE("frame angle: as a number it is exact, or known to be irrational") {
  CHECK(to_real(FrameAngle{Rational(-1, 4), 5, {3, 3}}).exact() == Rational(5));
  CHECK(to_real(FrameAngle{Rational(1, 7), 5, {3, 3}}).origin().is_irrational);
  CHECK(to_real(FrameAngle{0, 5, {3, 2}}).origin().is_irrational);
  CHECK(to_real(FrameAngle{Rational(1, 3)}).exact() == Rational(1, 3));
  // By mpmath: 1/3 + pi/7 + atan2(-2, 1).
  CHECK(round_to_decimal(to_real(FrameAngle{Rational(1, 7), Rational(1, 3), {1, -2}}), 30).value ==
        "-0.325016433947929564189068786377");
}

TEST_CASE("frame angle: it is written in the fewest terms") {
  const auto text = [](const FrameAngle& angle) { return to_string(angle); };
  CHECK(text({}) == "0");
  CHECK(text(angle_of({3, 4})) == "atan2(4, 3)");
  CHECK(text(angle_of({-6, 8})) == "atan2(4, -3)");
  CHECK(text(angle_of({Rational(-1, 2), Rational(-1, 3)})) == "atan2(-2, -3)");
  CHECK(text(angle_of({-1, 0})) == "pi");
  CHECK(text(angle_of({2, -2})) == "-pi/4");
  CHECK(text({Rational(1, 2), Rational(1, 3), {0, 1}}) == "1/3 + pi");
  CHECK(text({1, 0, {3, 4}}) == "pi + atan2(4, 3)");  // beyond π
  CHECK(text({Rational(1, 3), 2, {3, -4}}) == "2 + pi/3 + atan2(-4, 3)");
}

TEST_CASE("reduced angle: law: whole turns do not count, and what is left is in (-pi, pi]") {
  for_samples(100, [](Random& random) {
    const FrameAngle angle{random.rational(), random.chance(2) ? Rational(0) : random.rational(),
                           angle_of({Rational(1), random.rational()}).direction};
    const FrameAngle rest = reduced(angle);
    FrameAngle turned = angle;
    turned.half_turns += 2 * Rational(random.integer(-9, 9)) * power_of_ten(random.integer(0, 60));
    CHECK(reduced(turned) == rest);
    const RealBall x = to_real(rest).enclose(100);
    CHECK(subtract(x, pi(100), 100).lower() <= 0);
    CHECK(add(x, pi(100), 100).upper() > 0);
    const RealBall turns = divide(subtract(to_real(angle).enclose(200), x, 200),
                                  multiply(RealBall(2, 200), pi(200), 200), 200);
    CHECK(arb_contains_int(turns.raw()) != 0);
  });
  CHECK(reduced({-1, 0}) == FrameAngle{1, 0});
  CHECK(reduced({Rational(-1, 2), 0, {0, 3}}) == FrameAngle{Rational(-1, 2), 0, {0, 3}});
  CHECK(reduced({Rational(1, 2), 0, {0, 1}}) == FrameAngle{Rational(1, 2), 0, {0, 1}});
  CHECK(reduced({-Rational(3, 2), 0, {0, 1}}) == FrameAngle{Rational(1, 2), 0, {0, 1}});
}

// By mpmath, x − 2π·nint(x/2π) with 1200 digits.
TEST_CASE("reduced angle: of powers of ten in radians") {
  const std::pair<long, const char*> powers[]{
      {24, "-1.48677434103531370101561026317235323209512996036514"},
      {30, "-3.05135332969174021043146179537413728275343326969169"},
      {35, "1.27828869541662225344699375782786095934245333633604"},
      {1000, "2.42957864119236726033630140940625449881524667678797"}};
  for (const auto& power : powers) {
    CAPTURE(power.first);
    CHECK(round_to_decimal(to_real(reduced({0, power_of_ten(power.first)})), 51).value ==
          power.second);
  }
}
