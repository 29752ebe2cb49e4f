#include "phrame/io/read/svg_path.hpp"

#include <doctest/doctest.h>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace svg_path_test {

using namespace phrame;
using test::refusal;

namespace {

std::vector<RationalCurve> curves(const std::string& text) {
  std::vector<RationalCurve> list;
  for (const GivenSegment& segment : read_path_data(text, 0, text.size()))
    list.push_back(std::get<RationalCurve>(segment.form));
  return list;
}

std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE svg [ <!ENTITY a \"b\"> ]>\n<!-- <path d='M'/> -->\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" +
         content + "\n</svg>\n";
}

/// Of a path that is not PH.
const Path& smooth(const NamedPath& named) {
  REQUIRE_FALSE(named.path.is_ph());
  return named.path;
}

}  // namespace

TEST_CASE("path data: all commands, absolute and relative") {
  const auto absolute = curves("M1 2 L3 4 H5 V6 C7 6 8 7 8 8 S9 9 10 8 Q11 7 12 8 T14 8 Z");
  const auto relative = curves("m1 2 l2 2 h2 v2 c2 0 3 1 3 2 s1 1 2 0 q1 -1 2 0 t2 0 z");
  REQUIRE(absolute.size() == 8 + 0);
  CHECK(absolute == relative);
  CHECK(absolute[3] == bezier_curve({{5, 6, 0}, {7, 6, 0}, {8, 7, 0}, {8, 8, 0}}));
  CHECK(absolute[4] == bezier_curve({{8, 8, 0}, {8, 9, 0}, {9, 9, 0}, {10, 8, 0}}));
  CHECK(absolute[6] == bezier_curve({{12, 8, 0}, {13, 9, 0}, {14, 8, 0}}));
  CHECK(absolute[7] == bezier_curve({{14, 8, 0}, {1, 2, 0}}));
}

TEST_CASE("path data: numbers stand without blanks, commands repeat, what has no length goes") {
  CHECK(curves("M0,0.5.5-1e1-2.+3") == curves("M 0 0.5 L 0.5 -10 L -2 3"));
  CHECK(curves("M1 1 5 5L5 5z") == curves("M1 1 L5 5 L1 1"));
  CHECK(curves("M0 0A1 1 0 012 0") == curves("M0 0 A 1 1 0 0 1 2 0"));
  CHECK(curves("M0 0S1 1 2 0") == curves("M0 0 C0 0 1 1 2 0"));
  CHECK(curves("M0 0T1 1") == curves("M0 0 Q0 0 1 1"));
  CHECK(curves("M9 9M0 0L1 0M1 0L2 0") == curves("M0 0H1H2"));
  CHECK(curves("M0 0A0 4 0 0 0 2 2") == curves("M0 0L2 2"));
}

TEST_CASE("a rounded rectangle and a circle of arcs are closed smooth paths, exactly") {
  const NamedPath rectangle = read_any_path(
      "M2 0 H8 A2 2 0 0 1 10 2 V4 A2 2 0 0 1 8 6 H2 A2 2 0 0 1 0 4 V2 A2 2 0 0 1 2 0Z");
  CHECK(smooth(rectangle).is_closed());
  CHECK(smooth(rectangle).end() == 8);
  const NamedPath circle = read_any_path("M1 0a1 1 0 1 0-2 0a1 1 0 1 0 2 0");
  CHECK(smooth(circle).is_closed());
  CHECK(smooth(circle).end() == 4);
  const NamedPath leaf = read_any_path("M0 0 A5 3 20 0 1 4 1");
  CHECK(point(std::get<RationalCurve>(smooth(leaf).segments().back()), 1) ==
        Vector<Rational>{4, 1, 0});
}

TEST_CASE("SVG: the path that is drawn, with the transformations around it") {
  const std::string d = "d=\"M0 0 C1 0 2 1 2 2\"";
  const NamedPath plain = read_any_path(svg("<path " + d + "/>"));
  CHECK(smooth(plain) == smooth(read_any_path("M0 0 C1 0 2 1 2 2")));
  const NamedPath moved = read_any_path(
      svg("<defs><path d=\"M0 0L1 1\"/></defs><g transform=\"translate(10, 20) rotate(90)\">"
          "<path transform='scale(2) matrix(1 0 0 1 1 1)' " +
          d + "></path></g>"));
  // (x, y) → (2x + 2, 2y + 2) → (−2y − 2, 2x + 2) → (8 − 2y, 22 + 2x)
  CHECK(smooth(moved) == smooth(read_any_path("M8 22 C8 24 6 26 4 26")));
  const NamedPath turned = read_any_path(svg("<path transform='rotate(180 1 1)' " + d + "/>"));
  CHECK(smooth(turned) == smooth(read_any_path("M2 2 C1 2 0 1 0 0")));
}

TEST_CASE("what is no path is refused at its line and column") {
  CHECK(refusal("M0 0 L1 0\nL0 0") ==
        "2:1: the tangent turns back: the spline ends in the direction (1, 0, 0), and it starts in "
        "the opposite one, so that frames are undefined there");
  CHECK(refusal("M0 0 L1 0 M2 0 L3 0") ==
        "1:11: a second subpath begins here; one curve is wanted");
  CHECK(refusal("M0 0 L1") == "1:8: a number is expected, not the end");
  CHECK(refusal("M0 0 X1 1") == "1:6: a command is expected, of M L H V C S Q T A Z, not \"X1\"");
  CHECK(refusal("M0 0 A1 1 0 2 0 1 1") == "1:13: a flag, 0 or 1, is expected, not \"2\"");
  CHECK(refusal("M0 0") == "1:5: the path has no length");
  CHECK(refusal("M0 0 L1e999999999 0").starts_with("1:7: "));
  CHECK(refusal("M0 0 Lnan 0") == "1:7: a number is expected, not \"nan\"");
  CHECK(refusal(svg("<path d=\"L1 1\"/>")) == "5:10: a path begins with a moveto, M");
  CHECK(refusal(svg("<rect/>")) == "7:1: the file draws no path and no shape");
  CHECK(refusal(svg("<path d='M0 0L1 1'/>\n<path d='M0 0L1 1'/>")) ==
        "6:1: there are 2 curves, and --pick names one: 5:1, 6:1");
  CHECK(refusal(svg("<g transform='skewX(3 4)'><path d='M0 0L1 1'/></g>")) ==
        "5:15: the transformation skewX of 2 numbers is not applied; matrix, translate, scale, "
        "rotate, skewX and skewY are");
  // Each turn makes them longer: 10⁵ of them took minutes.
  const auto repeated = [](const std::string& transform, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += transform;
    return svg("<path transform='" + all + "' d='M0 0L1 1'/>");
  };
  for (const std::string transform : {"rotate(1) ", "scale(1.0000001) ", "rotate(7 1 2) "})
    CHECK(refusal(repeated(transform, 100'000))
              .ends_with("with this transformation, what all of them make has numbers of more than "
                         "20000 bits"));
  CHECK(refusal(repeated("translate(0.1) ", 1000)).empty());
  CHECK(refusal(svg("<g><path d='M0 0L1 1'/>")).starts_with("6:1: </svg> closes nothing"));
  CHECK(refusal("<svg><path d=\"M0 0\"") ==
        "1:19: an attribute of <path> is expected, name=\"value\"");
  CHECK(refusal("<html></html>") == "1:1: this is no SVG file");
}

}  // namespace svg_path_test
