#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"

using namespace phrame;

namespace {

const NamedPath cubic{"cubic", Path(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}))};

AngleQuery upright() {
  AngleQuery query;
  query.up = Vector<Rational>{0, 0, 1};
  return query;
}

}  // namespace

// θ(1/2) is that of the solution of f₂′ = −(f₂·T′)T by mpmath's odefun (Taylor series, 30 digits),
// measured in the frame of v = (0, 0, 1); θ(1) also −∫ τ ds by mpmath's quad, since (n, b) is the
// frame of v at both ends of this curve.
TEST_CASE("path of any kind: the angle of a cubic to the frames of v and Frenet") {
  AngleQuery query = upright();
  query.at = {0, Rational(1, 2), 1};
  query.digits = 24;
  const AngleAnswer up = answer(cubic, query);
  CHECK(up.values.at(0).theta.value == "0");
  CHECK(up.values.at(1).theta.value == "-0.289671535325403270086160");
  CHECK(up.values.at(2).theta.value == "-1.65740642390110110987773");
  CHECK(up.total->value == "-1.65740642390110110987773");
  CHECK_FALSE(up.is_zero);
  CHECK_FALSE(up.holonomy.has_value());
  AngleQuery frenet;
  frenet.reference = Reference::frenet;
  frenet.digits = 30;
  CHECK(answer(cubic, frenet).total->value == "-1.65740642390110110987772706379");
}

TEST_CASE("path of any kind: a start angle is added, a start normal measured") {
  AngleQuery query = upright();
  query.at = {0, 1};
  query.start = Angle(Rational(1, 4));
  CHECK(answer(cubic, query).values.at(1).theta.value == "-1.4074064239011011");
  // At t = 0 the tangent is (1, 0, 0), e₂ = (0, 1, 0) and e₃ = (0, 0, 1): atan2(4, 3).
  query.start = StartNormal({7, 3, 4});
  CHECK(std::get<Decimal>(answer(cubic, query).start_angle).value == "0.92729521800161223");
  query.start = StartNormal({5, 0, 0});
  CHECK_THROWS_AS(answer(cubic, query), DomainError);
  // In a plane: along e₂ = (−cos 1, −sin 1, 0), no fractions, and against it.
  const NamedPath arc{"", Path(test::expression_curve({"cos(s)", "sin(s)", "0"}, "1", "2"))};
  query.start = StartNormal({-1, -1, 0});
  CHECK(std::get<Decimal>(answer(arc, query).start_angle).value == "0");
  query.start = StartNormal({1, 1, 0});
  CHECK(std::get<Decimal>(answer(arc, query).start_angle).value == "3.1415926535897932");
}

TEST_CASE("path of any kind: an up vector along the tangent is refused, with the place") {
  AngleQuery query;
  query.up = Vector<Rational>{1, 0, 0};
  CHECK_THROWS_WITH_AS(answer(cubic, query), doctest::Contains("t = 0"), DomainError);
}

// A circle of four rational arcs, x² + y² = 1, has the normal of its plane for v and turns nowhere.
TEST_CASE("path of any kind: a closed plane path has no holonomy, exactly") {
  const auto arc = [](const Vector<Rational>& a, const Vector<Rational>& b,
                      const Vector<Rational>& c) {
    return Segment(RationalCurve(
        {Polynomial{a[0], 2 * (b[0] - a[0]), a[0] - 2 * b[0] + 2 * c[0]},
         Polynomial{a[1], 2 * (b[1] - a[1]), a[1] - 2 * b[1] + 2 * c[1]}, Polynomial{}},
        Polynomial{1, 0, 1}));
  };
  const NamedPath circle{
      "circle",
      joined({arc({1, 0, 0}, {1, 1, 0}, {0, 1, 0}), arc({0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}),
              arc({-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}), arc({0, -1, 0}, {1, -1, 0}, {1, 0, 0})})};
  REQUIRE(circle.path.is_closed());
  const AngleAnswer found = answer(circle, AngleQuery{});
  CHECK(found.is_zero);
  CHECK(found.total->value == "0");
  CHECK(found.holonomy.value().value == "0");
  CHECK(found.holonomy.value().radius == "0");
}

namespace {

/// Closed, with a continuous tangent; its curvature jumps where it closes.
const NamedPath loop{
    "loop",
    Path(bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}))};

const TotalsAnswer::Row& row(const TotalsAnswer& answer, Quantity quantity) {
  for (const TotalsAnswer::Row& row : answer.rows)
    if (row.quantity == quantity) return row;
  FAIL("there is no such row");
  return answer.rows.front();
}

std::string value(const TotalsAnswer& answer, Quantity quantity) {
  return row(answer, quantity).value.value().value;
}

}  // namespace

// The integrals of the definitions by mpmath's quad, with 40 digits; the writhe, 0.214465, also as
// Gauss's double integral by numpy with 16 · 32 points of Gauss and Legendre each way, 0.214464.
TEST_CASE("path of any kind: what a closed curve gathers") {
  const TotalsAnswer found = answer(loop, TotalsQuery{20});
  CHECK(value(found, Quantity::length) == "8.2495251007898865117");
  CHECK(value(found, Quantity::torsion) == "0.79359769730082330997");
  CHECK(value(found, Quantity::curvature) == "7.0782023482680988787");
  CHECK(value(found, Quantity::bending_energy) == "9.8854655028811821621");
  CHECK(value(found, Quantity::frenet_energy) == "11.336730960530331891");
  CHECK(value(found, Quantity::holonomy) == "1.3475234949517146297");
  // The turn of the frame of any v is −holonomy up to whole turns.
  CHECK(value(found, Quantity::up_twist) == "-1.3475234949517146297");
  CHECK(value(found, Quantity::closing_turn) == "-0.16334558395642558336");  // the quotient
  CHECK(value(found, Quantity::writhe).substr(0, 7) == "0.21446");
  CHECK_FALSE(row(found, Quantity::rotation_index).value.has_value());
  CHECK(row(found, Quantity::self_linking).reason ==
        "the Frenet frame is not defined and continuous all along");
}

TEST_CASE("path of any kind: what is exact or not defined is said to be so") {
  const NamedPath line{"line", joined({bezier_curve({{0, 0, 0}, {1, 2, 2}}),
                                       bezier_curve({{1, 2, 2}, {2, 4, 4}, {4, 8, 8}})})};
  const TotalsAnswer found = answer(line, TotalsQuery{5});
  CHECK(row(found, Quantity::length).exact == Rational(12));
  CHECK(row(found, Quantity::curvature).exact == Rational(0));
  CHECK(row(found, Quantity::rotation_index).exact == Rational(0));
  CHECK(row(found, Quantity::torsion).reason ==
        "segment 1 is a straight line, which has no torsion");
  CHECK(found.rows.back().quantity == Quantity::signed_rotation_index);  // for it is open
  const InfoAnswer info = answer(line, InfoQuery{5});
  CHECK(info.is_straight);
  CHECK_FALSE(info.normal.has_value());
  CHECK(info.lengths.at(1).exact == Rational(9));
  // (t², t³) has a cusp at 0, where κ² ds is infinite.
  const NamedPath cusp{"", Path(RationalCurve({Polynomial{0, 0, 1}, {0, 0, 0, 1}, {}}))};
  const TotalsAnswer infinite = answer(cusp, TotalsQuery{5});
  CHECK(row(infinite, Quantity::bending_energy).infinite.value().pole.rational() == Rational(0));
  const InfoAnswer of_cusp = answer(cusp, InfoQuery{30});
  CHECK_FALSE(of_cusp.bending_energy.has_value());
  CHECK(of_cusp.cusps.size() == 1);
  CHECK(of_cusp.normal == Vector<Rational>{0, 0, 1});
  // (13√13 − 8)/27
  CHECK(of_cusp.length.rounded.value == "1.43970987337155040039073616582");
}

TEST_CASE("path of any kind: the numbers of a curve") {
  const InfoAnswer info = answer(loop, InfoQuery{20});
  CHECK(info.length.rounded.value == "8.2495251007898865117");
  CHECK(info.holonomy.value().value == "1.3475234949517146297");
  CHECK(info.twist.value == "-1.3475234949517146297");
  CHECK(info.bending_energy.value().value == "9.8854655028811821621");
  CHECK_FALSE(info.is_straight);
  CHECK_FALSE(info.normal.has_value());
  CHECK(info.cusps.empty());
}

// Of the spline of quarters() Gauss's integral as in tests/ph/frame/closed_curve_test.cpp; its
// normal jumps at the joints. The normal of the plane loop does not, and it is in a plane.
TEST_CASE("path of any kind: closed PH splines have a writhe, open ones no row of it") {
  const NamedPath spline{"", Path(test::chain(test::quarters()))};
  const TotalsAnswer found = answer(spline, TotalsQuery{6});
  CHECK(std::stod(value(found, Quantity::writhe)) == doctest::Approx(0.18026).epsilon(1e-4));
  // The holonomy is 2π times that, up to whole turns.
  CHECK(std::stod(value(found, Quantity::holonomy)) == doctest::Approx(1.13261).epsilon(1e-4));
  const double length = std::stod(value(found, Quantity::length));
  CHECK(std::stod(value(found, Quantity::closing_turn)) * length ==
        doctest::Approx(-1.13261).epsilon(1e-4));
  CHECK(row(found, Quantity::self_linking).reason ==
        "the Frenet frame is not defined and continuous all along");
  const TotalsAnswer plane = answer(NamedPhPath{"", test::closed_loop()}, TotalsQuery{6});
  CHECK(row(plane, Quantity::holonomy).exact == Rational(0));
  CHECK(value(plane, Quantity::writhe) == "0");
  CHECK(value(plane, Quantity::self_linking) == "0");
  const TotalsAnswer open = answer(NamedPhPath{"", test::quarters().front()}, TotalsQuery{6});
  CHECK(open.rows.back().quantity == Quantity::frenet_energy);
}

// No form says that it is closed.
TEST_CASE("path of any kind: only what needs it is undecided where a path may be closed or not") {
  const NamedPath path{
      "", Path(test::expression_curve({"cos(exp(1)*s)", "sin(exp(1)*s)", "sin(2*exp(1)*s)"},
                                      "exp(-1)", "exp(-1)*(1 + 2*pi)"))};
  const AngleAnswer angle = answer(path, AngleQuery{.at = {Rational(1, 2)}});
  CHECK(angle.values.size() == 1);
  CHECK(angle.no_holonomy.starts_with("whether the ends of the curve meet"));
  CHECK(to_json(angle).find("\"closed\": null") != std::string::npos);
  CHECK(to_text(angle).find("open or closed: undecided") != std::string::npos);
  const InfoAnswer info = answer(path, InfoQuery{});
  CHECK(to_json(info).find("\"ends_meet\": null") != std::string::npos);
  const TotalsAnswer totals = answer(path, TotalsQuery{});
  long undecided = 0;
  for (const TotalsAnswer::Row& row : totals.rows)
    undecided += row.reason.starts_with("undecided: whether the ends") ? 1 : 0;
  CHECK(undecided == 4);
  CHECK(totals.rows.front().value);
}
