#include "phrame/ph/curve/corner.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace corner_test {

Vector<double> unit(const Vector<double>& v) { return 1 / std::hypot(v[0], v[1], v[2]) * v; }

/// S turned about a × b, by Rodrigues' formula, in doubles.
Vector<double> turned_over_corner(const Vector<double>& a, const Vector<double>& b,
                                  const Vector<double>& S) {
  const Vector<double> axis = cross(unit(a), unit(b));
  const double sine = std::hypot(axis[0], axis[1], axis[2]);
  const double cosine = dot(unit(a), unit(b));
  const Vector<double> k = 1 / sine * axis;
  return cosine * S + sine * cross(k, S) + ((1 - cosine) * dot(k, S)) * k;
}

Vector<double> rounded(const Vector<Rational>& v) {
  return {round_to_double(v[0]), round_to_double(v[1]), round_to_double(v[2])};
}

}  // namespace corner_test

using namespace corner_test;

TEST_CASE("corner: a carried vector is the one that Rodrigues' formula turns") {
  test::Random random(20260);
  const auto vector = [&] {
    return Vector<Rational>{random.integer(-9, 9), random.integer(-9, 9), random.integer(1, 9)};
  };
  for (int k = 0; k < 200; ++k) {
    const Vector<Rational> a = vector(), b = vector(), S = cross(vector(), a),
                           T = cross(vector(), b);
    if (cross(a, b) == Vector<Rational>{} || S == Vector<Rational>{} || T == Vector<Rational>{})
      continue;
    CAPTURE(a);
    CAPTURE(b);
    const Vector<double> image = turned_over_corner(rounded(a), rounded(b), rounded(S));
    const Vector<double> e2 = unit(rounded(T));
    const double expected = std::atan2(dot(image, cross(unit(rounded(b)), e2)), dot(image, e2));
    const Real angle = carried_angle(as_reals(a), as_reals(S), as_reals(b), as_reals(T));
    CHECK(std::abs(std::remainder(round_to_double(angle) - expected, 2 * M_PI)) < 1e-13);
  }
}

// A quarter turn about z: by hand, with e₂ along v × a, carried, and v × b.
TEST_CASE("corner: the carried angle is algebraic where all vectors are rational") {
  const auto angle = [](const Vector<Rational>& v) {
    const Vector<Rational> a{1, 0, 0}, b{0, 1, 0};
    return over_pi(
        carried_angle(as_reals(a), as_reals(cross(v, a)), as_reals(b), as_reals(cross(v, b))));
  };
  CHECK(angle({0, 0, 1}) == Rational(0));
  CHECK(angle({1, 1, 0}) == Rational(1));      // between the two
  CHECK(angle({1, -1, 0}) == Rational(0));     // beside them
  CHECK(angle({1, 1, 1}) == Rational(-1, 2));  // (0, 1, −1) ↦ (−1, 0, −1), and (−1, 0, 1)
  CHECK_FALSE(angle({1, 2, 3}));
}

TEST_CASE("corner: the limit of no corner is no turn, however near they are") {
  const Vector<Rational> a{3, 4, 12}, v{0, 0, 1};
  CHECK(carried_angle(as_reals(a), as_reals(cross(v, a)), as_reals(a), as_reals(cross(v, a)))
            .exact() == Rational(0));
  const Rational tiny(1, pow(Integer(10), 40));
  const Vector<Rational> b = a + Vector<Rational>{tiny, 0, 0};
  const RealBall angle =
      carried_angle(as_reals(a), as_reals(cross(v, a)), as_reals(b), as_reals(cross(v, b)))
          .enclose(300);
  CHECK(is_at_most(absolute(angle), RealBall(tiny, 64)));
  CHECK_FALSE(angle.contains_zero());
}

TEST_CASE("corner: those of a path are the breaks of its tangent, and that of its closed ends") {
  const Path open = test::polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 2, 1}});
  CHECK(open.corners() == std::vector<std::size_t>{2, 3});
  const auto found = corners(open);
  REQUIRE(found.size() == 2);
  CHECK(found[0].segment == 2);
  CHECK(over_pi(found[0].angle) == Rational(1, 2));
  CHECK(std::abs(round_to_double(found[1].angle) - std::acos(1 / std::sqrt(3))) < 1e-15);
  const auto triangle = corners(test::polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}));
  REQUIRE(triangle.size() == 3);
  CHECK(triangle.back().segment == 0);
  CHECK(over_pi(triangle.back().angle) == Rational(1, 2));
  CHECK(over_pi(triangle.front().angle) == Rational(3, 4));
  CHECK(greatest(triangle).segment == 1);
}
