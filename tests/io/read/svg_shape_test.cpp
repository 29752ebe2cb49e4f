#include "phrame/io/read/svg_shape.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "io/reference.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace svg_shape_test {

using namespace phrame;
using std::numbers::pi;
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
  CHECK(refused("<circle r='x'/>").ends_with("a number is expected, not \"x\""));
  CHECK(refused("<polygon points='0,0 1'/>").ends_with("a number is expected, not the end"));
  CHECK(refused("<rect/>").ends_with("the file draws no path and no shape"));
  CHECK(refused("<use href='#a'/>")
            .ends_with("the file draws no path and no shape; what <use> draws is not followed: "
                       "unlink the clones"));
}

}  // namespace svg_shape_test
