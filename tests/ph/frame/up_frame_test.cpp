#include "phrame/ph/frame/up_frame.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

namespace up_frame_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 120;

Vector<RealBall> balls(const Vector<Rational>& v) {
  return {RealBall(v[0], bits), RealBall(v[1], bits), RealBall(v[2], bits)};
}

/// Of f about the tangent (3, 4, 0)/5 with v along z: e₂ = (−4, 3, 0)/5, e₃ = (0, 0, 1).
RealBall angle_of(const Vector<Rational>& f) {
  return angle_to_up(f, {0, 0, 2}, balls({Rational(3, 5), Rational(4, 5), 0}), bits);
}

RealBall times_pi(const Rational& r) { return multiply(pi(bits), RealBall(r, bits), bits); }

}  // namespace

TEST_CASE("up frame: the angle counts from v × e1 towards e1 × e2, whatever f has along e1") {
  const Vector<Rational> e2{Rational(-4, 5), Rational(3, 5), 0};
  const Vector<Rational> e3{0, 0, 1};
  const Vector<Rational> along{3, 4, 0};
  const Rational minus(-1);
  const std::vector<std::pair<Vector<Rational>, Rational>> known{
      {e2, 0},
      {e2 + e3, Rational(1, 4)},
      {e3, Rational(1, 2)},
      {e3 - e2, Rational(3, 4)},
      {minus * e3, Rational(-1, 2)},
      {minus * e3 - e2, Rational(-3, 4)}};
  for (const auto& [f, part] : known) {
    for (const Vector<Rational>& moved : {f, f + along, Rational(7) * f - along}) {
      const RealBall angle = angle_of(moved);
      CHECK(angle.overlaps(times_pi(part)));
      CHECK(absolute(subtract(angle, times_pi(part), bits)).upper() < Rational(1, 1'000'000'000));
    }
  }
}

TEST_CASE("up frame: an angle that is not told is all of them") {
  const auto check_all = [](const RealBall& angle) {
    CHECK(angle.lower() <= -3);
    CHECK(angle.upper() >= 3);
  };
  check_all(angle_of({3, 4, 0}));
  // Of a tangent that is known exactly, too; and where v is along it.
  check_all(angle_to_up({2, 0, 0}, {0, 0, 1}, balls({1, 0, 0}), bits));
  check_all(angle_to_up({0, 0, 1}, {3, 0, 0}, balls({1, 0, 0}), bits));
  // −e₂ next to the cut, on both sides of which is what the ball of e₁ allows.
  Vector<RealBall> about = balls({Rational(3, 5), Rational(4, 5), 0});
  about[2] = widened(about[2], 1e-20);
  check_all(angle_to_up({Rational(4, 5), Rational(-3, 5), 0}, {0, 0, 2}, about, bits));
}

}  // namespace up_frame_test
