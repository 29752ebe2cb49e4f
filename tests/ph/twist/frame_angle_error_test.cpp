#include "phrame/ph/twist/frame_angle_error.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "support/curves.hpp"

using namespace phrame;

// a = 0: the Euler–Rodrigues frame itself, which is off by −θ_RMF. Common factors are no matter,
// even with a zero on [0, 1].
TEST_CASE("frame angle error: of the Euler–Rodrigues frame") {
  const RmfAngle rmf(test::quintic);
  const FrameAngleError error =
      frame_angle_error(test::quintic.preimage(), {}, Polynomial{Rational(-1, 2), 1});
  const RealBall end = error.at_end.enclose(100);
  CHECK(end.radius() < power_of_two(-90));
  CHECK(add(end, rmf.enclose(1, 100), 100).contains_zero());
  // No value at 400 points is greater, and one comes near.
  const RealBall greatest = error.greatest.enclose(60);
  CHECK(greatest.radius() < power_of_two(-50));
  Rational most;
  for (long k = 0; k <= 400; ++k)
    most = std::max(most, absolute(rmf.enclose(Rational(k, 400), 60)).midpoint());
  CHECK(greatest.upper() >= most);
  CHECK(greatest.lower() - most < Rational(1, 10'000));
}

// A = (t + i)²: θ_RMF = 4 arctan t = 2 arg (1 + it)².
TEST_CASE("frame angle error: 0 where the frame is rotation-minimizing") {
  const QuaternionPolynomial turning{{-1, 0, 1}, {0, 2}, {}, {}};
  const FrameAngleError error = frame_angle_error(turning, {0, 2}, {1, 0, -1});
  CHECK(error.greatest.exact() == Rational(0));
  CHECK(error.at_end.exact() == Rational(0));
  // The other way round it turns by twice that.
  const FrameAngleError other = frame_angle_error(turning, {0, -2}, {1, 0, -1});
  const RealBall twice = times_power_of_two(pi(200), 1);  // 8 arctan 1
  CHECK(add(other.at_end.enclose(100), twice, 100).contains_zero());
  CHECK(subtract(other.greatest.enclose(100), twice, 100).contains_zero());
}
