#include "phrame/ph/twist/twist_branch.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "phrame/ph/twist/twist_error.hpp"
#include "support/curves.hpp"
#include "support/farouki_moon.hpp"

using namespace phrame;

namespace {

/// The first example of the paper with the family of its quadratic rotations.
struct Line {
  TwistPiece piece;
  RotationFamily family;

  Line() : piece(first_piece()), family(rotation_family(piece, 2, EndRates::matched, 96)) {}

  static TwistPiece first_piece() {
    const auto& example = test::farouki_moon()["example1"];
    const MinimalTwist mtf(
        PathAngle(PhPath(test::curve_of(example))), {},
        FrameAngle(test::number(example["consistent"]["delta_theta_over_pi"]), 0));
    return twist_pieces(mtf, {}).front();
  }
  /// G, by quadrature.
  RealBall mean_square(const Rational& parameter) const {
    return phrame::mean_square(piece, member(family, {parameter}, 96), 40);
  }
  /// The parameter at which γ = 0.
  Rational end() const {
    return divide(subtract({}, family.end_factor[0], 96), family.end_factor[1], 96).midpoint();
  }
};

}  // namespace

TEST_CASE("twist branch: a bound that is shown holds for each member") {
  const Line line;
  const Rational end = line.end();
  const int direction = sign(line.family.end_factor[1]);  // γ > 0 on this side
  const Rational origin = end + direction;
  const TwistBranch branch(line.piece, line.family, origin, 64);
  long shown = 0;
  for (const long k : {1L, 3L, 7L, 12L, 30L}) {
    const Rational a = end + direction * Rational(k, 8);
    const Rational b = a + Rational(direction, 64);
    const ParameterRange range{std::min(a, b), std::max(a, b)};
    const RealBall at_a = line.mean_square(a);
    // The greatest bounds that are shown among 2⁻ᵏ·G(a), k = 1, 2, …; never G(a) itself.
    CHECK_FALSE(branch.is_above(range, at_a));
    for (long power = 1; power < 12; ++power) {
      const RealBall least = times_power_of_two(at_a, -power);
      if (!branch.is_above(range, least)) continue;
      ++shown;
      CAPTURE(k);
      for (const Rational& p : {a, Rational((a + b) / 2), b})
        CHECK(line.mean_square(p).lower() > least.upper());
      break;
    }
  }
  CHECK(shown >= 4);
}

TEST_CASE("twist branch: it ends where γ = 0, and else goes to infinity") {
  const Line line;
  const int direction = sign(line.family.end_factor[1]);
  const TwistBranch branch(line.piece, line.family, line.end() + direction, 16);
  CHECK(branch.parts() == 16);
  CHECK_FALSE(branch.end(direction).has_value());
  REQUIRE(branch.end(-direction).has_value());
  CHECK(branch.end(-direction)->contains(line.end()));
}

TEST_CASE("twist branch: beyond a parameter, up to the end of the branch") {
  const Line line;
  const int direction = sign(line.family.end_factor[1]);
  const Rational near_end = line.end() + direction * Rational(1, 64);
  const TwistBranch branch(line.piece, line.family, line.end() + direction, 64);
  // Towards γ = 0 the frame turns ever faster: G is above any number there.
  const RealBall small = RealBall(Rational(1, 100), 96);
  CHECK(branch.is_above_beyond(near_end, -direction, small, 16));
  for (const long k : {70L, 100L, 1000L})
    CHECK(line.mean_square(line.end() + direction * Rational(1, k)).lower() > Rational(1, 100));
  CHECK_FALSE(branch.is_above_beyond(near_end, direction, RealBall(1000000, 96), 16));
}
