#include "phrame/ph/along/parametrization.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"

namespace parametrization_test {

using namespace phrame;

namespace {

const char* const helix =
    R"json({"phrame": "curve/1", "expressions": {"x": "3*cos(s)", "y": "3*sin(s)", "z": "4*s",
        "variable": "s", "from": 0, "to": "4*pi"}})json";

/// A circle of radius 1 by four arcs, as files have it: the root of 1/2 is a double.
const char* const circle =
    R"({"phrame": "nurbs/1", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,4,4,4],
        "control_points": [[1,0,0],[1,1,0],[0,1,0],[-1,1,0],[-1,0,0],[-1,-1,0],[0,-1,0],[1,-1,0],[1,0,0]],
        "weights": [1,"0.7071067811865476",1,"0.7071067811865476",1,"0.7071067811865476",1,"0.7071067811865476",1]})";

double x_of(const NamedPath& named, const ParameterPoint& point) {
  return round_to_double(position(named.path, point.at)[0]);
}

}  // namespace

TEST_CASE(
    "parametrization: the native parameter of formulas is theirs, up to doubles of its ends") {
  const NamedPath named = read_any_path(helix);
  const Parametrization by(named, ParameterKind::native);
  CHECK(x_of(named, by.point(2)) == doctest::Approx(3 * std::cos(2.0)).epsilon(1e-15));
  const double end = 4 * std::acos(-1.0);
  CHECK(by.point(exact_rational(end)).at.segment == 0);
  // 4π is 4.9e-16 beyond its double, and half an ulp is 8.9e-16.
  const Rational beyond = exact_rational(end) + 3 * power_of_two(-52);
  CHECK(by.point(beyond).at.t.exact() == Rational(1));
  CHECK_THROWS_AS(by.point(exact_rational(std::nextafter(end, 13))), DomainError);
  const auto samples = by.samples(5);
  CHECK(samples[1].at.t.exact() == Rational(1, 4));
  CHECK(round_to_double(samples[1].value) == std::acos(-1.0));
}

TEST_CASE("parametrization: fractions of the length are told from joints by counting equal arcs") {
  const NamedPath named = read_any_path(circle);
  const Parametrization by(named, ParameterKind::fraction);
  for (long k = 0; k < 4; ++k) {
    const Place at = by.point(Rational(k, 4)).at;
    CHECK(at.segment == static_cast<std::size_t>(k));
    CHECK(at.t.exact() == Rational(0));
  }
  CHECK(by.point(1).at.segment == 3);
  // The weights are rounded, and so are the arcs' lengths.
  CHECK(x_of(named, by.point(Rational(1, 3))) == doctest::Approx(-0.5).epsilon(1e-14));
  CHECK_THROWS_AS(by.point(Rational(5, 4)), DomainError);
}

// The halves of the second curve are those of the first, one of them turned over and the other way
// round: speeds |r′(t)| and |r′(1 − t)|.
TEST_CASE("parametrization: half of the length of a curve and its mirror image is the joint") {
  const NamedPath named = read_any_path(
      R"({"phrame": "spline/1", "segments": [
          {"control_points": [[0,0,0],[1,0,0],[2,1,0],[2,3,1]]},
          {"control_points": [[2,3,1],[2,5,2],[3,7,3],[4,8,4]]},
          {"control_points": [[4,8,4],[5,9,5],[6,11,6],[6,13,7]]},
          {"control_points": [[6,13,7],[6,15,8],[7,16,8],[8,16,8]]}]})");
  const Parametrization by(named, ParameterKind::fraction);
  CHECK(by.point(Rational(1, 2)).at.segment == 2);
  CHECK(by.point(Rational(1, 2)).at.t.exact() == Rational(0));
}

TEST_CASE("parametrization: a fraction is where the arc length is that part of the whole") {
  const NamedPath named = read_any_path(
      R"({"phrame": "spline/1", "segments": [
          {"control_points": [[0,0,0],[1,0,0],[2,1,0],[2,3,1]]},
          {"control_points": [[2,3,1],[2,5,2],[3,7,3],[4,8,9]]}]})");
  const PathLength length(named.path);
  const Parametrization by(named, ParameterKind::fraction);
  const double whole = round_to_double(length.total());
  for (const Rational& x : {Rational(1, 10), Rational(1, 3), Rational(9, 10)})
    CHECK(round_to_double(length.value(by.point(x).at)) ==
          doctest::Approx(round_to_double(x) * whole).epsilon(1e-15));
}

TEST_CASE(
    "parametrization: a unit is the number of segments, and a path without a file has no native "
    "one") {
  const NamedPath named = read_any_path(circle);
  CHECK(Parametrization(named, ParameterKind::unit).point(Rational(3, 8)).at.t.exact() ==
        Rational(1, 2));
  CHECK_THROWS_AS(Parametrization(named, ParameterKind::unit).point(Rational(-1, 8)), DomainError);
  NamedPath bare("", named.path);
  CHECK_THROWS_AS(Parametrization(bare, ParameterKind::native), DomainError);
  CHECK(Parametrization(named, ParameterKind::native).to().exact() == Rational(4));
}

}  // namespace parametrization_test
