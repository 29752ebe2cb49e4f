#include "phrame/ph/curve/rotation.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

namespace rotation_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

using Columns = std::array<Vector<Rational>, 3>;

Columns axes_of(const RationalQuaternion& p) {
  const Rational scale = 1 / norm(p);
  return {scale * rotated_i(p), scale * rotated_j(p), scale * rotated_k(p)};
}

RationalQuaternion random_quaternion(Random& random) {
  for (;;) {
    const RationalQuaternion p{random.rational(), random.rational(), random.rational(),
                               random.rational()};
    if (norm(p) != 0) return p;
  }
}

Rational distance(const Columns& a, const Columns& b) {
  Rational square;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Rational> off = a[k] - b[k];
    square = std::max(square, dot(off, off));
  }
  return square;
}

/// tr(MᵀR), which of all rotations R the nearest one has greatest.
Rational agreement(const Columns& m, const Columns& r) {
  return dot(m[0], r[0]) + dot(m[1], r[1]) + dot(m[2], r[2]);
}

}  // namespace

TEST_CASE("rotation: columns that are orthonormal are met exactly") {
  for_samples(200, [](Random& random) {
    const Columns m = axes_of(random_quaternion(random));
    const auto found = nearest_rotation(m);
    REQUIRE(found);
    CHECK(found->off == 0);
    CHECK(axes_of(found->rotation) == m);
  });
}

TEST_CASE("rotation: of rounded columns no rotation next to the one found is nearer") {
  for_samples(40, [](Random& random) {
    const Columns exact = axes_of(random_quaternion(random));
    const long bits = random.integer(8, 60);
    Columns m = exact;
    for (auto& column : m)
      for (Rational& x : column) x = rounded_to_places(x, bits);
    const auto found = nearest_rotation(m);
    REQUIRE(found);
    const Columns r = axes_of(found->rotation);
    CHECK(distance(r, m) <= found->off * found->off);
    // What it is off is what rounding did: half a unit in each of three coordinates.
    CHECK(found->off <= power_of_two(1 - bits));
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const long sign : {-1, 1}) {
        RationalQuaternion turn{1, 0, 0, 0};
        (axis == 0 ? turn.v : axis == 1 ? turn.p : turn.q) = sign * power_of_two(-50);
        CHECK(agreement(m, axes_of(found->rotation * turn)) < agreement(m, r) + power_of_two(-104));
      }
  });
}

TEST_CASE("rotation: what is no rotation to within a hundredth has none") {
  const Columns unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  CHECK(nearest_rotation(unit));
  CHECK_FALSE(nearest_rotation({unit[0], unit[1], Rational(-1) * unit[2]}));
  CHECK_FALSE(nearest_rotation({unit[0], unit[0], unit[2]}));
  CHECK_FALSE(nearest_rotation({Rational(101, 100) * unit[0], unit[1], unit[2]}));
  CHECK(nearest_rotation({Rational(1004, 1000) * unit[0], unit[1], unit[2]}));
}

TEST_CASE("rotation: the frame of a body has the tangent axis, and the next two behind it") {
  Random random(3703);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool is_reversed : {false, true}) {
      CAPTURE(axis);
      CAPTURE(is_reversed);
      const RationalQuaternion body = random_quaternion(random);
      const Columns axes = axes_of(body);
      const Quaternion<Integer> frame = frame_rotation(body, {axis, is_reversed});
      const Columns found = axes_of(each(frame, [](const Integer& x) { return Rational(x); }));
      Columns wanted{axes[axis], axes[(axis + 1) % 3], axes[(axis + 2) % 3]};
      if (is_reversed) wanted = {Rational(-1) * wanted[0], wanted[2], wanted[1]};
      CHECK(found == wanted);
      CHECK(gcd(gcd(frame.u, frame.v), gcd(frame.p, frame.q)) == 1);
    }
  CHECK(name_of({2, true}) == "-z");
  CHECK(name_of({}) == "x");
}

// About its axis a rotation turns nothing of it, and 1 + 2 cos α is its trace.
TEST_CASE("rotation: about an axis by an angle, exactly by right angles") {
  CHECK(axes_of(rotation_about({0, 0, 5}, Angle(Rational(1, 2), 0))) ==
        Columns{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});
  CHECK(axes_of(rotation_about({1, 2, 2}, Angle(-1, 0)))[0] ==
        Vector<Rational>{Rational(-7, 9), Rational(4, 9), Rational(4, 9)});
  CHECK(axes_of(rotation_about({1, 1, 1}, Angle(Rational(-2, 3), 0))) ==
        Columns{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}});
  CHECK(axes_of(rotation_about({3, 1, 1}, Angle())) == Columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  for (const Angle& angle :
       {Angle(1), Angle(Rational(1, 3), Rational(1, 7)), Angle(-20), Angle(Rational(3, 2), 0)}) {
    const auto [x, y, z] = axes_of(rotation_about({1, -1, 3}, angle));
    const Vector<Rational> axis = x - y + Rational(3) * z;
    CHECK(axis == Vector<Rational>{1, -1, 3});
    const double alpha = round_to_double(to_real(angle));
    CHECK(round_to_double(x[0] + y[1] + z[2]) == doctest::Approx(1 + 2 * std::cos(alpha)));
    // By the right hand: for small α > 0 the x axis turns towards z × x = y about z.
    const Vector<Rational> turned = cross(x, Vector<Rational>{1, 0, 0});
    CHECK(round_to_double(Rational(dot(turned, axis))) * std::sin(alpha) < 0);
  }
  CHECK_THROWS_AS(rotation_about({0, 0, 0}, Angle(1)), DomainError);
}

}  // namespace rotation_test
