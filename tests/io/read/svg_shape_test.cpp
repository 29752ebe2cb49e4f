#include "phrame/io/read/svg_shape.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <numbers>

#include "io/reference.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "support/text.hpp"

namespace svg_shape_test {

using namespace phrame;
using std::numbers::pi;
using test::contains;
using test::refusal;

namespace {

NamedPath read(const std::string& content, const std::string& pick = "") {
  FileReading reading;
  reading.pick = pick;
  return read_any_path("<svg xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>", {},
                       reading);
}

double length_of(const NamedPath& named) { return round_to_double(PathLength(named.path).total()); }

Vector<Rational> start_of_path(const NamedPath& named) {
  return point(*rational_curve(named.path.segments().front()), 0);
}

std::string refused(const std::string& content) {
  return refusal("<svg xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>");
}

}  // namespace

// The paths that SVG 2, 10, says they are equivalent to.
TEST_CASE("SVG shapes: outlines are those of the paths they are equivalent to") {
  CHECK(read("<rect x='1' y='2' width='10' height='6'/>").path ==
        read_any_path("M1 2H11V8H1Z").path);
  CHECK(read("<line x1='1' y1='2' x2='3px' y2=' 4 '/>").path == read_any_path("M1 2L3 4").path);
  CHECK(read("<polyline points='0,0 1,0 1 1'/>").path == read_any_path("M0 0H1V1").path);
  CHECK(read("<polygon points='0,0 1,0 1 1'/>").path == read_any_path("M0 0H1V1Z").path);
  const NamedPath round = read("<rect x='1' y='2' width='10' height='6' rx='2'/>");
  CHECK(round.path.segments().size() == 8);
  CHECK(round.path.is_closed());
  CHECK(round.path.corners().empty());
  CHECK(start_of_path(round) == Vector<Rational>{3, 2, 0});
  CHECK(round.path == read("<rect x='1' y='2' width='10' height='6' ry='2'/>").path);
  CHECK(length_of(round) == doctest::Approx(32 - 16 + 4 * pi).epsilon(1e-15));
  // Corners are at most half a side: an ellipse of the half axes 5 and 1, as ry = 1 is given.
  CHECK(length_of(read("<rect width='10' height='2' rx='7' ry='1'/>")) ==
        doctest::Approx(length_of(read("<ellipse rx='5' ry='1'/>"))).epsilon(1e-14));
  const NamedPath circle = read("<circle cx='1' cy='2' r='3'/>");
  CHECK(circle.path.is_closed());
  CHECK(start_of_path(circle) == Vector<Rational>{4, 2, 0});
  CHECK(length_of(circle) == doctest::Approx(6 * pi).epsilon(1e-15));
  CHECK(circle.path == read("<ellipse cx='1' cy='2' rx='3' ry='auto'/>").path);
}

TEST_CASE("SVG shapes: transformations, what is hidden, and which is picked") {
  CHECK(start_of_path(
            read("<g transform='translate(10)'><circle r='1' transform='scale(2,1)'/></g>")) ==
        Vector<Rational>{12, 0, 0});
  CHECK(read("<line x2='1' y2='1' transform='skewX(45)'/>").path == read_any_path("M0 0L2 1").path);
  CHECK(read("<line x2='1' y2='1' transform='skewY(45)'/>").path == read_any_path("M0 0L1 2").path);
  CHECK(read("<line x2='1'/><rect style='fill:none;display:none' width='3' height='3'/>").path ==
        read_any_path("M0 0H1").path);
  const std::string two = "<line id='a' x2='1'/><path id='b' inkscape:label='rail' d='M0 0V1'/>";
  CHECK(read(two, "b").name == "rail");
  CHECK(read(two, "rail").path == read_any_path("M0 0V1").path);
  CHECK(read(two, "a").path == read_any_path("M0 0H1").path);
  CHECK(refused(two).ends_with("there are 2 curves, and --pick names one: a, rail"));
}

TEST_CASE("SVG shapes: what cannot be read is refused where it is") {
  CHECK(refused("<rect width='5mm' height='3'/>") ==
        "1:54: width: a length without a unit, or in px, is wanted, not \"5mm\"");
  CHECK(refused("<circle r=''/>").ends_with("r: a number is expected"));
  CHECK(refused("<svg width='auto%' height='1'><line x2='1'/></svg>")
            .ends_with("percent of what has no size that is known"));
  CHECK(refused("<circle r='x'/>").ends_with("a number is expected, not \"x\""));
  CHECK(refused("<polygon points='0,0 1'/>").ends_with("a number is expected, not the end"));
  CHECK(refused("<rect/>").ends_with("the file draws no path and no shape"));
  CHECK(
      refused("<use href='#a'/>")
          .ends_with("the file draws no path and no shape; <use> refers to \"#a\", which is no id "
                     "of this file"));
  CHECK(
      refused("<g id='a'><use href='#a'/></g>").ends_with("<use> refers to itself, or too deeply"));
  // 2³⁰ lines.
  std::string doubled = "<defs><line id='u0' x2='1'/>";
  for (int k = 0; k < 30; ++k)
    doubled += fmt::format("<g id='u{}'><use href='#u{}'/><use href='#u{}'/></g>", k + 1, k, k);
  CHECK(contains(refused(doubled + "</defs><use href='#u30'/>"),
                 "<use> draws more than 200000 elements"));
}

// SVG 2, 5.5: what <use> draws is moved by x and y, within its transform.
TEST_CASE("SVG shapes: what <use> refers to is drawn where it says") {
  const std::string part = "<defs><path id='p' d='M0 0H1V1'/></defs>";
  CHECK(read(part + "<use href='#p' x='2' y='3'/>").path == read_any_path("M2 3H3V4").path);
  CHECK(read(part + "<use xlink:href='#p' transform='scale(2)' x='2' y='3'/>").path ==
        read_any_path("M4 6H6V8").path);
  CHECK(read(part + "<g id='g' transform='translate(0 5)'><use id='u' href='#p'/></g>").path ==
        read_any_path("M0 5H1V6").path);
  CHECK(read(part + "<use href='#lost'/><use href='#p'/>").path == read_any_path("M0 0H1V1").path);
  const std::string two = part + "<use id='a' href='#p'/><use id='b' href='#p' y='7'/>";
  CHECK(read(two, "b").path == read_any_path("M0 7H1V8").path);
  CHECK(refused(two).ends_with("--pick names one: a, b"));
  const std::string group = "<g id='g'><line id='l' x2='1'/><line id='m' y2='1'/></g>";
  CHECK(read(group + "<use id='c' href='#g' x='1'/>", "c/m").path == read_any_path("M1 0V1").path);
}

// SVG 2, 8.2: the view box is as large as fits, in the middle, unless something else is said.
TEST_CASE("SVG shapes: view boxes of symbols and of what is nested are applied") {
  const std::string line = "<line x1='10' y1='20' x2='20' y2='20'/>";
  const auto symbol = [&](const std::string& more) {
    return "<symbol id='s' viewBox='10 20 10 10'" + more + ">" + line + "</symbol>" +
           "<use href='#s' x='100' width='40' height='20'/>";
  };
  CHECK(read(symbol("")).path == read_any_path("M110 0H130").path);
  CHECK(read(symbol(" preserveAspectRatio='xMinYMax'")).path == read_any_path("M100 0H120").path);
  CHECK(read(symbol(" preserveAspectRatio='xMaxYMid'")).path == read_any_path("M120 0H140").path);
  CHECK(read(symbol(" preserveAspectRatio='none'")).path == read_any_path("M100 0H140").path);
  CHECK(read(symbol(" preserveAspectRatio='xMidYMid slice'")).path ==
        read_any_path("M100 -10H140").path);
  CHECK(
      read("<svg x='1' y='2' width='20' height='20' viewBox='0 0 10 10'>" + line + "</svg>").path ==
      read_any_path("M21 42H41").path);
  // The outer view box says what percentages are of, and is not applied itself.
  CHECK(
      read_any_path("<svg viewBox='0 0 50 100'><svg width='40%' height='20%' viewBox='0 0 10 10'>" +
                    line + "</svg></svg>")
          .path == read_any_path("M20 40H40").path);
  CHECK(contains(refused("<svg viewBox='0 0 10 10'>" + line + "</svg>"),
                 "the size of what a viewBox fills is not known"));
}

}  // namespace svg_shape_test
