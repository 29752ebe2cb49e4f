#include "phrame/io/read/gcode_file.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "io/reference.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace gcode_file_test {

using namespace phrame;
using std::numbers::pi;
using test::refusal;

namespace {

double length_of(const NamedPath& named) { return round_to_double(PathLength(named.path).total()); }

double length_of(const std::string& text) { return length_of(read_any_path(text)); }

Vector<Rational> end_of_text(const std::string& text) {
  return point(*rational_curve(read_any_path(text).path.segments().back()), 1);
}

/// Is (x − a)² + (y − b)² = r² all along, exactly?
bool is_on_circle(const Segment& segment, const Rational& a, const Rational& b, const Rational& r) {
  const RationalCurve& curve = *rational_curve(segment);
  const Polynomial& W = curve.weight();
  const Polynomial x = curve.numerator()[0] - a * W;
  const Polynomial y = curve.numerator()[1] - b * W;
  return x * x + y * y == r * r * W * W;
}

}  // namespace

TEST_CASE("G-code: lines and arcs about centers are exact, and the path starts where all is told") {
  const NamedPath named = read_any_path(
      "%\nO7 (a pocket)\nN10 G21 G90 G17 ; metric\nN20 G0 Z5\nN30 G0X1Y2\nN40 g1 z-1.25 F100\n"
      "G3 X11 Y12 I0 J10\nG2 X11 Y12 I3 J4\nM30\n");
  const auto& segments = named.path.segments();
  CHECK(point(*rational_curve(segments[0]), 0) == Vector<Rational>{1, 2, 5});
  CHECK(point(*rational_curve(segments[0]), 1) == Vector<Rational>{1, 2, Rational(-5, 4)});
  CHECK(is_on_circle(segments[1], 1, 12, 10));
  CHECK(point(*rational_curve(segments[1]), 1) == Vector<Rational>{11, 12, Rational(-5, 4)});
  REQUIRE(segments.size() == 6);  // a quarter, and a circle of four
  for (std::size_t k = 2; k < 6; ++k) CHECK(is_on_circle(segments[k], 14, 16, 5));
  CHECK(length_of(named) == doctest::Approx(6.25 + 5 * pi + 10 * pi).epsilon(1e-15));
  // Clockwise: to the left of (11, 12), seen from the center, is up.
  CHECK(point(*rational_curve(segments[2]), Rational(1, 2))[1] > 12);
}

// A chord of 10√2 of the radius 10 is a quarter; with −10 the other three.
TEST_CASE("G-code: R, G91, planes and curves") {
  const std::string start = "G90\nG1 X0 Y0 Z0\n";
  CHECK(length_of(start + "G2 X10 Y10 R10\n") == doctest::Approx(5 * pi));
  CHECK(length_of(start + "G2 X10 Y10 R-10\n") == doctest::Approx(15 * pi));
  CHECK(end_of_text("G91\nG1 X1 Y2\nX3\nG3 X2 Y2 I0 J2\n") == Vector<Rational>{6, 4, 0});
  // In G18 the axes are Z, X: from −X about (10, 0) clockwise comes −Z.
  CHECK(length_of(start + "G18 G2 X10 Z-10 I10 K0\n") == doctest::Approx(5 * pi));
  CHECK(length_of(start + "G18 G2 X10 Z10 I10 K0\n") == doctest::Approx(15 * pi));
  CHECK(length_of(start + "G19 G3 Y10 Z10 J0 K10\n") == doctest::Approx(5 * pi));
  CHECK(length_of(start + "G90.1 G3 X10 Y10 I0 J10\n") == doctest::Approx(5 * pi));
  CHECK(read_any_path(start + "G5 X4 Y0 I1 J2 P-1 Q3\n").path ==
        read_any_path("M0 0C1 2 3 3 4 0").path);
  CHECK(read_any_path(start + "G5.1 X4 Y0 I1 J2\n").path == read_any_path("M0 0Q1 2 4 0").path);
}

TEST_CASE("G-code: helical arcs rise evenly, and arcs that miss their circle keep their ends") {
  const NamedPath helix = read_any_path("G1 X2 Y0 Z0\nG3 X2 Y0 Z3 I-2 J0\n");
  CHECK(length_of(helix) == doctest::Approx(std::hypot(4 * pi, 3)).epsilon(1e-7));
  CHECK(helix.notes == std::vector<std::string>{
                           "1 arc moves across the plane of the arc, too, within 1e-5 of what a "
                           "turn rises"});
  const PathLength length(helix.path);
  for (const double share : {0.1, 0.4, 0.77}) {
    const Place at = length.point(exact_rational(share * length_of(helix)));
    const Vector<Real> exact = position(helix.path, at);
    const Vector<double> r{round_to_double(exact[0]), round_to_double(exact[1]),
                           round_to_double(exact[2])};
    CHECK(r[0] == doctest::Approx(2 * std::cos(2 * pi * share)).epsilon(1e-4));
    CHECK(std::abs(r[2] - 3 * share) < 3e-5);
  }
  const NamedPath missed = read_any_path("G1 X0 Y0\nG3 X1.4142 Y0.5858 I0 J2\n");
  CHECK(point(*rational_curve(missed.path.segments().back()), 1) ==
        Vector<Rational>{Rational(14142, 10000), Rational(5858, 10000), 0});
  CHECK(refusal("G1 X0 Y0\nG3 X5 Y5 I0 J2\n").starts_with("line 2: the end is "));
}

TEST_CASE("G-code: what is between rapid moves may be picked") {
  const std::string text = "G0 X0 Y0\nG1 X1\nX2 Y1\nG0 X5\nY5\nG1 X6\nG0 Y9\n";
  const NamedPath whole = read_any_path(text);
  CHECK(whole.path.segments().size() == 6);
  CHECK(whole.notes.front() ==
        "3 rapid moves (G0) are lines of the path, too; --pick takes what is between them, of 1 to "
        "2");
  FileReading second;
  second.pick = "2";
  const NamedPath picked = read_any_path(text, {}, second);
  CHECK(point(*rational_curve(picked.path.segments().front()), 0) == Vector<Rational>{5, 5, 0});
  second.pick = "3";
  CHECK(refusal(text, second) == "there is no curve \"3\"; there are 1, 2");
}

TEST_CASE("G-code: what is not read is refused by its line") {
  CHECK(refusal("G21\nG81 X1 Y1 Z-3 R2\n").starts_with("line 2: G81 is not read: G0 to G3, G5"));
  CHECK(refusal("G1 X#1\n") == "line 1: a number is expected behind X: X#1");
  CHECK(refusal("G2 X1 Y1 I1 J0\n") ==
        "line 1: a curve begins before the places of X, Y and Z are told");
  CHECK(refusal("G1 X0 Y0\nG2 X1 Y1\n") == "line 2: an arc has I, J or K in its plane, or R");
  CHECK(refusal("G1 X0 Y0\nG2 X0 Y0 R2\n")
            .starts_with("line 2: an arc with R ends elsewhere than it starts"));
  CHECK(refusal("G1 X0 Y0 (open\n") == "line 1: the comment is without its \")\"");
  CHECK(refusal("G20\nG1 X0 Y0\nG21 X1\n").starts_with("line 3: the unit changes"));
  CHECK(refusal("G1 X0 Y0\nX1 X2\n") == "line 2: X is there twice");
  CHECK(refusal("G21\nM30\n") == "line 2: the program moves along no curve");
}

TEST_CASE("APT: a program without points is refused, and a mark before the text is no matter") {
  CHECK(refusal("PARTNO/A\nFINI\n") == "line 1: the program has no GOTO/ and no FROM/");
  const std::string program = "G0 X0 Y0\nG1 X1 Y2\n";
  CHECK(read_any_path("\xEF\xBB\xBF" + program).path == read_any_path(program).path);
}

TEST_CASE("APT: the points of GOTO are joined by lines, or by what is asked for") {
  const std::string text = "PARTNO/A\nFROM/0,0,0\nFEDRAT/100\nGOTO/1,0,0,0,0,1\ngoto / 1, 2.5, 0\n";
  const NamedPath lines = read_any_path(text);
  CHECK(lines.path.segments().size() == 2);
  CHECK(point(*rational_curve(lines.path.segments()[1]), 1) ==
        Vector<Rational>{1, Rational(5, 2), 0});
  CHECK(lines.notes.back() == "the axes of the tool are left out");
  FileReading spline;
  spline.kind = "natural";
  CHECK(degree(*rational_curve(read_any_path(text, {}, spline).path.segments()[0])) == 3);
  CHECK(refusal("GOTO/1,2\n") == "line 1: a point has three coordinates, not 2");
}

}  // namespace gcode_file_test
