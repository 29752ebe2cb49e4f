#include "phrame/ph/twist/smooth_twist.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/twist/minimal_twist.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"

namespace smooth_twist_test {

using namespace phrame;

namespace {

const Path loop(
    bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}));

std::string digits(const Real& x, long count) { return round_to_decimal(x, count).value; }

bool agree(const Vector<Real>& u, const Vector<Real>& v) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!u[k].enclose(120).overlaps(v[k].enclose(120)) || !u[k].enclose(120).is_accurate(90))
      return false;
  return true;
}

/// In the middle: the angle of the integrals, and the frame with that.
void check_middle(const SmoothTwist& mtf, const PathAngle& angle, const PathLength& length) {
  const Place middle{0, Rational(1, 2)};
  CHECK(mtf.is_middle(middle));
  const Real behind = quotient_of(length.value(middle), length.total());
  const Real known = mtf.from() + mtf.twist() * behind + angle.value(middle);
  CHECK(known.enclose(120).overlaps(mtf.value(middle).enclose(120)));
  CHECK(known.enclose(120).is_accurate(90));
  const Frame<Real> exact = turned(up_frame(angle.path(), angle.up(), middle), known);
  const Frame<Real> frame = minimal_twist_frame(mtf, middle);
  CHECK(agree(frame.e2, exact.e2));
  CHECK(agree(frame.e3, exact.e3));
}

}  // namespace

// By mpmath: quad of the rates of the definition with v = (5, −9, 11), 40 digits.
TEST_CASE("smooth twist: twist and angles by an independent quadrature") {
  const PathAngle angle(loop, {5, -9, 11});
  const SmoothTwist mtf(angle, Angle(Rational(1, 4)), Angle(3));
  CHECK(digits(mtf.length(), 30) == "8.24952510078988651167067831996");
  CHECK(digits(mtf.up_twist(), 30) == "-1.34752349495171462972730968362");
  CHECK(digits(mtf.twist(), 30) == "1.40247650504828537027269031638");
  CHECK(digits(mtf.rate(), 30) == "0.170006938328365008889625166349");
  CHECK(digits(mtf.value({0, Rational(1, 2)}), 30) == "2.83578027017717251562214885781");
  CHECK(mtf.value({0, Rational(0)}).exact() == Rational(1, 4));
  CHECK(mtf.value({0, Rational(1)}).exact() == Rational(3));
  // A revolution more, and θ_f as much less: the same nominal twist but for that.
  const SmoothTwist more(angle, Angle(Rational(1, 4)), Angle(3), 1);
  const RealBall turn = subtract(more.twist().enclose(120), mtf.twist().enclose(120), 120);
  CHECK(turn.overlaps(times_power_of_two(pi(120), 1)));
  // And so θ(end) is θ_f and that revolution.
  const RealBall end = subtract(more.value({0, Rational(1)}).enclose(120), RealBall(3, 120), 120);
  CHECK(end.overlaps(times_power_of_two(pi(120), 1)));
  const Frame<Real> at_end = minimal_twist_frame(more, {0, Rational(1)});
  CHECK(agree(at_end.e2, minimal_twist_frame(mtf, {0, Rational(1)}).e2));
}

// Two ways: closed forms, and integrals along the same curve by its positions.
TEST_CASE("smooth twist: along a PH curve it is that of the PH curve") {
  const PhPath ph(test::quintic);
  const PathAngle angle(by_positions(ph));
  const Frame<Rational> first = euler_rodrigues_frame(test::quintic, 0);
  const Frame<Rational> last = euler_rodrigues_frame(test::quintic, 1);
  const Vector<Rational> from = first.e2;
  const Vector<Rational> to{last.e2[0] + 2 * last.e3[0], last.e2[1] + 2 * last.e3[1],
                            last.e2[2] + 2 * last.e3[2]};
  const MinimalTwist known(PathAngle(ph), FrameAngle(), angle_of(to, last));
  const SmoothTwist found(angle, StartNormal(from), StartNormal(to));
  CHECK(found.twist().enclose(120).overlaps(known.twist().enclose(120)));
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1, 2), Rational(1)}) {
    const Frame<Real> exact =
        turned(as_real(euler_rodrigues_frame(test::quintic, t)), known.value(t));
    const Frame<Real> frame = minimal_twist_frame(found, {0, t});
    CHECK(agree(frame.e2, exact.e2));
    CHECK(agree(frame.e3, exact.e3));
  }
}

// x is even about the middle, y and z are odd: f₂ is ±x there, by half a turn about it. The angle
// is that of the integrals, which know nothing of it.
TEST_CASE(
    "smooth twist: components that are 0 by the form of a curve are exactly 0 in its middle") {
  const Path crown(test::expression_curve({"cos(s)", "sin(s)", "sin(2*s)/4"}, "0", "2*pi"));
  const PathAngle angle(crown, {0, 0, 1});
  const Place middle{0, Rational(1, 2)};
  const PathLength length(crown);
  for (const long turns : {0L, 1L}) {
    const SmoothTwist mtf(angle, Angle(), Angle(), turns);
    check_middle(mtf, angle, length);
    const Frame<Real> frame = minimal_twist_frame(mtf, middle);
    CHECK(frame.e2[1].exact() == Rational(0));
    CHECK(frame.e2[2].exact() == Rational(0));
    CHECK(frame.e3[0].exact() == Rational(0));
  }
  check_middle(SmoothTwist(angle, Angle(Rational(1, 3)), Angle(2)), angle, length);
  CHECK_FALSE(SmoothTwist(angle, Angle(), Angle()).is_middle({0, Rational(1, 3)}));
}

// The curves are mirrored by x → −x, t → 1 − t, which turns the sign of the turning of a frame
// round, and v is mirrored to itself: ∫ e₂′·e₃ = 0, T = ±π, and both are as short.
TEST_CASE("smooth twist: half a turn on a curve with a mirror symmetry is taken forwards") {
  const Path bezier(bezier_curve({{-3, 0, 0}, {-1, 2, 1}, {0, 5, -2}, {1, 2, 1}, {3, 0, 0}}));
  const Path formula(test::expression_curve({"s", "s^2 + cos(s)", "s^4"}, "-1", "1"));
  for (const Path& path : {bezier, formula}) {
    const PathAngle angle(path, {0, 0, 1});
    for (const long k : {1, -1, 3, -5}) {
      const SmoothTwist half(angle, Angle(Rational(1, 3)), Angle(Rational(k), Rational(1, 3)));
      CHECK(half.twist().enclose(300).overlaps(pi(300)));
      REQUIRE(half.half_turn_within());
      CHECK(*half.half_turn_within() < power_of_two(-230));
      CHECK(half.turns_at_end() == Integer((1 - k) / 2));
    }
    const SmoothTwist vectors(angle, StartNormal({0, 1, 1}), StartNormal({0, -1, -1}));
    CHECK(vectors.twist().enclose(300).overlaps(pi(300)));
    CHECK(vectors.half_turn_within());
    CHECK_FALSE(SmoothTwist(angle, Angle(), Angle(3)).half_turn_within());
  }
}

TEST_CASE("smooth twist: half a turn in a plane, and what has no angle") {
  const Path bend(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  const PathAngle angle(bend);
  const SmoothTwist half(angle, Angle(), Angle(1, 0));
  CHECK(half.twist().enclose(100).overlaps(pi(100)));  // π, not −π
  CHECK(SmoothTwist(angle, Angle(), Angle(-1, 0)).twist().enclose(100).overlaps(pi(100)));
  CHECK(SmoothTwist(angle, Angle(), Angle(4, 0)).twist().exact() == Rational(0));
  CHECK_THROWS_AS(SmoothTwist(angle, Angle(), StartNormal({0, 1, 0})), DomainError);
  CHECK_THROWS_AS(SmoothTwist(PathAngle(loop, Reference::frenet), Angle(), Angle()), DomainError);
}

}  // namespace smooth_twist_test
