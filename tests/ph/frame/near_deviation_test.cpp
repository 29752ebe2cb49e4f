#include "phrame/ph/frame/near_deviation.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace near_deviation_test {

bool meet(const RealBall& a, const RealBall& b) { return subtract(a, b, 200).contains_zero(); }

/// Up to whole turns.
bool meet_as_angles(const RealBall& a, const RealBall& b) {
  for (long turns = -1; turns <= 1; ++turns)
    if (meet(a, add(b, multiply(RealBall(2 * turns, 200), pi(200), 200), 200))) return true;
  return false;
}

bool is_narrow(const RealBall& x) { return x.radius() < power_of_two(-90) * (1 + abs(x.upper())); }

Vector<Rational> doubles(const Vector<Real>& v) {
  const Vector<double> rounded = round_to_double(v);
  return {exact_rational(rounded[0]), exact_rational(rounded[1]), exact_rational(rounded[2])};
}

/// As frame_check has it.
FrameDeviation exactly(const PathAngle& angle, const Place& at, int side, const GivenFrame& given) {
  const Path& path = angle.path();
  ExactFrame exact{direction(path, at), second_axis(angle, at), std::nullopt,
                   angle.value(at).enclose(128), side};
  try {
    exact.normal = frenet_frame(path, at).e2;
  } catch (const DomainError&) {
  }
  return deviation_from(exact, given, 128);
}

void check_equal(const FrameDeviation& near, const FrameDeviation& exact) {
  for (std::size_t k = 0; k < 3; ++k) CHECK(meet(near.e1[k], exact.e1[k]));
  REQUIRE(near.f2.has_value() == exact.f2.has_value());
  CHECK(meet_as_angles(*near.f2, *exact.f2));
  CHECK(is_narrow(*near.f2));
  REQUIRE(near.from_normal.has_value() == exact.from_normal.has_value());
  if (near.from_normal) CHECK(meet_as_angles(*near.from_normal, *exact.from_normal));
  CHECK(meet(near.orthogonality, exact.orthogonality));
  CHECK(is_narrow(near.orthogonality));
  CHECK(meet(near.length, exact.length));
  CHECK(meet(near.tangent_sine, exact.tangent_sine));
  CHECK(near.is_reversed == exact.is_reversed);
  CHECK(near.handedness == exact.handedness);
}

}  // namespace near_deviation_test

using namespace near_deviation_test;

TEST_CASE("near deviation: law: it is the exact one, of frames that are near and far") {
  long told = 0;
  test::for_samples(40, [&](test::Random& random) {
    const Curve curve = random.chance(3) ? test::quintic : random.curve(3);
    const PathAngle angle{Path(curve)};
    const auto& segment = std::get<PhSegment>(angle.path().segments()[0]);
    const Place at(0, Rational(random.integer(0, 7), 7));
    const int side = static_cast<int>(random.integer(-1, 1));
    const Frame<Real> rmf = rotation_minimizing_frame(angle, at);
    GivenFrame given{*at.t.exact(), doubles(rmf.e2)};
    if (random.chance(3)) given.f2 = {random.rational(), random.rational(), random.rational()};
    if (!random.chance(3)) given.f3 = doubles(rmf.e3);
    if (random.chance(4)) given.f3 = Vector<Rational>{random.rational(), 1, random.rational()};
    if (!random.chance(3)) given.tangent = doubles(random.chance(2) ? rmf.e1 : opposite(rmf.e1));
    const auto near =
        near_deviation(segment, given.t, angle.value(at).enclose(128), side, given, 128);
    if (!near) return;
    ++told;
    check_equal(*near, exactly(angle, at, side, given));
  });
  CHECK(told > 10);
}

// 0 that is not seen from balls is left to the exact way: a vector along the tangent, and one that
// is across it.
TEST_CASE("near deviation: what is not told from 0 is not answered") {
  const PathAngle angle{Path(test::quintic)};
  const auto& segment = std::get<PhSegment>(angle.path().segments()[0]);
  const Rational t(1, 3);
  const Frame<Rational> erf = euler_rodrigues_frame(test::quintic, t);
  const RealBall theta = angle.value(Place(0, t)).enclose(128);
  CHECK_FALSE(near_deviation(segment, t, theta, 1, {t, erf.e1}, 128));
  CHECK_FALSE(near_deviation(segment, t, theta, 1, {t, erf.e2}, 128));
  CHECK_FALSE(near_deviation(segment, t, theta, 1, {t, {0, 0, 0}}, 128));
}
