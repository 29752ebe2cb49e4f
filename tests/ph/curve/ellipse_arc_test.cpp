#include "phrame/ph/curve/ellipse_arc.hpp"

#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

PlaneVector value(const RationalBezier& arc, const Rational& t) {
  PlaneVector sum;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<Rational> coefficients;
    for (std::size_t k = 0; k < 3; ++k) coefficients.push_back(arc.weights[k] * arc.points[k][c]);
    sum[c] = from_bernstein(coefficients)(t) / from_bernstein(arc.weights)(t);
  }
  return sum;
}

PlaneVector plane(const Vector<Rational>& v) { return {v[0], v[1]}; }

Rational square(const Rational& x) { return x * x; }

/// A rational point of the unit circle.
PlaneVector random_direction(Random& random) {
  const Rational t = random.rational();
  const PlaneVector p{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
  return random.chance(2) ? p : PlaneVector{-p[0], p[1]};
}

/// Is each where the one before ends, with its tangent?
void check_joined(const std::vector<RationalBezier>& arcs) {
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    CHECK(arcs[k].points[0] == arcs[k - 1].points[2]);
    const auto& [x0, y0, z0] = arcs[k - 1].points[1];
    const auto& [x1, y1, z1] = arcs[k].points[0];
    const auto& [x2, y2, z2] = arcs[k].points[1];
    CHECK((x1 - x0) * (y2 - y1) == (y1 - y0) * (x2 - x1));
    CHECK((x1 - x0) * (x2 - x1) + (y1 - y0) * (y2 - y1) > 0);
  }
}

/// ∫ (x dy − y dx)/2 around the center of the unit circle, half the angle, by many chords.
double angle_of(const std::vector<RationalBezier>& arcs) {
  double sum = 0;
  for (const RationalBezier& arc : arcs)
    for (long k = 0; k < 16; ++k) {
      const PlaneVector p = value(arc, Rational(k, 16));
      const PlaneVector q = value(arc, Rational(k + 1, 16));
      sum += std::atan2(static_cast<double>(p[0] * q[1] - p[1] * q[0]),
                        static_cast<double>(p[0] * q[0] + p[1] * q[1]));
    }
  return sum;
}

const Ellipse unit_circle{{0, 0}, {1, 0}, {0, 1}};

}  // namespace

TEST_CASE("arcs of the unit circle are on it, and turn by the angle between their ends") {
  for_samples(30, [](Random& random) {
    const PlaneVector from = random_direction(random);
    const PlaneVector to = random.chance(4) ? from : random_direction(random);
    for (const bool is_growing : {true, false}) {
      const auto arcs = ellipse_arc(unit_circle, from, to, is_growing);
      CHECK(plane(arcs.front().points[0]) == from);
      CHECK(plane(arcs.back().points[2]) == to);
      check_joined(arcs);
      for (const RationalBezier& arc : arcs) {
        const PlaneVector p = value(arc, Rational(2, 7));
        CHECK(square(p[0]) + square(p[1]) == 1);
      }
      double wanted = std::atan2(static_cast<double>(to[1]), static_cast<double>(to[0])) -
                      std::atan2(static_cast<double>(from[1]), static_cast<double>(from[0]));
      const double full = 2 * std::acos(-1.0);
      if (is_growing && wanted <= 0) wanted += full;
      if (!is_growing && wanted >= 0) wanted -= full;
      CHECK(angle_of(arcs) == doctest::Approx(wanted).epsilon(1e-9));
    }
  });
}

TEST_CASE("arcs between points keep these, are on an ellipse of the wanted axes, and on its side") {
  for_samples(40, [](Random& random) {
    EndpointArc arc{{random.rational(), random.rational()},
                    {random.rational(), random.rational()},
                    {abs(random.rational()) + Rational(1, 3), abs(random.rational()) + 1},
                    random_direction(random),
                    random.chance(2),
                    random.chance(2)};
    if (arc.from == arc.to) return;
    if (random.chance(4)) arc.semiaxes[0] = -arc.semiaxes[0];
    const auto arcs = ellipse_arc(arc);
    CHECK(plane(arcs.front().points[0]) == arc.from);
    CHECK(plane(arcs.back().points[2]) == arc.to);
    check_joined(arcs);
    // The coordinates along the axes, in units of them, of chord and center.
    const auto on_axes = [&](const PlaneVector& v) {
      const auto& [c, s] = arc.axis;
      return PlaneVector{(c * v[0] + s * v[1]) / arc.semiaxes[0],
                         (c * v[1] - s * v[0]) / arc.semiaxes[1]};
    };
    const auto circle = [&](const PlaneVector& v) {  // with the right semiaxes a unit circle
      return on_axes({v[0] - arc.from[0], v[1] - arc.from[1]});
    };
    const PlaneVector p = circle(value(arcs.front(), Rational(1, 3)));
    const PlaneVector q = circle(value(arcs.back(), Rational(1, 2)));
    const PlaneVector r = circle(arc.to);
    // Center (u, v) of the circle through the origin and q, p: 2p·c = p².
    const PlaneVector& s = arcs.size() == 1 || q == PlaneVector{} ? r : q;
    const Rational determinant = 2 * (p[0] * s[1] - p[1] * s[0]);
    REQUIRE(determinant != 0);
    const Rational pp = square(p[0]) + square(p[1]);
    const Rational ss = square(s[0]) + square(s[1]);
    const PlaneVector c{(pp * s[1] - ss * p[1]) / determinant,
                        (ss * p[0] - pp * s[0]) / determinant};
    const Rational radius = square(c[0]) + square(c[1]);
    const Rational chord = (square(r[0]) + square(r[1])) / 4;
    const Rational tolerance = power_of_two(-90);
    CHECK(abs(radius - std::max(chord, Rational(1))) <= tolerance * radius);
    CHECK(square(r[0] - c[0]) + square(r[1] - c[1]) == radius);
    double turn = 0;  // about the center, on the axes
    for (const RationalBezier& piece : arcs)
      for (long k = 0; k < 8; ++k) {
        const PlaneVector x = circle(value(piece, Rational(k, 8)));
        const PlaneVector y = circle(value(piece, Rational(k + 1, 8)));
        const PlaneVector u{x[0] - c[0], x[1] - c[1]};
        const PlaneVector v{y[0] - c[0], y[1] - c[1]};
        turn += std::atan2(static_cast<double>(Rational((u[0] * v[1] - u[1] * v[0]) / radius)),
                           static_cast<double>(Rational((u[0] * v[0] + u[1] * v[1]) / radius)));
      }
    const bool grows = (turn > 0) == (arc.semiaxes[0] > 0);
    CHECK(grows == arc.is_growing);
    if (chord < 1) CHECK((std::abs(turn) > std::acos(-1.0)) == arc.is_large);
  });
}

TEST_CASE("where the center is rational, nothing is rounded") {
  // A quarter, as in a rectangle with round corners, and half a circle; by the tangents at the
  // ends.
  const auto quarter = ellipse_arc({{0, 1}, {1, 0}, {1, 1}, {1, 0}, false, true});
  REQUIRE(quarter.size() == 1);
  CHECK(quarter[0].points == std::vector<Vector<Rational>>{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}});
  CHECK(quarter[0].weights == std::vector<Rational>{1, Rational(1, 2), Rational(1, 2)});
  const auto half = ellipse_arc({{0, 0}, {2, 0}, {1, 3}, {1, 0}, false, false});
  REQUIRE(half.size() == 2);
  CHECK(half[0].points == std::vector<Vector<Rational>>{{0, 0, 0}, {0, 3, 0}, {1, 3, 0}});
  // Semiaxes that are too small grow: SVG 2, 9.5.1.
  CHECK(ellipse_arc({{0, 0}, {2, 0}, {Rational(1, 3), 1}, {1, 0}, false, false}) == half);
}

TEST_CASE("rotations are on the circle, near their angle, and right angles are exact") {
  CHECK(rotation_by_degrees(90) == PlaneVector{0, 1});
  CHECK(rotation_by_degrees(-180) == PlaneVector{-1, 0});
  CHECK(rotation_by_degrees(630) == PlaneVector{0, -1});
  CHECK(rotation_by_radians(exact_rational(std::acos(-1.0))) == PlaneVector{-1, 0});
  CHECK(rotation_by_radians(exact_rational(-1.5 * std::acos(-1.0))) == PlaneVector{0, 1});
  CHECK(rotation_by_radians(0) == PlaneVector{1, 0});
  CHECK(rotation_by_radians(power_of_two(-60))[1] > 0);
  for_samples(20, [](Random& random) {
    const Rational degrees = random.integer(-1000, 1000) + Rational(1, 3);
    const double angle = static_cast<double>(degrees) * std::acos(-1.0) / 180;
    for (const PlaneVector& p :
         {rotation_by_degrees(degrees), rotation_by_radians(exact_rational(angle))}) {
      CHECK(square(p[0]) + square(p[1]) == 1);
      CHECK(static_cast<double>(p[0]) == doctest::Approx(std::cos(angle)).epsilon(1e-12));
      CHECK(static_cast<double>(p[1]) == doctest::Approx(std::sin(angle)).epsilon(1e-12));
    }
  });
}
