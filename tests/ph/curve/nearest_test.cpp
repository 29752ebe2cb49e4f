#include "phrame/ph/curve/nearest.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"

namespace nearest_test {

using namespace phrame;
using test::Random;

namespace {

double number(const PathExtreme& x) { return round_to_double(x.value); }

}  // namespace

// x = t³ − t is least at 1/√3, −2√3/9, and greatest, 0, at both ends; y = t(1 − t) is 1/4 at 1/2.
TEST_CASE("bounding box: extremes are at the roots of derivatives, exactly") {
  const Path path(RationalCurve({Polynomial{0, -1, 0, 1}, Polynomial{0, 1, -1}, Polynomial{3}}));
  const auto box = bounding_box(path);
  CHECK(number(box[0].least) == doctest::Approx(-2 * std::sqrt(3) / 9).epsilon(1e-15));
  CHECK(round_to_double(box[0].least.at.t) == doctest::Approx(1 / std::sqrt(3)).epsilon(1e-15));
  CHECK(box[0].greatest.value.exact() == Rational(0));
  CHECK(box[0].greatest.at.t.exact() == Rational(0));
  CHECK(box[1].greatest.value.exact() == Rational(1, 4));
  CHECK(box[1].least.value.exact() == Rational(0));
  CHECK(box[2].least.value.exact() == Rational(3));
  const auto circle = bounding_box(read_any_path("<svg><circle cx='1' cy='2' r='3'/></svg>").path);
  CHECK(circle[0].least.value.exact() == Rational(-2));
  CHECK(circle[0].greatest.value.exact() == Rational(4));
  CHECK(circle[1].least.value.exact() == Rational(-1));
  CHECK(circle[1].greatest.value.exact() == Rational(5));
}

TEST_CASE("nearest point: nearer than any of many points, and across the tangent or at an end") {
  Random random(11);
  for (int sample = 0; sample < 10; ++sample) {
    std::vector<Vector<Rational>> points;
    for (int k = 0; k < 4; ++k)
      points.push_back({random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)});
    if (points[0] == points[1] || points[2] == points[3] || points[1] == points[2]) continue;
    const bool is_rational = sample % 2 == 1;
    const RationalCurve curve =
        bezier_curve(points, is_rational ? std::vector<Rational>{1, 2, Rational(1, 2), 1}
                                         : std::vector<Rational>{});
    const Path path(curve);
    const Vector<Rational> p{random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)};
    const PathExtreme nearest = nearest_point(path, p);
    const double distance = number(nearest);
    for (long k = 0; k <= 200; ++k) {
      const Vector<Rational> way = point(curve, Rational(k, 200)) - p;
      CHECK(distance <= std::sqrt(round_to_double(dot(way, way))) * (1 + 1e-15));
    }
    const Vector<Real> r = position(path, nearest.at);
    const Vector<Real> H = direction(path, nearest.at);
    double along = 0;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double h = round_to_double(H[k]);
      along += (round_to_double(r[k]) - round_to_double(p[k])) * h;
      size += std::abs(h) * 20;
    }
    const bool is_at_end =
        nearest.at.t.exact() == Rational(0) || nearest.at.t.exact() == Rational(1);
    CHECK((is_at_end || std::abs(along) <= 1e-13 * size));
  }
}

TEST_CASE("nearest point: of a line and of a circle by hand") {
  const Path line = read_any_path("M0 0L4 0L4 4").path;
  const PathExtreme near = nearest_point(line, {1, 2, 2});
  CHECK(near.at.t.exact() == Rational(1, 4));
  CHECK(number(near) == std::sqrt(8.0));
  CHECK(nearest_point(line, {5, 3, 0}).at.segment == 1);
  CHECK(nearest_point(line, {9, -9, 0}).value.exact() == std::nullopt);  // √(25 + 81)
  const PathExtreme on_circle =
      nearest_point(read_any_path("<svg><circle r='5'/></svg>").path, {6, 8, 0});
  CHECK(number(on_circle) == doctest::Approx(5).epsilon(1e-15));
}

// |r − (0, 0, 4c)|² = 9 + 16(s − c)² along (3 cos s, 3 sin s, 4s).
TEST_CASE("nearest point: of formulas by hand") {
  const Path helix(test::expression_curve({"3*cos(s)", "3*sin(s)", "4*s"}, "0", "10"));
  for (const Rational& c : {Rational(1, 3), Rational(7), Rational(99, 10)}) {
    const PathExtreme near = nearest_point(helix, {0, 0, 4 * c});
    CHECK(round_to_decimal(near.at.t, 30).value == round_to_decimal(Real(c / 10), 30).value);
    CHECK(round_to_decimal(near.value, 30).value == "3.00000000000000000000000000000");
  }
  CHECK(nearest_point(helix, {0, 0, 44}).at.t.exact() == Rational(1));
  const auto box = bounding_box(helix);
  CHECK(number(box[0].least) == -3);
  CHECK(box[0].greatest.value.exact() == Rational(3));                                  // at s = 0
  CHECK(round_to_decimal(box[1].greatest.at.t, 20).value == "0.15707963267948966192");  // π/20
  CHECK(number(box[1].least) == -3);
  CHECK(box[2].least.value.exact() == Rational(0));
  CHECK(box[2].greatest.value.exact() == Rational(40));
  const Path path(test::expression_curve({"s", "cosh(s)", "0"}, "0", "1"));
  CHECK(nearest_point(path, {Rational(-1), 1, 0}).at.t.exact() == Rational(0));
  CHECK(round_to_double(nearest_point(path, {9, 0, 0}).value) ==
        doctest::Approx(std::hypot(8, std::cosh(1.0))).epsilon(1e-15));
  // Around the middle of a circle all points are as near.
  const Path circle(test::expression_curve({"cos(s)", "sin(s)", "0"}, "0", "1"));
  CHECK_THROWS_AS(nearest_point(circle, {0, 0, 1}), Undecided);
  CHECK(number(bounding_box(circle)[2].greatest) == 0);
}

// The distance along all of the path, by many points.
TEST_CASE("nearest point: of formulas nearer than any of many points") {
  const Path path(test::expression_curve({"s", "exp(s)*cos(9*s)", "sin(7*s)"}, "-1", "1"));
  Random random(12);
  for (int sample = 0; sample < 4; ++sample) {
    const Vector<Rational> p{random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2)};
    const PathExtreme nearest = nearest_point(path, p);
    const double found = number(nearest);
    double least = 1e9;
    for (int k = 0; k <= 2000; ++k) {
      const double s = -1 + k / 1000.0;
      least = std::min(least, std::hypot(s - round_to_double(p[0]),
                                         std::exp(s) * std::cos(9 * s) - round_to_double(p[1]),
                                         std::sin(7 * s) - round_to_double(p[2])));
    }
    CHECK(found <= least * (1 + 1e-14));
    CHECK(least - found < 1e-4);
  }
}

}  // namespace nearest_test
