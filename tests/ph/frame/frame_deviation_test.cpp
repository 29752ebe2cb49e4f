#include "phrame/ph/frame/frame_deviation.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace phrame;

namespace {

/// T along z, of length 2; e₂ along x.
const ExactFrame upright{{Rational(0), Rational(0), Rational(2)},
                         {Rational(3), Rational(0), Rational(0)},
                         Vector<Real>{Rational(0), Rational(1), Rational(0)},
                         RealBall(),
                         1};

bool is_about(const RealBall& x, double value) {
  return std::abs(static_cast<double>(x.midpoint()) - value) < 1e-12;
}

}  // namespace

TEST_CASE("frame deviation: a vector of length 2, 30 degrees out of the normal plane") {
  // The projection to the plane is along (3, 4), its angle to x arctan(4/3), to y −arctan(3/4).
  const GivenFrame given{0, {Rational(3, 5), Rational(4, 5), Rational(0)}};
  const FrameDeviation plain = deviation_from(upright, given, 100);
  REQUIRE(plain.f2);
  CHECK(is_about(*plain.f2, std::atan2(4, 3)));
  REQUIRE(plain.from_normal);
  CHECK(is_about(*plain.from_normal, -std::atan2(3, 4)));
  CHECK(is_about(plain.orthogonality, 0));
  CHECK(is_about(plain.length, 0));
  CHECK(plain.handedness == 0);

  const GivenFrame lifted{0, {3, 4, 12}};  // of length 13
  const FrameDeviation off = deviation_from(upright, lifted, 100);
  CHECK(is_about(*off.f2, std::atan2(4, 3)));
  CHECK(is_about(off.orthogonality, 12.0 / 13));
  CHECK(is_about(off.length, 12));
}

TEST_CASE("frame deviation: handedness, a tangent that is given, and none") {
  GivenFrame given{0, {1, 0, 0}, Vector<Rational>{0, 1, 0}, Vector<Rational>{0, 0, 1}};
  CHECK(deviation_from(upright, given, 100).handedness == 1);
  CHECK_FALSE(deviation_from(upright, given, 100).is_reversed);
  given.tangent = Vector<Rational>{0, 0, -1};
  const FrameDeviation reversed = deviation_from(upright, given, 100);
  CHECK(reversed.is_reversed);
  CHECK(reversed.handedness == -1);
  CHECK(is_about(reversed.tangent_sine, 0));
  given.tangent = Vector<Rational>{3, 0, 4};
  CHECK(is_about(deviation_from(upright, given, 100).tangent_sine, 0.6));
  given.tangent = std::nullopt;
  given.f3 = Vector<Rational>{0, -1, 0};
  CHECK(deviation_from(upright, given, 100).handedness == -1);
  ExactFrame backwards = upright;
  backwards.side = -1;  // T is −e₁
  CHECK(deviation_from(backwards, given, 100).handedness == 1);
  backwards.side = 0;  // at a cusp where T turns round either will do
  CHECK(deviation_from(backwards, given, 100).handedness == 1);
  given.f3 = Vector<Rational>{0, 1, 0};
  CHECK(deviation_from(backwards, given, 100).handedness == 1);
}

TEST_CASE("frame deviation: a vector along the tangent has no angle") {
  const FrameDeviation none = deviation_from(upright, {0, {0, 0, 5}}, 100);
  CHECK_FALSE(none.f2);
  CHECK_FALSE(none.from_normal);
  CHECK(is_about(none.orthogonality, 1));
  CHECK_FALSE(deviation_from(upright, {0, {0, 0, 0}}, 100).f2);
}

TEST_CASE("frame deviation: the sign next to a zero") {
  CHECK(sign_beside({0, 1}, 0) == 0);
  CHECK(sign_beside({0, 0, 1}, 0) == 1);
  CHECK(sign_beside({0, 0, -1}, 0) == -1);
  CHECK(sign_beside({0, 0, 0, 1}, 0) == 0);
  CHECK(sign_beside({-3, 1}, 0) == -1);
  CHECK(sign_beside({1, -4, 4}, Rational(1, 2)) == 1);
}
