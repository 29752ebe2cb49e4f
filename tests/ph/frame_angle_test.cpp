#include "phrame/ph/frame_angle.hpp"

#include "phrame/algebra/error.hpp"
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
