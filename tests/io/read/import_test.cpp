#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "support/data.hpp"

namespace import_test {

using namespace phrame;
using test::refusal;

namespace {

/// Of a path that is not PH.
Path smooth(const std::string& text) {
  Path path = read_any_path(text).path;
  REQUIRE_FALSE(path.is_ph());
  return path;
}

Vector<Rational> at(const Path& path, const Rational& t) {
  const PathParameter where = locate(path, t);
  return point(*rational_curve(path.segments()[where.segment]), where.t);
}

std::string three(const std::string& type, const std::string& rest) {
  return fmt::format(
      R"({{"metadata": {{"version": 4.6, "type": "Curve", "generator": "Curve.toJSON"}},
          "arcLengthDivisions": 200, "type": "{}", {}}})",
      type, rest);
}

void check_near(const Vector<Rational>& point, const Vector<double>& wanted) {
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(static_cast<double>(point[c]) == doctest::Approx(wanted[c]).epsilon(1e-12));
}

const std::string four = R"("points": [[0, 0, 0], [1, 2, 0], [3, 3, 1], [4, 0, 2]])";

}  // namespace

TEST_CASE("three.js: Bézier curves and paths of them") {
  const Path cubic =
      smooth(three("CubicBezierCurve3",
                   R"("v0": [0, 0, 0], "v1": [1, 0, 0], "v2": [2, 1, 0], "v3": [2, 2, 1])"));
  CHECK(cubic == Path(bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}})));
  const Path path = smooth(three("CurvePath", R"("autoClose": false, "curves": [
      {"type": "LineCurve3", "v1": [-1, 0, 0], "v2": [0, 0, 0]},
      {"type": "QuadraticBezierCurve3", "v0": [0, 0, 0], "v1": [1, 0, 0], "v2": [2, 1, 3]}])"));
  CHECK(path.end() == 2);
  CHECK(at(path, Rational(3, 2)) == Vector<Rational>{1, Rational(1, 4), Rational(3, 4)});
  CHECK(smooth(three("TubeGeometry", R"("radius": 1, "path": {"type": "SplineCurve",
      "points": [[0, 0], [1, 1], [2, 0]]})"))
            .end() == 2);
}

TEST_CASE("three.js: Catmull–Rom curves have the points and derivatives that its formulas say") {
  const Path uniform =
      smooth(three("CatmullRomCurve3", four + R"(, "curveType": "catmullrom", "tension": 0.5)"));
  CHECK(uniform.end() == 3);
  CHECK(at(uniform, 2) == Vector<Rational>{3, 3, 1});
  // In the middle of a span: (−p₀ + 9p₁ + 9p₂ − p₃)/16.
  CHECK(at(uniform, Rational(3, 2)) == Vector<Rational>{2, Rational(45, 16), Rational(7, 16)});
  const Path closed = smooth(three("CatmullRomCurve3", four + R"(, "closed": true)"));
  CHECK(closed.end() == 4);
  CHECK(closed.is_closed());
  // The pyramid of Barry and Goldman, for the middle of the second span and both alphas.
  const double p[4][3] = {{0, 0, 0}, {1, 2, 0}, {3, 3, 1}, {4, 0, 2}};
  for (const bool is_chordal : {false, true}) {
    double t[4] = {0, 0, 0, 0};
    for (int k = 1; k < 4; ++k) {
      double square = 0;
      for (int c = 0; c < 3; ++c) square += std::pow(p[k][c] - p[k - 1][c], 2);
      t[k] = t[k - 1] + std::pow(square, is_chordal ? 0.5 : 0.25);
    }
    const double u = (t[1] + t[2]) / 2;
    Vector<double> wanted{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto mix = [&](double a, double b, int i, int j) {
        return ((t[j] - u) * a + (u - t[i]) * b) / (t[j] - t[i]);
      };
      const double a1 = mix(p[0][c], p[1][c], 0, 1);
      const double a2 = mix(p[1][c], p[2][c], 1, 2);
      const double a3 = mix(p[2][c], p[3][c], 2, 3);
      wanted[c] = mix(mix(a1, a2, 0, 2), mix(a2, a3, 1, 3), 1, 2);
    }
    const Path path =
        smooth(three("CatmullRomCurve3", four + (is_chordal ? R"(, "curveType": "chordal")" : "")));
    check_near(at(path, Rational(3, 2)), wanted);
  }
}

TEST_CASE("three.js: the points are those that it finds itself, r160") {
  std::ifstream file(test::data("/three.json"));
  const auto document = nlohmann::json::parse(file);
  for (const auto& given : document["curves"]) {
    CAPTURE(given["name"].get<std::string>());
    const Path path = smooth(given["curve"].dump());
    for (const auto& [segment, t, wanted] :
         given["points"].get<std::vector<std::tuple<long, double, Vector<double>>>>())
      check_near(at(path, segment + exact_rational(t)), wanted);
  }
}

TEST_CASE("the examples of other programs' files are read") {
  for (const char* name :
       {"cad-helix.json", "nurbs-circle.json", "geomdl.json", "three-catmull-rom.json", "wave.svg",
        "camera.csv", "pipe-spline.json", "granny-knot.csv"}) {
    CAPTURE(name);
    std::ifstream file(test::root("/examples/any/") + name);
    std::ostringstream text;
    text << file.rdbuf();
    const Path path = smooth(text.str());
    CHECK(path.end() >= 3);
    CHECK(path.ends_meet() == (std::string_view("nurbs-circle.json three-catmull-rom.json "
                                                "camera.csv granny-knot.csv")
                                   .find(name) != std::string_view::npos));
  }
}

TEST_CASE("three.js: ellipses, whole, in part and clockwise") {
  const std::string ellipse = R"("aX": 1, "aY": 2, "xRadius": 3, "yRadius": 1, )";
  const Path whole = smooth(three("EllipseCurve", ellipse + R"("aStartAngle": 0,
      "aEndAngle": 6.283185307179586, "aClockwise": false, "aRotation": 0)"));
  CHECK(whole.is_closed());
  CHECK(whole.end() == 4);
  CHECK(at(whole, 1) == Vector<Rational>{1, 3, 0});
  const Path part = smooth(three("EllipseCurve", ellipse + R"("aStartAngle": 0.5,
      "aEndAngle": 3.5, "aClockwise": true, "aRotation": 0.25)"));
  const auto wanted = [](double angle) {
    const double x = 3 * std::cos(angle);
    const double y = std::sin(angle);
    return Vector<double>{1 + x * std::cos(0.25) - y * std::sin(0.25),
                          2 + x * std::sin(0.25) + y * std::cos(0.25), 0};
  };
  check_near(at(part, 0), wanted(0.5));
  check_near(at(part, part.end()), wanted(3.5));
  check_near(at(part, 1), wanted(0.5 - std::acos(0.0)));
  const Path around = smooth(three("EllipseCurve", ellipse + R"("aStartAngle": 0.1,
      "aEndAngle": 6.383185307179586, "aClockwise": true)"));
  CHECK(around.is_closed());
}

TEST_CASE("three.js: what is wrong is refused") {
  CHECK(refusal(three("HelixCurve", R"("a": 1)")) ==
        "/type: \"HelixCurve\" is no curve of three.js that is known");
  CHECK(refusal(three("CatmullRomCurve3", R"("points": [[0, 0, 0]])")) ==
        "/points: a curve has at least 2 points, not 1");
  CHECK(refusal(three("LineCurve3", R"("v1": [1, 1, 1], "v2": [1, 1, 1])")) ==
        "/: the curve is the point (1, 1, 1)");
  CHECK(refusal(three("Path", R"("curves": [{"type": "LineCurve", "v1": [0, 0], "v2": [1, 0]},
      {"type": "LineCurve", "v1": [1, 0], "v2": [0, 0]}])"))
            .starts_with("/curves/1: the tangent turns back"));
  CHECK(refusal(three("EllipseCurve", R"("aX": 1, "aY": 2, "xRadius": 0, "yRadius": 1)")) ==
        "/xRadius: the radius is 0");
  CHECK(refusal(three("NURBSCurve", R"("degree": 1, "knots": [0, 0, 1, 1],
      "controlPoints": [[0, 0, 0, 1], [1, 0, 0, 0]])")) == "/: the weight 0 is not greater than 0");
}

TEST_CASE("geomdl: curves as it exports them") {
  const std::string spline = R"({"type": "spline", "rational": true, "dimension": 2, "degree": 2,
      "knotvector": [0.0, 0.0, 0.0, 1.0, 1.0, 1.0], "control_points": {
      "points": [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], "weights": [1.0, 0.75, 1.0]}, "delta": 0.01})";
  const auto file = [](const std::string& type, const std::string& data) {
    return fmt::format(R"({{"shape": {{"type": "{}", "count": 1, "data": [{}]}}}})", type, data);
  };
  CHECK(smooth(file("curve", spline)) ==
        Path(bezier_curve({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, Rational(3, 4), 1})));
  CHECK(refusal(file("surface", spline)) == "/shape/type: a curve is wanted, not a surface");
  CHECK(refusal(file("curve", "")) == "/shape/data: there is no curve");
  CHECK(refusal(file("curve", spline + ", " + spline))
            .starts_with("/shape/data/1/knotvector: between the knots 0 and 1: it starts at "
                         "(1, 0, 0), but the spline ends at (0, 1, 0)"));
}

}  // namespace import_test
