#include "phrame/ph/construct/rmf_plane.hpp"

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/plane_quintics.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/energy.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RationalQuaternion small_quaternion(Random& random) {
  const auto c = [&] { return Rational(random.integer(-9, 9)); };
  return {10 + c(), c(), c(), c()};
}

Vector<Rational> reached(const ExactFit& fit) { return evaluate(position(curve_of(fit, {})), 1); }

Rational squared_off(const Vector<Rational>& a, const Vector<Rational>& b) {
  return dot(a - b, a - b);
}

}  // namespace

TEST_CASE("between parallel tangents: the ends are multiples of Q, the curve is plane, h = 0") {
  for_samples(40, [](Random& random) {
    const RationalQuaternion q = small_quaternion(random);
    const auto size = [&] { return Rational(random.integer(1, 20), 10); };
    const ParallelEnds ends{q, random.chance(6) ? Rational(0) : size(), size()};
    const Rational n = norm(q);
    const auto coordinate = [&] { return n * Rational(random.integer(-30, 30), 10); };
    const Vector<Rational> wanted{coordinate(), coordinate(), coordinate()};
    for (const long places : {40L, 120L}) {
      const ExactFit found = plane_between(ends, wanted, places);
      CHECK(found.preimage.front() == ends.at_start * q);
      CHECK((found.preimage.back() == ends.at_end * q ||
             found.preimage.back() == Rational(-ends.at_end) * q));
      CHECK(squared_off(reached(found), wanted) < n * n * power_of_two(16 - 2 * places));
      const Curve curve = curve_of(found, {});
      CHECK(twist_numerator(curve.preimage()).is_zero());
      CHECK(triple_product(curve).is_zero());
      for (const RationalQuaternion& a : found.preimage)
        CHECK(bit_length(denominator(norm(a))) < 4 * places + 40);
    }
  });
}

// Those of plane_quintics have been found by angles, the four of them.
TEST_CASE("between parallel tangents: of the plane quintics it is that of least energy") {
  for_samples(20, [](Random& random) {
    const Vector<Rational> step{Rational(random.integer(-20, 20), 10),
                                Rational(random.integer(1, 20), 10), 0};
    const Rational last(random.integer(1, 20), 10);
    const HermiteSpline data{{{0, 0, 0}, step}, {{1, 0, 0}, {last * last, 0, 0}}, {0, 1}};
    double least = HUGE_VAL;
    for (long k = 1; k <= plane_solutions; ++k) {
      const PhPath path =
          plane_quintics(data, k, {power_of_two(-40), power_of_two(-40)}, PointRule::near).path;
      least = std::min(least, test::energy_of(path.segments().front()));
    }
    const ExactFit found = plane_between({{1, 0, 0, 0}, 1, last}, step, 60);
    CHECK(test::energy_of(curve_of(found, {})) == doctest::Approx(least).epsilon(1e-6));
  });
}

TEST_CASE("on a line: f has the speeds at the ends and is positive, or there is none") {
  const RationalQuaternion q{1, 2, 3, 4};
  const Vector<Rational> along = rotated_i(q);
  const auto found = line_between({q, 1, 2}, Rational(3) * along, 20);
  REQUIRE(found);
  CHECK(found->preimage == std::vector<RationalQuaternion>{q});
  CHECK(found->multiplier == std::vector<Rational>{1, 4, 4});
  CHECK(reached(*found) == Rational(3) * along);
  // f₀f₂ = 4: the middle coefficient 3x − 5 is to be greater than −2.
  CHECK(line_between({q, 1, 2}, Rational(101, 100) * along, 20));
  CHECK_FALSE(line_between({q, 1, 2}, Rational(99, 100) * along, 20));
  CHECK_FALSE(line_between({q, 1, 2}, Rational(-1) * along, 20));
  // From rest to rest.
  const auto still = line_between({q, 0, 0}, along, 20);
  REQUIRE(still);
  CHECK(still->multiplier == std::vector<Rational>{0, 3, 0});
  CHECK_FALSE(line_between({q, 0, 1}, Rational(1, 4) * along, 20));
}
