#include "phrame/io/read/dxf_file.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "io/reference.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "support/text.hpp"

namespace dxf_file_test {

using namespace phrame;
using std::numbers::pi;
using test::contains;
using test::refusal;

namespace {

/// "0 LINE 8 a 10 1": codes and values, by blanks.
std::string dxf(const std::string& groups) {
  std::string text = "  0\nSECTION\n  2\nENTITIES\n" + groups + " 0 ENDSEC 0 EOF\n";
  for (char& c : text)
    if (c == ' ') c = '\n';
  // Codes are written with blanks before them, and lines may be of Windows.
  std::string lines = " ";
  for (const char c : text)
    if (c != '\n' || lines.back() != '\n') lines += c;
  return lines.substr(lines.find('0'));
}

NamedPath picked(const std::string& text, const std::string& name) {
  FileReading reading;
  reading.pick = name;
  return read_any_path(text, {}, reading);
}

double length_of(const NamedPath& named) { return round_to_double(PathLength(named.path).total()); }

}  // namespace

// The bulge is the tangent of a quarter of the angle: 1 is half a turn, √2 − 1 a quarter.
TEST_CASE("DXF: arcs of polylines are exact, of their angle and between their points") {
  const NamedPath half = read_any_path(dxf("0 LWPOLYLINE 70 0 10 0 20 0 42 1 10 4 20 0"));
  REQUIRE(half.path.segments().size() == 2);
  for (const Segment& segment : half.path.segments()) {
    const RationalCurve& curve = *rational_curve(segment);
    const Polynomial x = curve.numerator()[0] - 2 * curve.weight();
    CHECK(x * x + curve.numerator()[1] * curve.numerator()[1] ==
          4 * curve.weight() * curve.weight());
  }
  // Counterclockwise from (0, 0) to (4, 0) is below.
  CHECK(point(*rational_curve(half.path.segments()[0]), 1) == Vector<Rational>{2, -2, 0});
  for (const double bulge : {0.2, -0.7, 1.0, 3.5}) {
    const NamedPath arc = read_any_path(
        dxf("0 LWPOLYLINE 70 0 38 7 10 1 20 2 42 " + std::to_string(bulge) + " 10 4 20 6"));
    const double angle = 4 * std::atan(std::abs(bulge));
    CHECK(length_of(arc) == doctest::Approx(angle * 2.5 / std::sin(angle / 2)).epsilon(1e-14));
    CHECK(arc.path.corners().empty());
    CHECK(point(*rational_curve(arc.path.segments().back()), 1) == Vector<Rational>{4, 6, 7});
  }
}

TEST_CASE("DXF: entities of a layer that meet are one curve, in any order and direction") {
  const std::string text =
      dxf("0 LINE 8 pipe 10 10 20 0 30 0 11 0 21 0 31 0 0 CIRCLE 8 hole 10 1 20 2 30 3 40 2 "
          "0 LINE 8 pipe 10 15 20 20 11 15 21 5 0 ARC 8 pipe 10 10 20 5 40 5 50 -90 51 0 "
          "0 TEXT 8 pipe 1 hello");
  const NamedPath pipe = picked(text, "pipe");
  CHECK(pipe.path.segments().size() == 3);
  CHECK(pipe.path.corners().empty());
  CHECK(length_of(pipe) == doctest::Approx(10 + 2.5 * pi + 15).epsilon(1e-15));
  CHECK(pipe.notes == std::vector<std::string>{"left out are TEXT"});
  const NamedPath hole = picked(text, "hole");
  CHECK(hole.path.is_closed());
  CHECK(length_of(hole) == doctest::Approx(4 * pi).epsilon(1e-15));
  CHECK(refusal(text).ends_with("there are 2 curves, and --pick names one: pipe, hole"));
}

TEST_CASE("DXF: splines, ellipses, polylines of vertices, and what is mirrored") {
  const NamedPath spline = read_any_path(dxf(
      "0 SPLINE 70 8 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 2 41 1 10 0 20 0 30 0 10 1 20 2 "
      "30 0 10 3 20 0 30 1"));
  CHECK(spline.path == read_any_path(R"({"phrame": "curve/1",
      "control_points": [[0,0,0],[1,2,0],[3,0,1]], "weights": [1,2,1]})")
                           .path);
  const NamedPath quarter = read_any_path(
      dxf("0 ELLIPSE 10 0 20 0 30 1 11 4 21 0 31 0 40 0.5 41 0 42 1.5707963267948966"));
  CHECK(point(*rational_curve(quarter.path.segments()[0]), 0) == Vector<Rational>{4, 0, 1});
  CHECK(point(*rational_curve(quarter.path.segments()[0]), 1) == Vector<Rational>{0, 2, 1});
  const NamedPath whole =
      read_any_path(dxf("0 ELLIPSE 10 0 20 0 11 4 21 0 31 0 40 0.5 41 0 42 6.283185307179586"));
  CHECK(whole.path.is_closed());
  const NamedPath old = read_any_path(dxf(
      "0 POLYLINE 66 1 70 8 0 VERTEX 10 0 20 0 30 0 70 32 0 VERTEX 10 1 20 0 30 0 70 32 0 VERTEX "
      "10 1 20 1 30 5 70 32 0 SEQEND 8 0"));
  CHECK(point(*rational_curve(old.path.segments()[1]), 1) == Vector<Rational>{1, 1, 5});
  const NamedPath mirrored = read_any_path(dxf("0 ARC 10 1 20 0 40 1 50 0 51 90 230 -1"));
  CHECK(point(*rational_curve(mirrored.path.segments()[0]), 0) == Vector<Rational>{-2, 0, 0});
}

/// With a block, its entities and its base point.
std::string with_block(const std::string& block, const std::string& groups) {
  const std::string all =
      dxf("0 BLOCK " + block + " 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES " + groups);
  return all.substr(0, all.find("ENTITIES")) + "BLOCKS" + all.substr(all.find("ENTITIES") + 8);
}

Vector<Rational> start_of(const NamedPath& named) {
  return point(*rational_curve(named.path.segments().front()), 0);
}
Vector<Rational> end_of(const NamedPath& named) {
  return point(*rational_curve(named.path.segments().back()), 1);
}

// A point p comes to at + R(S(p − base)) [DXF Reference, INSERT].
TEST_CASE("DXF: blocks are where they are put, turned, scaled, in rows and in one another") {
  const std::string line = "2 mark 10 1 20 1 30 0 0 LINE 5 A 8 0 10 1 20 1 11 3 21 1";
  const NamedPath put =
      read_any_path(with_block(line, "0 INSERT 5 B 8 tool 2 mark 10 10 20 20 30 5"));
  CHECK(start_of(put) == Vector<Rational>{10, 20, 5});
  CHECK(end_of(put) == Vector<Rational>{12, 20, 5});
  const NamedPath turned =
      read_any_path(with_block(line, "0 INSERT 2 mark 8 tool 10 10 20 20 41 3 42 2 43 1 50 90"));
  CHECK(start_of(turned) == Vector<Rational>{10, 20, 0});
  CHECK(end_of(turned) == Vector<Rational>{10, 26, 0});
  const NamedPath mirrored =
      read_any_path(with_block(line, "0 INSERT 2 mark 8 tool 10 10 20 20 230 -1"));
  CHECK(end_of(mirrored) == Vector<Rational>{-12, 20, 0});
  // Two columns beside each other, turned with the block: by its layer, and handles.
  const std::string columns =
      with_block(line, "0 INSERT 5 B 8 tool 2 mark 10 0 20 0 50 90 70 2 71 1 44 2 45 9");
  CHECK(end_of(picked(columns, "tool")) == Vector<Rational>{0, 4, 0});
  const std::string apart =
      with_block(line, "0 INSERT 5 B 8 tool 2 mark 10 0 20 0 0 INSERT 5 C 8 tool 2 mark 10 0 20 7");
  CHECK(start_of(picked(apart, "C/A")) == Vector<Rational>{0, 7, 0});
  // A circle that is stretched is an ellipse, here of the half axes 4 and 2.
  const NamedPath ellipse = read_any_path(
      with_block("2 o 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 2", "0 INSERT 8 a 2 o 10 0 20 0 41 2"));
  CHECK(length_of(ellipse) == doctest::Approx(19.376896441095454).epsilon(1e-12));
  const NamedPath nested = read_any_path(
      with_block(line + " 0 ENDBLK 0 BLOCK 2 outer 10 0 20 0 0 INSERT 8 0 2 mark 10 5 20 0",
                 "0 INSERT 8 tool 2 outer 10 0 20 1 41 2 42 2"));
  CHECK(start_of(nested) == Vector<Rational>{10, 1, 0});
  CHECK(end_of(nested) == Vector<Rational>{14, 1, 0});
  CHECK(contains(
      refusal(with_block("2 a 10 0 20 0 0 INSERT 8 0 2 a 10 0 20 0", "0 INSERT 8 0 2 a 10 0 20 0")),
      "INSERT: blocks are in blocks more than 32 deep"));
  CHECK(contains(refusal(with_block("2 a 10 0 20 0", "0 INSERT 2 a 10 0 20 0 70 999999 71 999999")),
                 "INSERT: there are more than 200000 copies of a block"));
  CHECK(contains(refusal(dxf("0 INSERT 8 0 2 lost 10 0 20 0")), "it has INSERT"));
}

TEST_CASE("DXF: what is not read is refused by its line") {
  CHECK(refusal(dxf("0 SPLINE 71 3 11 0 21 0")) ==
        "line 6: SPLINE: the spline has fit points only: its control points are wanted");
  CHECK(refusal(dxf("0 LINE 10 0 20 0 11 x 21 0")).starts_with("line 12: \"x\" is not a number"));
  CHECK(refusal(dxf("0 ARC 10 0 20 0 40 1 50 0")) == "line 6: ARC: the group 51 is missing");
  CHECK(refusal(dxf("0 CIRCLE 10 0 20 0 40 1 210 1 230 0")) ==
        "line 6: CIRCLE: only extrusions along z and −z are read");
  CHECK(refusal(dxf("0 POLYLINE 70 64")) == "line 6: POLYLINE: a mesh is no curve");
  CHECK(refusal(dxf("0 TEXT 1 a 0 TEXT 1 b")) ==
        "line 1: there is no curve in the section ENTITIES: it has 2 TEXT");
  CHECK(refusal("0\nSECTION\nx\n") == "line 3: a group code is expected, not \"x\"");
}

}  // namespace dxf_file_test
