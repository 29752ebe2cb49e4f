#include "phrame/ph/frame/rotation_ball.hpp"

#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/frame_quaternion.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Frame<double> rounded(const Frame<Real>& frame) {
  return {round_to_double(frame.e1), round_to_double(frame.e2), round_to_double(frame.e3)};
}

bool is_same(const Frame<double>& a, const Frame<double>& b) {
  return a.e1 == b.e1 && a.e2 == b.e2 && a.e3 == b.e3;
}

}  // namespace

// Against frames in which nothing but the angle is a ball, and that is proved to round.
TEST_CASE("rotation ball: law: the frames that it decides are those of the curve, rounded") {
  int decided = 0;
  for_samples(200, [&](Random& random) {
    const Curve curve = random.curve(4);
    if (is_zero(curve.preimage())) return;
    const QuaternionPolynomial a = without_real_content(curve.preimage());
    const Rational t(random.integer(0, 1 << 20), 1 << 20);
    const Angle start(random.rational());
    const RmfAngle angle(curve);
    const Real theta = angle.value(t, start);
    const auto found = rounded_frame(rotation_ball(a, t, theta.enclose(rotation_bits)));
    if (!found) return;
    ++decided;
    CHECK(is_same(*found, rounded(Frames(curve).rotation_minimizing(angle, t, start))));
  });
  CHECK(decided > 80);  // the others have components that are 0
}

TEST_CASE("rotation ball: a component that is 0 everywhere is seen, another is left open") {
  const QuaternionPolynomial plane{{1, 2}, {}, {}, {0, 1, 1}};  // r′ in the plane z = 0
  const auto found = rounded_frame(rotation_ball(plane, Rational(1, 3), {}));
  REQUIRE(found);
  CHECK(found->e1[2] == 0);
  CHECK(found->e3 == Vector<double>{0, 0, 1});
  const QuaternionPolynomial turning{{1}, {}, {}, {-1, 2}};  // t = 1/2: A = 1
  CHECK(is_same(rounded_frame(rotation_ball(turning, Rational(1, 2), {})).value(),
                {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  const RealBall small = RealBall(Rational(1, 3), rotation_bits);
  CHECK_FALSE(rounded_frame(rotation_ball(
      turning, Rational(1, 2), subtract(small, RealBall(Rational(1, 3), 2 * rotation_bits), 300))));
}

TEST_CASE("rotation ball: the sign is that of the quaternion, and its frame is the same") {
  for_samples(40, [](Random& random) {
    const QuaternionPolynomial a = without_real_content(random.curve(3).preimage());
    if (is_zero(a)) return;
    const Rational t(random.integer(0, 64), 64);
    const RealBall theta(random.rational(), rotation_bits);
    const Quaternion<RealBall> b = rotation_ball(a, t, theta);
    const Quaternion<RealBall> other = rotation_ball(a, t, theta, -1);
    for (const auto part : {&Quaternion<RealBall>::u, &Quaternion<RealBall>::v,
                            &Quaternion<RealBall>::p, &Quaternion<RealBall>::q})
      CHECK(add(b.*part, other.*part, rotation_bits).contains(0));
    const RationalQuaternion at = evaluate(a, t);
    const double turn = approximate(theta) / 2;
    const double size = std::sqrt(round_to_double(norm(at)));
    CHECK(approximate(b.u) * size == doctest::Approx(round_to_double(at.u) * std::cos(turn) -
                                                     round_to_double(at.v) * std::sin(turn)));
    CHECK(approximate(b.q) * size == doctest::Approx(round_to_double(at.q) * std::cos(turn) -
                                                     round_to_double(at.p) * std::sin(turn)));
  });
}
