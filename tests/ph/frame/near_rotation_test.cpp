#include "phrame/ph/frame/near_rotation.hpp"

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/rotation_ball.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Frame<double> nearest_frame(const Frame<Real>& frame) {
  return {round_to_double(frame.e1), round_to_double(frame.e2), round_to_double(frame.e3)};
}

bool are_same(const Frame<double>& a, const Frame<double>& b) {
  return a.e1 == b.e1 && a.e2 == b.e2 && a.e3 == b.e3;
}

Rational sum_of(const DoubleDouble& x) { return exact_rational(x.high) + exact_rational(x.low); }

/// Coefficients times 10ᵏ, which leave the frames alone.
Curve times_power_of_ten(const Curve& curve, unsigned long k) {
  const Rational c(pow(Integer(10), k));
  const auto& [u, v, p, q] = curve.preimage();
  return Curve({c * u, c * v, c * p, c * q});
}

}  // namespace

TEST_CASE("near rotations: law: the quaternion contains that of balls") {
  constexpr long bits = 200;
  int found = 0;
  for_samples(200, [&](Random& random) {
    const Curve of_small = random.curve(4);
    if (is_zero(of_small.preimage())) return;
    const Curve curve = random.chance(3) ? times_power_of_ten(of_small, 70) : of_small;
    const Rational t(random.integer(-(1 << 20), 1 << 21), random.integer(1 << 19, 1 << 20));
    const Angle start(random.rational());
    const PathAngle angle{Path(curve)};
    const auto rotation = NearRotations(angle, start).at(0, near_number(t));
    if (!rotation) return;
    found += rotation->error < 0x1p-80 ? 1 : 0;
    const RealBall theta = angle.enclose(Place{0, t}, start, bits);
    const auto& a = std::get<PhSegment>(angle.path().segments()[0]).primitive_preimage();
    const Quaternion<RealBall> b = rotation_ball(a, t, theta, 1, bits);
    RealBall squares;
    for (const auto& [x, y] : {std::pair{b.u, rotation->b.u}, std::pair{b.v, rotation->b.v},
                               std::pair{b.p, rotation->b.p}, std::pair{b.q, rotation->b.q}}) {
      const RealBall off = subtract(x, RealBall(sum_of(y), bits), bits);
      squares = add_product(squares, off, off, bits);
    }
    CHECK(squares.upper() <= exact_rational(rotation->error) * exact_rational(rotation->error));
  });
  CHECK(found > 150);
}

TEST_CASE("near rotations: law: frames along a path are those of fractions, rounded") {
  int told = 0;
  for_samples(40, [&](Random& random) {
    const Curve curve = random.curve(3);
    if (is_zero(curve.preimage())) return;
    const Path path = test::cut(curve, {Rational(1, 3), Rational(3, 4)});
    const PathAngle angle(path);
    const StartAngle start = Angle(random.rational());
    const NearRotations rotations(angle, start);
    for (const Rational& t :
         {Rational(random.integer(0, 3000), 1000), Rational(1), Rational(2), Rational(3),
          Rational(1 - power_of_two(-70)), Rational(2 + power_of_two(-60))}) {
      const Frame<double> exact =
          nearest_frame(rotation_minimizing_frame(angle, locate(path, t), start));
      if (const auto frame = rotations.frame(near_number(t))) {
        ++told;
        CHECK(are_same(*frame, exact));
      }
      if (const auto frame = rotations.by_balls(locate(path, t))) CHECK(are_same(*frame, exact));
    }
  });
  CHECK(told > 100);
}

TEST_CASE("near rotations: next to a joint a number that is not told has no frame") {
  const Path path = test::cut(test::quintic, {Rational(1, 2)});
  const NearRotations rotations(PathAngle{path}, StartAngle());
  CHECK(rotations.frame({{0.99}, 0x1p-90}));
  CHECK(rotations.frame({{1, -0x1p-80}, 0}));
  CHECK_FALSE(rotations.frame({{1, -0x1p-80}, 0x1p-80}));
  CHECK_FALSE(rotations.frame({{1, 0x1p-80}, 0x1p-79}));
  CHECK_FALSE(rotations.frame({{-0x1p-80}, 0}));
  CHECK_FALSE(rotations.frame({{2, 0x1p-80}, 0}));
}

TEST_CASE("near rotations: of a plane curve what is 0 all along is known") {
  const Curve plane(QuaternionPolynomial{{1, 2}, {}, {}, {0, 1, 1}});  // r′ in the plane z = 0
  const NearRotations rotations(PathAngle{Path(plane)}, StartAngle());
  const auto frame = rotations.frame({{0.3}});
  REQUIRE(frame);
  CHECK(frame->e1[2] == 0);
  CHECK(frame->e3 == Vector<double>{0, 0, 1});
}

TEST_CASE("near rotations: a double pole is left to balls") {
  // A = (1 + t²)·1 + … has σ = (1 + t²)²·…: as of helices, θ′ has no simple poles
  const Polynomial w{1, 0, 1};
  const Curve curve(QuaternionPolynomial{w, {0, 2}, {}, {1, 0, 1}});
  const PathAngle angle{Path(curve)};
  const NearRotations rotations(angle, StartAngle());
  const Place at{0, Rational(2, 7)};
  const auto frame = rotations.by_balls(at);
  REQUIRE(frame);
  CHECK(are_same(*frame, nearest_frame(rotation_minimizing_frame(angle, at, StartAngle()))));
}
