#include "phrame/ph/along/segment_integral.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "support/expression_curves.hpp"

using namespace phrame;
using test::expression_curve;

namespace {

/// A curve without a symmetry. Its numbers are those of mpmath's quad() and diff() with 40 digits.
ExpressionCurve wild() {
  return expression_curve({"exp(s)*cos(s)", "log(2 + s)*s", "atan(s) + sqrt(1 + s^2)"}, "0", "2");
}

/// Is it the number, whose digits are right but for the last one?
bool agrees(const Real& x, const char* digits) {
  const std::string text = digits;
  const auto places = static_cast<long>(text.size() - text.find('.') - 1);
  const RealBall off = absolute(subtract(x.enclose(128), RealBall(parse_rational(text), 128), 128));
  return is_at_most(off, RealBall(parse_rational("1e-" + std::to_string(places)), 128));
}

}  // namespace

TEST_CASE("segment integral: angles, lengths and totals of formulas are those of quadrature") {
  const Path path{Segment(wild())};
  const PathAngle angle(path, {0, 0, 1});
  CHECK(agrees(angle.value({0, Rational(1)}), "-1.3274409146143517073234919564855"));
  CHECK(agrees(angle.value({0, Rational(1, 3)}), "-0.48145366320196974731715660702906"));
  const PathLength length(path);
  CHECK(agrees(length.total(), "6.8830472921982910217953109198429"));
  CHECK(agrees(total_curvature(path).value, "2.0745276709848007690013322640185"));
  CHECK(agrees(curvature(path, {0, Rational(1, 4)}), "0.537348638888161156607644235088"));
  CHECK(agrees(torsion(path, {0, Rational(1, 4)}), "0.203811026663844711813221366464"));
  CHECK(agrees(std::get<PathTotal>(bending_energy(path)).value, "1.286457790397716933"));
  CHECK(agrees(total_torsion(path).value, "0.25441230664139150655"));
}

TEST_CASE("segment integral: law: at a ball of parameters it has the values at its points") {
  for (const Segment& segment :
       {Segment(wild()), Segment(RationalCurve({Polynomial{0, 1}, {0, 0, 1}, {0, 1, 3}}))}) {
    const SegmentIntegral theta = up_frame_angle(segment, {0, 0, 1});
    const RealBall around = hull(Rational(3, 8), Rational(1, 2), 64);
    const Real all([around](long) { return around; });
    const RealBall values = theta.enclose(all, 64);
    const RealBall rates = theta.rate(around, 64);
    const Rational t(2, 5);
    CHECK(values.contains(theta.enclose(t, 64).midpoint()));
    CHECK(rates.contains(theta.rate(RealBall(t, 64), 64).midpoint()));
    // θ(1/2) − θ(3/8) is θ′ somewhere between, times 1/8.
    const RealBall change =
        subtract(theta.enclose(Rational(1, 2), 64), theta.enclose(Rational(3, 8), 64), 64);
    CHECK(multiply(rates, RealBall(Rational(1, 8), 64), 64).contains(change.midpoint()));
  }
}

TEST_CASE("segment integral: law: what is turned over turns the other way about its own tangent") {
  const ExpressionCurve curve = wild();
  const auto total = [](const SegmentIntegral& f) { return f.enclose(Rational(1), 80); };
  for (const auto& pair :
       {std::pair{total(up_frame_angle(curve, {0, 0, 1})),
                  total(up_frame_angle(curve.turned_over(), {0, 0, 1}))},
        {total(frenet_angle(curve)), total(frenet_angle(curve.turned_over()))}}) {
    CHECK(add(pair.first, pair.second, 80).contains_zero());
    CHECK(!pair.first.contains_zero());
  }
  CHECK(total(arc_length(curve)).overlaps(total(arc_length(curve.turned_over()))));
}

TEST_CASE("segment integral: in a plane, nothing turns against its normal or a v in it") {
  const ExpressionCurve plane =
      expression_curve({"exp(s)", "sin(s) + exp(s)", "-sin(s)"}, "0", "9");
  CHECK(up_frame_angle(plane, {1, -1, -1}).is_zero());
  CHECK(frenet_angle(plane).is_zero());
  CHECK(!up_frame_angle(plane, {7, 3, 2}).is_zero());
  CHECK(
      up_frame_angle(expression_curve({"exp(s)", "2", "-exp(s)"}, "0", "1"), {7, 3, 2}).is_zero());
}

TEST_CASE("segment integral: what is undefined is refused with the place") {
  const auto failure = [](const ExpressionCurve& c, const auto& integral) -> std::string {
    try {
      integral(c);
    } catch (const DomainError& error) {
      return error.what();
    }
    return "none";
  };
  const auto frenet = [](const ExpressionCurve& c) { frenet_angle(c); };
  const ExpressionCurve inflected = expression_curve({"s", "sin(s)", "s^3"}, "-2", "1");
  CHECK(failure(inflected, frenet) == "Frenet frame: the curvature is 0 at s = 0");
  // The tangent turns through it [mpmath: quad of |r′ × r″|/|r′|²].
  CHECK(round_to_decimal(bending_angle(inflected).value(Rational(1)), 7).value == "2.762657");
  CHECK(failure(expression_curve({"exp(s)", "2*exp(s)", "1"}, "0", "1"), frenet) ==
        "Frenet frame: the curve is a straight line, it has no principal normal");
}

TEST_CASE("segment integral: a line by formulas has no bending energy, exactly") {
  const Path line(expression_curve({"exp(s)", "2*exp(s)", "1"}, "0", "1"));
  CHECK(std::get<PathTotal>(bending_energy(line)).value.exact() == Rational(0));
  CHECK(total_curvature(line).value.exact() == Rational(0));
}
