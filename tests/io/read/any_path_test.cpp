#include "phrame/io/read/any_path.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/data.hpp"
#include "support/refusal.hpp"

namespace any_path_test {

using namespace phrame;

namespace {

/// Of a path that is not PH.
Path smooth(const std::string& text) {
  Path path = read_any_path(text).path;
  REQUIRE_FALSE(path.is_ph());
  return path;
}

PhPath pythagorean(const std::string& text) { return as_ph(read_any_path(text)).value().path; }

const RationalCurve& segment(const Path& path, std::size_t k) {
  return *rational_curve(path.segments()[k]);
}

std::string refusal(const std::string& text, const CurveLimits& limits = {}) {
  return test::refusal_of([&] { read_any_path(text, limits); });
}

std::string content(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Vector<Rational> at(const Path& path, std::size_t k, const Rational& t) {
  return point(segment(path, k), t);
}

std::string object(const std::string& format, const std::string& rest) {
  return fmt::format(R"({{"phrame": "{}", {}}})", format, rest);
}

const std::string cubic = R"("control_points": [[0, 0, 0], [1, 0, 0], [2, 1, 0], [2, 2, 1]])";

}  // namespace

TEST_CASE("what is PH is read as before") {
  for (const auto& entry : std::filesystem::directory_iterator(test::root("/examples/curves"))) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = content(entry.path());
    CAPTURE(entry.path().string());
    std::optional<NamedPhPath> before;
    try {
      before = read_path(text);
    } catch (const InputError&) {
    }
    const NamedPath now = read_any_path(text);
    CHECK(now.path.is_ph() == before.has_value());
    if (!before || !now.path.is_ph()) continue;
    CHECK(now.path.ph() == before->path);
    CHECK(now.name == before->name);
  }
}

TEST_CASE("control points, weights and positions are the curves that they say") {
  const Path bezier = smooth(object("curve/1", cubic));
  CHECK(segment(bezier, 0) == bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}}));
  // Half a turn of the unit circle, by (1 − t², 2t)/(1 + t²) and its Bernstein form.
  const Path circle = smooth(object(
      "curve/1", R"("control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]], "weights": [1, 1, 2])"));
  CHECK(circle == smooth(object("curve/1", R"("basis": "power", "position":
      {"x": [1, 0, -1], "y": [0, 2], "w": [1, 0, 1]})")));
  CHECK(at(circle, 0, Rational(1, 2)) == Vector<Rational>{Rational(3, 5), Rational(4, 5), 0});
  // Equal weights are none, so that a PH curve is one with them, too.
  const std::string quintic = content(test::root("/examples/curves/bezier-quintic.json"));
  std::string weighted = quintic;
  weighted.insert(weighted.find("\"control_points\""), R"("weights": [2, 2, 2, 2, 2, 2], )");
  CHECK(pythagorean(weighted) == pythagorean(quintic));
}

TEST_CASE("what asks for PH curves takes weights and positions for what they are") {
  const auto refused = [](const std::string& text) {
    return test::refusal_of([&] { read_path(text); });
  };
  const std::string line = R"("control_points": [[0, 0, 0], [1, 0, 0], [2, 0, 0]])";
  CHECK(refused(object("curve/1", line)).empty());
  CHECK(refused(object("curve/1", line + R"(, "weights": [1, 2, 2])")).empty());
  const std::string bent = R"("control_points": [[0, 0, 0], [1, 0, 0], [2, 0, 5]])";
  CHECK(refused(object("curve/1", bent + R"(, "weights": [1, 2, 2])")) ==
        "/: this is no PH curve: its weight function W is no constant, and |W^2 r'| is no "
        "polynomial over Q");
  CHECK(read_path(object("curve/1", line + R"(, "weights": [3, 3, 3])")).path ==
        read_path(object("curve/1", line)).path);
  CHECK(read_path(object("curve/1", R"("basis": "power", "position": {"x": [0, 2], "y": [0]})"))
            .path == read_path(object("curve/1", line)).path);
  const std::string parabola = R"("basis": "power", "position": {"x": [0, 1], "y": [0, 0, 1]})";
  CHECK(refused(object("curve/1", parabola)).starts_with("/: this is no PH curve: |r'| is no"));
  CHECK(read_hodograph(object("curve/1", parabola)).hodograph ==
        Vector<Polynomial>{Polynomial{1}, Polynomial{0, 2}, Polynomial{}});
  CHECK_THROWS_AS(read_hodograph(object("curve/1", line + R"(, "weights": [1, 2, 2])")),
                  InputError);
  CHECK(std::holds_alternative<NamedPhPath>(
      read_path_near(object("curve/1", line + R"(, "weights": [1, 1, 1])"), 1)));
  CHECK(read_path(object("points/1", R"("points": [[0, 0], [1, 0]])")).path.end() == 1);
  CHECK(refused(object("points/1", R"("points": [[0, 0], [1, 0], [1, 1]])")) ==
        "/: this is no path of PH curves");
}

TEST_CASE("B-splines are paths of a segment for each span") {
  const Path path = smooth(object("bspline/1", R"("name": "b", "degree": 2,
      "knots": [0, 0, 0, 1, 3, 3, 3], "control_points": [[0, 0], [1, 0], [2, 2], [0, 4]])"));
  CHECK(path.end() == 2);
  // The inner knot divides the edge in the ratio of the spans: P₁ + (P₂ − P₁)/3.
  CHECK(at(path, 1, 0) == Vector<Rational>{Rational(4, 3), Rational(2, 3), 0});
  CHECK(path == smooth(object("bspline/1", R"("degree": 2, "knots": [0, 1, 3],
      "multiplicities": [3, 1, 3], "control_points": [[0, 0], [1, 0], [2, 2], [0, 4]])")));
  const Path circle = smooth(object("nurbs/1", R"("degree": 2,
      "knots": [0, 0, 0, 1, 1, 2, 2, 2], "weights": [1, 0.7071067811865476, 1, 0.75, 1],
      "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0]])"));
  CHECK(at(circle, 1, 1) == Vector<Rational>{-1, 0, 0});
}

TEST_CASE("splines mix segments of all kinds, joined exactly") {
  const Path path = smooth(object("spline/1", R"("name": "mixed", "segments": [
      {"control_points": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], "weights": [1, 1, 2]},
      {"basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [1]}},
      {"phrame": "bspline/1", "degree": 2, "knots": [0, 0, 0, 1, 1, 1],
       "control_points": [[1, 3, 0], [1, 4, 0], [2, 5, 0]]}])"));
  CHECK(path.segments().size() == 3);
  CHECK(at(path, 1, 0) == Vector<Rational>{1, 1, 0});
  CHECK(at(path, 2, 1) == Vector<Rational>{2, 5, 0});
}

TEST_CASE("points are cubic splines") {
  const std::string points = R"("points": [[0, 0, 0], [1, 2, 0], [3, 3, 1], [4, 0, 0]])";
  const Path natural = smooth(object("points/1", points));
  CHECK(natural.end() == 3);
  CHECK(natural == smooth("x,y,z\n0,0,0\n1,2,0\n3,3,1\n4,0,0\n"));
  CHECK(natural == smooth("0 0 0\n1 2 0\n3 3 1\n4 0 0\n"));
  const Path closed = smooth(
      "# kind: periodic\n# spacing: uniform\nx,y,z\n0,0,0\n1,2,0\n"
      "3,3,1\n4,0,0\n");
  CHECK(closed.is_closed());
  CHECK(closed ==
        smooth(object("points/1", points + R"(, "kind": "periodic", "spacing": "uniform")")));
  const Path clamped = smooth(object("points/1", points + R"(, "kind": "clamped",
      "start_derivative": [0, 0, 7], "end_derivative": [1, 1, 1])"));
  CHECK(segment(clamped, 0).direction()[0](0) == 0);
  CHECK(at(clamped, 2, 1) == Vector<Rational>{4, 0, 0});
  const Path hermite = smooth("x,y,dx,dy\n0,0,1,0\n1,1,0,1\n");
  CHECK(segment(hermite, 0) ==
        bezier_curve({{0, 0, 0}, {Rational(1, 3), 0, 0}, {1, Rational(2, 3), 0}, {1, 1, 0}}));
}

TEST_CASE("tables of control points") {
  CHECK(smooth("# kind: bezier\nx,y,z,w\n1,0,0,1\n1,1,0,1\n0,1,0,2\n") ==
        smooth(object("curve/1", R"("basis": "power", "position":
            {"x": [1, 0, -1], "y": [0, 2], "z": [0], "w": [1, 0, 1]})")));
  CHECK(smooth("# kind: bspline\n# degree: 2\n0 0 0\n1 0 0\n1 1 0\n2 1 1\n") ==
        smooth(object("bspline/1", R"("degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2],
            "control_points": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 1]])")));
  CHECK(refusal("x,y,w\n0,0,1\n1,1,2\n").starts_with("line 2: weights, a column w, are those of"));
  CHECK(refusal("# kind: bezier\nx,y,w\n0,0,1\n1,1,0\n") ==
        "line 4, w: the weight 0 is not greater than 0");
  CHECK(refusal("# kind: bspline\n# degree: 3\n0 0\n1 0\n1 1\n") ==
        "line 2: the degree 3 is no whole number from 1 to 2, one less than there are points");
  CHECK(refusal("# kind: loop\n0 0\n1 0\n") ==
        "line 1: the kind is one of natural, periodic, polyline, bezier, bspline, not \"loop\"");
}

TEST_CASE("what is wrong is refused at its place, in one line") {
  CHECK(refusal(object("curve/1", cubic + R"(, "weights": [1, 1, -1, 1])")) ==
        "/weights/2: the weight -1 is not greater than 0");
  CHECK(refusal(object("curve/1", cubic + R"(, "weights": [1, 1])")) ==
        "/weights: 2 weights for 4 control points");
  CHECK(refusal(object("curve/1", R"("basis": "power", "position":
            {"x": [0, 1], "y": [1], "z": [0], "w": [1, -2]})")) ==
        "/position: the weight function is 0 at t = 1/2");
  CHECK(refusal(object("curve/1", R"("basis": "power", "position": {"x": [1], "y": [1]})")) ==
        "/position: the curve is the point (1, 1, 0)");
  CHECK(refusal(object("bspline/1", R"("degree": 2, "knots": [0, 0, 0, 2, 1, 3, 3],
            "control_points": [[0, 0], [1, 0], [2, 2], [0, 4]])")) ==
        "/knots/4: the knots decrease, from 2 to 1");
  CHECK(refusal(object("bspline/1", R"("degree": 2, "knots": [0, 1], "multiplicities": [3, 4],
            "control_points": [[0, 0], [1, 0], [2, 2]])")) ==
        "/multiplicities/1: the multiplicity 4 is beyond 3");
  CHECK(refusal(object("bspline/1", R"("degree": 2, "knots": [0, 0, 0, 1, 1, 1],
            "control_points": [[0, 0], [1, 0, 0], [2, 2]])")) ==
        "/control_points/1: 3 numbers here, but 2 in the first point");
  CHECK(refusal(object("bspline/1", R"("degree": 1, "knots": [0, 0, 1, 2, 2],
            "control_points": [[0, 0], [1, 0], [-1, 0]])"))
            .starts_with("/knots: between the knots 1 and 2: the tangent turns back"));
  CHECK(refusal(object("bspline/1", R"("degree": 2.5, "knots": [], "control_points": [])")) ==
        "/degree: the degree 5/2 is no whole number");
  CHECK(refusal(object("bspline/1", R"("degree": 2, "knots": [], "control_points": [])"))
            .starts_with("/control_points: degree 2 needs 3 control points at least, not 0"));
  CHECK(refusal(object("nurbs/1", R"("degree": 2, "knots": [0, 0, 0, 1, 1, "1e999999999"],
            "control_points": [[0, 0], [1, 0], [2, 2]])"))
            .starts_with("/knots/5: "));
  CHECK(refusal(object("points/1", R"("points": [])")) ==
        "/points: 0 points; a curve needs two at least");
  CHECK(
      refusal(object("points/1", R"("points": [[0, 0], [1, "nan"]])")).starts_with("/points/1/1"));
  CHECK(refusal(object("points/1", R"("points": [[0, 0], [1, 1]], "kind": "clamped")")) ==
        "/: the key \"start_derivative\" is missing");
  CHECK(refusal(object("spline/1", R"("segments": [{"control_points": [[0, 0, 0], [1, 0, 0]]},
            {"control_points": [[1, 0, 0], [0, 0, 0], [2, 2, 3]]}])"))
            .starts_with(
                "/segments/1: the tangent turns back: the spline ends in the direction (1, 0, 0)"));
  CHECK(refusal("hello") == "1:1: a curve file is JSON, this begins with \"hello\"");
  CHECK(refusal("lat,lon\n1,2\n3,4\n") ==
        "line 1: columns x, y and z, or x and y, are wanted; these are lat, lon");
  CHECK(refusal("{\"phrame\": 1}\n{\"phrame\": 1}\n") ==
        "2:1: a curve file is one JSON document; these are JSON lines, which phrame batch reads");
  CHECK(refusal("") == "1:1: not valid JSON: the input is empty");
  CHECK(refusal(object("curve/2", cubic)).starts_with("/phrame: the format is \"curve/1\", "));
}

TEST_CASE("numbers of more than 20000 bits are refused where they are") {
  const auto refused = [](const std::string& text) {
    return test::refusal_of([&] { read_any_path(text); });
  };
  const std::string long_number = "has more than 20000 bits";
  CHECK(refused(object("curve/1", R"("control_points": [[0, 0], [1, 1e99999], [2, 0], [3, 1]])")) ==
        "/control_points/1/1: the number 1e99999 " + long_number);
  CHECK(refused(object("nurbs/1", R"("degree": 1, "knots": [0, 0, "1E-9999", 1],
                       "control_points": [[0, 0], [1, 1]], "weights": [1, 1])")) ==
        "/knots/2: the number 1E-9999 " + long_number);
  CHECK(refused("x,y,z\n0,0,0\n1e-7000,1,1\n2,1,0\n").starts_with("line 3: the number 1/1000"));
  CHECK(refused("M 0 0 C 1 2 1e99999 4 5 5") == "1:13: the number 1e99999 " + long_number);
  CHECK(refused(object("curve/1", R"("control_points": [[0, 0, 0], [1, 1e5999, 0], [2, 0, 1]])"))
            .empty());
  CHECK(refused(object(
            "curve/1",
            R"("basis": "power", "preimage": {"u": [1e7000], "v": [0], "p": [0], "q": [1]})")) ==
        "/preimage/u/0: the number 1e7000 " + long_number);
}

}  // namespace any_path_test
