#include "phrame/ph/curve/nearest.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/curve/vector.hpp"
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

TEST_CASE("nearest point: of a line and of a circle by hand, and of formulas none") {
  const Path line = read_any_path("M0 0L4 0L4 4").path;
  const PathExtreme near = nearest_point(line, {1, 2, 2});
  CHECK(near.at.t.exact() == Rational(1, 4));
  CHECK(number(near) == std::sqrt(8.0));
  CHECK(nearest_point(line, {5, 3, 0}).at.segment == 1);
  CHECK(nearest_point(line, {9, -9, 0}).value.exact() == std::nullopt);  // √(25 + 81)
  const PathExtreme on_circle =
      nearest_point(read_any_path("<svg><circle r='5'/></svg>").path, {6, 8, 0});
  CHECK(number(on_circle) == doctest::Approx(5).epsilon(1e-15));
  const Path formulas = read_any_path(R"json({"phrame": "curve/1", "expressions":
      {"x": "cos(s)", "y": "sin(s)", "z": "exp(s)", "variable": "s", "from": 0, "to": 1}})json")
                            .path;
  CHECK_THROWS_AS(nearest_point(formulas, {0, 0, 0}), DomainError);
  CHECK_THROWS_AS(bounding_box(formulas), DomainError);
}

}  // namespace nearest_test
