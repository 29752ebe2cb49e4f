#include "phrame/ph/frame/closed_curve.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/expression_integral.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/curve_series.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;
using test::Random;
using test::torus_knot;

namespace {

bool is_near(const Real& value, double expected, double distance) {
  return std::abs(approximate(value.enclose(distance < 1e-10 ? 60 : 30)) - expected) < distance;
}

/// −2π·Tw in (−π, π]: the angle by which a rotation-minimizing frame comes back turned.
Real holonomy(const ClosedFrame& frame) {
  const Real turn([twist = frame.twist](long bits) {
    return multiply(twist.enclose(bits + 8), times_power_of_two(pi(bits + 8), 1), bits + 8);
  });
  return reduced(-turn).angle;
}

ExpressionCurve figure_eight() {
  return expression_curve({"(2 + cos(2*s))*cos(3*s)", "(2 + cos(2*s))*sin(3*s)", "sin(4*s)"}, "0",
                          "2*pi");
}

Real total(const ExpressionCurve& c, const CurveIntegrand& rate) {
  REQUIRE(!taylor_parts(c, rate)->fault);
  const ExpressionIntegral integral(c, rate);
  return Real([integral](long bits) { return integral.enclose(1, bits); });
}

template <class C>
void check_law_of_projections(const C& curve) {
  std::vector<Real> writhes;
  for (const Vector<Rational>& v : {Vector<Rational>{1, 2, 5}, {1, 3, -2}, {2, 1, -7}})
    if (const auto frame = closed_frame(curve, v)) writhes.push_back(writhe(*frame));
  CHECK(writhes.size() >= 2);
  for (const Real& other : writhes) CHECK(other.enclose(50).overlaps(writhes.front().enclose(50)));
}

}  // namespace

// Gauss's double integral by numpy, midpoints of 1000² and 2000² parts, extrapolated.
TEST_CASE("closed curve: the writhe is Gauss's double integral") {
  CHECK(is_near(writhe(closed_frame(Path(torus_knot(2, 3)))), -3.51823923, 1e-7));
  CHECK(is_near(writhe(closed_frame(Path(torus_knot(3, 2)))), -3.90078708, 1e-7));
  CHECK(is_near(writhe(closed_frame(Path(torus_knot(2, 5)))), -6.86810701, 1e-7));
  CHECK(is_near(writhe(closed_frame(Path(torus_knot(3, 4)))), -8.52371169, 1e-7));
  CHECK(is_near(writhe(closed_frame(Path(figure_eight()))), 0.0863161, 1e-6));
  const ExpressionCurve fourier =
      expression_curve({"sin(s) + 2*sin(2*s)", "cos(s) - 2*cos(2*s)", "-sin(3*s)"}, "0", "2*pi");
  CHECK(is_near(writhe(closed_frame(Path(fourier))), -3.35412622, 1e-7));
  CHECK(is_near(holonomy(closed_frame(Path(fourier))), -2.225040642434489, 1e-14));  // mpmath
}

TEST_CASE("closed curve: law: the writhe does not depend on v") {
  if (test::multiplier() > 1) check_law_of_projections(Path(figure_eight()));
  check_law_of_projections(
      Path(expression_curve({"cos(s)", "sin(s)", "sin(2*s)/3"}, "1", "1 - 2*pi")));
}

TEST_CASE("closed curve: the holonomy is Tw up to whole turns, so Wr - holonomy/2pi is whole") {
  const ClosedFrame frame = closed_frame(Path(torus_knot(2, 3)));
  CHECK(frame.linking == -3);
  CHECK(is_near(holonomy(frame), 3.02699218511217579, 1e-14));
  for (const auto& [p, q] : {std::pair(3L, 2L), {2L, 5L}}) {
    const ClosedFrame other = closed_frame(Path(torus_knot(p, q)), {1, 2, 5}).value();
    const RealBall turns = divide(holonomy(other).enclose(50), times_power_of_two(pi(50), 1), 50);
    CHECK(unique_integer(subtract(writhe(other).enclose(50), turns, 50)));
    CHECK(is_at_most(absolute(turns), RealBall(Rational(1, 2), 64)));
  }
}

// Gauss's integrand is 0 in a plane.
TEST_CASE("closed curve: the writhe of a plane curve is 0, also where it crosses itself") {
  const Path eight(expression_curve({"sin(s)", "sin(2*s)", "2*sin(s)"}, "0", "2*pi"));
  CHECK_THROWS_AS(closed_frame(eight), Undecided);
  CHECK(writhe(eight).exact() == Rational(0));
  CHECK(writhe(test::closed_loop()).exact() == Rational(0));
  const Path drop(expression_curve({"sin(2*s)", "sin(s)", "0"}, "0", "pi"));  // with a corner
  CHECK(writhe(drop).exact() == Rational(0));
}

TEST_CASE("closed curve: Viviani's curve has no holonomy") {
  const ExpressionCurve c = expression_curve({"1 + cos(s)", "sin(s)", "2*sin(s/2)"}, "-pi", "3*pi");
  CHECK_THROWS_AS(closed_frame(Path(c)), Undecided);  // it meets itself
  const ExpressionIntegral turn(c, up_frame_rate({1, 2, -5}));
  CHECK(turn.enclose(1, 60).contains(0));
}

// The holonomy is mpmath's, by its Taylor series method; Gauss's integral numpy's, with 2000² and
// 4000² midpoints, 0.180128 and 0.180228, extrapolated.
TEST_CASE("closed curve: a PH spline has its twist in closed form, and Gauss's writhe") {
  const PhPath path = test::chain(test::quarters());
  const ClosedFrame frame = closed_frame(path);
  CHECK(is_near(writhe(frame), 0.18026, 2e-5));
  CHECK(is_near(holonomy(frame), 1.13263544456407, 1e-13));
  check_law_of_projections(path);
  CHECK(is_near(writhe(closed_frame(test::closed_loop())), 0, 1e-9));
  CHECK_THROWS_AS(closed_frame(PhPath(path.segments().front())), DomainError);
}

TEST_CASE("closed curve: law: a PH spline by its positions has the twist of the closed form") {
  const PhPath path = test::chain(test::quarters());
  for (const Vector<Rational>& v : {Vector<Rational>{1, 2, 5}, {1, 3, -2}, {2, 1, -7}}) {
    const auto exact = closed_frame(path, v);
    const auto other = closed_frame(test::by_positions(path), v);
    REQUIRE(exact.has_value() == other.has_value());
    if (!exact) continue;
    CHECK(exact->linking == other->linking);
    CHECK(exact->twist.enclose(100).overlaps(other->twist.enclose(100)));
    CHECK(other->twist.enclose(100).is_accurate(80));
  }
  CHECK_THROWS_AS(closed_frame(Path(test::by_positions(path).segments().front())), DomainError);
}

// The trefoil (2 + cos 3s)(cos 2s, sin 2s), sin 3s: ∫τ ds/2π + Wr = −6 with mpmath's ∫τ ds =
// −15.593362799471348747 and Gauss's integral. For the torus knot T(p, q) that winds p times around
// the axis the principal normals point inwards, and the number is −pq.
TEST_CASE("closed curve: self-linking numbers of torus knots") {
  for (const auto& [p, q] : {std::pair(2L, 3L), {2L, 5L}}) {
    const ExpressionCurve c = torus_knot(p, q);
    CHECK(self_linking_number(closed_frame(Path(c)), total(c, torsion_rate())) == -p * q);
  }
}

// By Gauss's double integral, 1000² values of numpy: −3.0000000000000044, −2.0000000000000027 and
// −2.0000000000000004.
TEST_CASE("closed curve: linking numbers of torus knots with the core and a ring") {
  const CurveSeries core =
      series_of(Path(expression_curve({"2*cos(s)", "2*sin(s)", "0"}, "0", "2*pi")));
  const CurveSeries ring =
      series_of(Path(expression_curve({"3 + 3*cos(s)", "0", "3*sin(s)"}, "0", "2*pi")));
  CHECK(linking_number(series_of(Path(torus_knot(2, 3))), core) == -3);
  CHECK(linking_number(series_of(Path(torus_knot(3, 2))), core) == -2);
  CHECK(linking_number(series_of(Path(torus_knot(2, 3))), ring) == -2);
  CHECK(linking_number(ring, series_of(Path(torus_knot(2, 3)))) == -2);
  const CurveSeries far =
      series_of(Path(expression_curve({"9 + cos(s)", "sin(s)", "0"}, "0", "2*pi")));
  CHECK(linking_number(core, far) == 0);
}

TEST_CASE("closed curve: the extra turn closes the sweep") {
  const ExpressionCurve c = torus_knot(2, 3);
  const Real angle = holonomy(closed_frame(Path(c)));
  const Real turn = closing_turn_per_length(angle, total(c, length_rate()));
  CHECK(is_near(turn, -3.02699218511217579 / 31.898600666412336249, 1e-14));
}

// By Gauss's sum over pairs of edges with 40 digits of mpmath, each pair by the area of its
// spherical quadrangle.
TEST_CASE("closed curve: the writhe of a polygon is the sum of its pairs of edges") {
  const std::vector<Vector<Rational>> points{{9, -6, 8},  {6, 7, -7},  {-2, 2, 0},  {3, 3, 3},
                                             {-8, 9, 1},  {8, -4, -3}, {7, -6, -8}, {-2, 3, -7},
                                             {7, -3, -5}, {9, -6, 8}};
  const Path polygon = test::polygon(points);
  check_law_of_projections(polygon);
  CHECK(to_string(writhe(polygon).enclose(120), 25) == "-2.579487301278534528871646");

  // 24 points of a trefoil, with six decimals; by the same sum.
  std::vector<Vector<Rational>> knot;
  const auto decimals = [](double x) { return Rational(std::lround(1e6 * x), 1'000'000); };
  for (int k = 0; k <= 24; ++k) {
    const double s = 2 * std::numbers::pi * (k % 24) / 24;
    knot.push_back({decimals(std::sin(s) + 2 * std::sin(2 * s)),
                    decimals(std::cos(s) - 2 * std::cos(2 * s)), decimals(-std::sin(3 * s))});
  }
  CHECK(to_string(writhe(test::polygon(knot)).enclose(120), 25) == "-3.355716345022324194505485");
}

TEST_CASE("closed curve: a copy of a polygon in a mirror has the opposite writhe and holonomy") {
  Random random(4711);
  for (int k = 0; k < 8; ++k) {
    std::vector<Vector<Rational>> points, mirrored;
    for (int j = 0; j < 7; ++j)
      points.push_back(
          {random.integer(-999, 999), random.integer(-999, 999), random.integer(-999, 999)});
    points.push_back(points.front());
    for (const auto& [x, y, z] : points) mirrored.push_back({x, y, -z});
    const ClosedFrame frame = closed_frame(test::polygon(points));
    const ClosedFrame other = closed_frame(test::polygon(mirrored));
    CHECK(add(writhe(frame).enclose(60), writhe(other).enclose(60), 60).contains_zero());
    CHECK(add(holonomy(frame).enclose(60), holonomy(other).enclose(60), 60).contains_zero());
    const RealBall turns = divide(holonomy(frame).enclose(60), times_power_of_two(pi(60), 1), 60);
    CHECK(unique_integer(subtract(writhe(frame).enclose(60), turns, 50)));
  }
}

TEST_CASE("closed curve: what is not closed or touches itself is refused") {
  const auto failure = [](const ExpressionCurve& c) -> std::string {
    try {
      closed_frame(Path(c));
    } catch (const DomainError& error) {
      return error.what();
    }
    return "none";
  };
  CHECK(failure(expression_curve({"cos(s)", "sin(s)", "s"}, "0", "2*pi")) ==
        "the curve is not closed: its ends do not meet");
  CHECK(failure(expression_curve({"s - s^2", "s^3*(1 - s)^2", "0"}, "0", "1")) ==
        "the curve is not closed: its tangent turns back where its ends meet");
  CHECK_THROWS_AS(closed_frame(Path(expression_curve({"sin(2*s)", "sin(s)", "0"}, "0", "2*pi"))),
                  Undecided);
}

TEST_CASE("closed curve: law: where some segments are PH curves, it is that of the same curve") {
  const Path path = test::chain(test::quarters());
  const Path by_points = test::by_positions(test::chain(test::quarters()));
  std::vector<Segment> segments = path.segments();
  segments[1] = by_points.segments()[1];
  const ClosedFrame mixed = closed_frame(joined(segments));
  const ClosedFrame exact = closed_frame(path);
  CHECK(mixed.v == exact.v);
  CHECK(mixed.linking == exact.linking);
  CHECK(mixed.twist.enclose(100).overlaps(exact.twist.enclose(100)));
}
