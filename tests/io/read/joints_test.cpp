#include "phrame/io/read/joints.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/curve/place.hpp"
#include "support/expression_curves.hpp"
#include "support/refusal.hpp"

using namespace phrame;

namespace joints_test {

const Rational tiny(1, pow(Integer(10), 16));

GivenSegment line(const Vector<Rational>& a, const Vector<Rational>& b) {
  return bezier_segment({{a, b}, {}}, "here");
}

Vector<Rational> start_of(const GivenSegment& segment) {
  return point(std::get<RationalCurve>(segment.form), 0);
}

}  // namespace joints_test

using namespace joints_test;

TEST_CASE("joints: gaps that are rounding are closed by the start of the later segment") {
  std::vector<GivenSegment> lines{line({0, 0, 0}, {1, 0, 0}), line({1, tiny, 0}, {1, 1, 0}),
                                  line({1, 1, 0}, {0, 1, 0})};
  CHECK(close_gaps(lines, {}) == "a gap of at most 1.1e-16 closed, by moving a point");
  CHECK(start_of(lines[1]) == Vector<Rational>{1, 0, 0});
  CHECK(end_point(lines[1]) == Vector<Rational>{1, 1, 0});
  CHECK(close_gaps(lines, {}).empty());
}

TEST_CASE(
    "joints: the end is moved to the start, but not that of a path hardly longer than its gap") {
  std::vector<GivenSegment> loop{line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0}, {1, 1, 0}),
                                 line({1, 1, 0}, {0, -tiny, 0})};
  CHECK_FALSE(close_gaps(loop, {}).empty());
  CHECK(end_point(loop.back()) == Vector<Rational>{0, 0, 0});
  CHECK(start_of(loop.back()) == Vector<Rational>{1, 1, 0});
  CHECK(path_of("", loop).path.is_closed());
  std::vector<GivenSegment> dot{line({1, 0, 0}, {1, tiny, 0})};
  CHECK(close_gaps(dot, {}).empty());
}

TEST_CASE("joints: greater gaps are closed where they are asked for, and refused where not") {
  std::vector<GivenSegment> lines{line({0, 0, 0}, {1, 0, 0}),
                                  line({1, Rational(1, 100), 0}, {1, 1, 0})};
  CHECK(close_gaps(lines, {}).empty());
  CHECK_THROWS_AS(path_of("", lines), InputError);
  const NamedPath named = path_of("", lines, Rational(1, 50));
  REQUIRE(named.notes.size() == 1);
  CHECK(named.notes.front() == "a gap of at most 1.1e-2 closed, by moving a point");
}

TEST_CASE("joints: a greater EPS closes all that a smaller one does") {
  const auto loop = [](const Rational& off) {
    return std::vector<GivenSegment>{line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0}, {1, 1, 0}),
                                     line({1, 1, 0}, {0, off, 0})};
  };
  for (const Rational& off : {Rational(1, 200), tiny / 10})
    for (const Rational& most : {Rational(1, 100), Rational(1)})
      CHECK(path_of("", loop(off), most).path.is_closed());
  CHECK_FALSE(path_of("", loop(Rational(1, 200))).path.is_closed());
}

TEST_CASE("joints: an end is not moved where the path would turn back for it") {
  const std::vector<GivenSegment> there_and_back{line({0, 0, 0}, {1, 0, 0}),
                                                 line({1, 0, 0}, {0, tiny, 0})};
  const NamedPath named = path_of("", there_and_back);
  CHECK(named.notes.empty());
  CHECK(named.path.corners().size() == 1);
  CHECK_FALSE(named.path.ends_meet());
}

TEST_CASE("joints: a PH curve is moved as a whole, and so stays one") {
  const Curve curve({{1, 1}, {}, {0, 1}, {}}, {1}, {1, tiny, 0});
  std::vector<GivenSegment> segments{line({0, 0, 0}, {1, 0, 0}), {curve, "here"}};
  close_gaps(segments, {});
  CHECK(std::get<Curve>(segments[1].form) == Curve(curve.preimage(), {1}, {1, 0, 0}));
}

TEST_CASE("joints: next to formulas nothing is moved") {
  std::vector<GivenSegment> segments{
      {test::expression_curve({"cos(s)", "sin(s)", "0"}, "0", "pi"), "here"},
      line({-1, tiny, 0}, {-1, -1, 0})};
  CHECK(close_gaps(segments, Rational(1)).empty());
}

TEST_CASE("joints: that formulas end next to their start is said") {
  const auto notes = [](const char* to) {
    return path_of("", {{test::expression_curve({"cos(s)", "sin(s)", "0"}, "0", to), "here"}})
        .notes;
  };
  const auto rounded = notes("6.283185307179586");
  REQUIRE(rounded.size() == 1);
  CHECK(rounded.front() ==
        "its ends are up to 4.8e-16 apart, and formulas are not moved: it is open");
  CHECK(notes("2*pi").empty());
  CHECK(notes("6").empty());
}

TEST_CASE("joints: a table of a closed curve may end next to its first point") {
  const std::string square = "x,y\n1,0\n0,1\n-1,0\n0,-1\n1,-2.4e-16\n";
  const NamedPath periodic = read_any_path("# kind: periodic\n" + square);
  CHECK(periodic.path.segments().size() == 4);
  CHECK(periodic.path.is_closed());
  FileReading reading;
  reading.kind = "polyline";
  const NamedPath polyline = read_any_path(square, {}, reading);
  CHECK(polyline.path.segments().size() == 4);
  CHECK(polyline.path.closes_at_corner());
  CHECK(polyline.path.corners().size() == 3);
  CHECK(position(polyline.path, {3, Rational(1)})[1].exact() == Rational(0));
}

TEST_CASE("joints: a polyline has no parameters, and no degree but one") {
  const auto refusal = [](const std::string& text) {
    return test::refusal_of([&] { read_any_path(text); });
  };
  CHECK(read_any_path(R"({"phrame": "points/1", "kind": "polyline",
      "points": [[0, 0], [1, 0], [1, 1]]})")
            .path.corners()
            .size() == 1);
  CHECK(refusal("# kind: polyline\n# degree: 2\nx,y\n0,0\n1,0\n") ==
        "line 2: a polyline has the degree 1");
  CHECK(refusal("# kind: polyline\nx,y\n0,0\n0,0\n").starts_with("line 4: the point (0, 0, 0)"));
  CHECK(refusal(R"({"phrame": "points/1", "kind": "polyline", "parameters": [0, 1],
      "points": [[0, 0], [1, 0]]})")
            .find("neither derivatives nor parameters") != std::string::npos);
}
