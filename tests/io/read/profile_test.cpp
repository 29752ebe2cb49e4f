#include "phrame/io/read/profile.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/profile_curve.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

#include <doctest/doctest.h>

using namespace phrame;

namespace {

using Corners = std::vector<ProfilePoint>;

std::string complaint(const std::string& text, bool is_file) {
  return test::refusal_of([&] {
    if (is_file)
      read_profile(text);
    else
      parse_profile(text);
  });
}

std::string complaint_within(const std::string& text, const Rational& angle) {
  return test::refusal_of([&] { read_profile(text, {Rational(1, 10), angle}); });
}

}  // namespace

TEST_CASE("profile: words are read") {
  CHECK(parse_profile("rectangle:2, 1/2")->corners() ==
        rectangle_profile(2, Rational(1, 2)).corners());
  CHECK(parse_profile("polygon:5,3")->corners() == regular_polygon(5, 3).corners());
  CHECK(parse_profile("circle:2", {Rational(1, 50)})->corners() ==
        circle_profile(2, Rational(1, 50)).corners());
  CHECK(parse_profile("circle:2")->corners() == circle_profile(2, Rational(1, 500)).corners());
  CHECK_FALSE(parse_profile("outline.svg"));
  CHECK_FALSE(parse_profile("C:\\outline.svg"));
  CHECK(test::contains(complaint("circle:1,2", false), "a radius, not 2 numbers"));
  CHECK(test::contains(complaint("circle:x", false), "\"x\""));
  CHECK(test::contains(complaint("circle:-1", false), "not > 0"));
  CHECK(test::contains(complaint("polygon:2,1", false), "from 3 to 10000"));
  CHECK(test::contains(complaint("polygon:5/2,1", false), "from 3 to 10000"));
  CHECK(test::contains(complaint("rectangle:0,1", false), "not > 0"));
}

TEST_CASE("profile: a table of corners is read exactly") {
  CHECK(read_profile("x,y\n0,0\n0.1,0\n0,1/3\n").corners() ==
        Corners{{0, 0}, {Rational(1, 10), 0}, {0, Rational(1, 3)}});
  CHECK(read_profile("0 0\n1 0\n0 1\n").error() == 0);
  CHECK(test::contains(complaint("0,0\n1,0\n0,z\n", true), "line 3"));
  CHECK(test::contains(complaint("0,0,0\n1,0,0\n0,1,0\n", true), "columns"));
  CHECK(test::contains(complaint("0,0\n1,1\n1,0\n0,1\n", true), "meet"));
}

TEST_CASE("profile: the outline of an SVG path, y up, closed where it is not") {
  const Corners square = read_profile("M 0 0 H 2 V 2 H 0 Z").corners();
  CHECK(square.size() == 4);
  CHECK(read_profile("M 0 0 H 2 V 2 H 0").corners().size() == 4);
  for (const auto& [x, y] : square) CHECK((x >= 0 && y <= 0));
}

TEST_CASE("profile: an empty line begins another ring, a moveto or another path another subpath") {
  const Profile table = read_profile("x y\n\n0 0\n9 0\n9 9\n0 9\n\n\n1 1\n2 1\n2 2\n");
  CHECK(table.rings() == std::vector<std::size_t>{0, 4});
  CHECK(table.corners()[4] == ProfilePoint{2, 2});
  for (
      const std::string svg :
      {"M 0 0 H 9 V 9 H 0 Z M 1 1 H 2 V 2 Z", "M 1 1 H 2 V 2 M 0 0 H 9 V 9 H 0",
       "M 0 0 H 9 V 9 H 0 Z m 1 1 h 1 v 1 z", "M 1 1 H 2 V 2 z M 0 0 H 9 V 9 H 0 z",
       R"svg(<svg><path d="M 0 0 H 9 V 9 H 0 Z"/><g transform="translate(1 1)"><path d="M 0 0 H 1 V 1 Z"/></g></svg>)svg"}) {
    const Profile profile = read_profile(svg);
    CHECK(profile.rings() == std::vector<std::size_t>{0, 4});
    CHECK(profile.corners().size() == 7);
    CHECK(std::count(profile.corners().begin(), profile.corners().end(), ProfilePoint{2, -2}) == 1);
  }
  // What follows a closepath without a moveto begins where the subpath began.
  CHECK(test::contains(complaint("M 0 0 H 9 V 9 Z L -9 0 V -9 Z", true), "meet"));
  CHECK(test::contains(complaint("M 0 0 H 1 V 1 Z M 5 5 H 6 V 6 Z", true), "two bodies"));
  CHECK(test::contains(complaint("0 0\n9 0\n9 9\n\n5 1\n", true), "1 corners, at least 3"));
}

// Of the square a disc of radius 1 is left out, exactly; y is up.
TEST_CASE("profile: outlines with holes are read exactly") {
  for (const char* svg : {"M 0 0 H 9 V 9 H 0 Z M 3 2 A 1 1 0 0 0 1 2 A 1 1 0 0 0 3 2 Z",
                          "M 3 2 A 1 1 0 0 1 1 2 A 1 1 0 0 1 3 2 M 0 0 V 9 H 9 V 0"}) {
    const ProfileCurve curve = read_profile_curve(svg);
    CHECK(curve.rings() == std::vector<std::size_t>{0, 4});
    CHECK(round_to_double(curve.area()) == doctest::Approx(81 - M_PI).epsilon(1e-15));
    for (std::size_t k = 4; k < curve.pieces().size(); ++k) {
      const auto [x, y, weight] = polynomials(curve.pieces()[k]);
      const Polynomial dx = x - Polynomial{2} * weight;
      const Polynomial dy = y + Polynomial{2} * weight;
      CHECK(dx * dx + dy * dy == weight * weight);
    }
  }
  CHECK(read_profile_curve("0 0\n9 0\n9 9\n0 9\n\n1 1\n2 1\n2 2\n").area().exact() ==
        Rational(161, 2));
  CHECK_THROWS_WITH_AS(read_profile_curve("M 0 0 H 9 V 9 H 0 Z M 8 1 H 10 V 2 H 8 Z"),
                       doctest::Contains("the rings 1 and 2 meet"), InputError);
  // A circle with the radius 2 around (4, 1.99999) reaches beyond a side, between two of its
  // corners.
  CHECK_THROWS_WITH_AS(
      read_profile_curve("M 0 0 H 9 V 9 H 0 Z M 5.2 3.59999 A 2 2 0 0 0 2.8 0.39999 "
                         "A 2 2 0 0 0 5.2 3.59999"),
      doctest::Contains("outlines 1 and 2 meet"), Undecided);
}

// Half a circle of radius 1 in SVG's arc, and its diameter.
TEST_CASE("profile: curved parts are within the tolerance") {
  const Rational tolerance(1, 10'000);
  const Profile half = read_profile("M 1 0 A 1 1 0 0 1 -1 0 Z", {tolerance});
  CHECK(half.error() <= tolerance);
  CHECK(half.corners().size() > 100);
  CHECK(half.corners().size() < 2000);
  double area = 0;
  for (std::size_t k = 0; k < half.corners().size(); ++k) {
    const auto& a = half.corners()[k];
    const auto& b = half.corners()[(k + 1) % half.corners().size()];
    area += round_to_double(a[0] * b[1] - a[1] * b[0]) / 2;
    if (a[1] != 0)
      CHECK(std::abs(std::hypot(round_to_double(a[0]), round_to_double(a[1])) - 1) < 1e-12);
  }
  CHECK(std::abs(area - M_PI / 2) < 4e-4);
}

// A chord of a circle is parallel to the tangent in the middle of its arc: half of the angle of the
// arc from those at its ends.
TEST_CASE("profile: sides are at no more than the angle asked for to the curve") {
  for (const double angle : {0.3, 0.05}) {
    const Profile half =
        read_profile("M 1 0 A 1 1 0 0 1 -1 0 Z", {Rational(1), exact_rational(angle)});
    CHECK(round_to_double(half.angle()) <= angle);
    double greatest = 0;
    for (std::size_t k = 0; k < half.corners().size(); ++k) {
      const auto& a = half.corners()[k];
      const auto& b = half.corners()[half.next(k)];
      if (a[1] == 0 && b[1] == 0) continue;  // the diameter
      const double chord = std::hypot(round_to_double(b[0] - a[0]), round_to_double(b[1] - a[1]));
      greatest = std::max(greatest, std::asin(chord / 2));
    }
    CHECK(greatest <= round_to_double(half.angle()));
    CHECK(greatest > angle / 10);
  }
  CHECK(round_to_double(parse_profile("circle:3", {Rational(1), Rational(1, 10)})->angle()) < 0.1);
  CHECK(parse_profile("circle:3", {Rational(1), Rational(1, 10)})->corners().size() == 32);
  CHECK(read_profile("M 1 0 A 1 1 0 0 1 -1 0 Z").angle() > 3);
  CHECK(read_profile("0,0\n1,0\n0,1\n", {Rational(1), Rational(1, 10)}).angle() == 0);
  // It starts without a direction: r' = 0 there.
  CHECK(
      test::contains(complaint_within("M 0 0 C 0 0 1 2 2 0 Z", Rational(1, 10)), "10000 corners"));
  CHECK(read_profile("M 0 0 C 0 0 1 2 2 0 Z").corners().size() > 3);
}
