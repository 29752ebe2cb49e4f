// Kinds with a shape meet their points by a multiplier in each segment, which the shape does not
// see.
#include <array>
#include <functional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/cubic_spline.hpp"
#include "phrame/ph/construct/helical_spline.hpp"
#include "phrame/ph/construct/rmf_spline.hpp"
#include "phrame/ph/construct/rrmf_spline.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/hermite.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using test::one_segment;
using test::Random;
using test::random_spline;
using test::relative;

namespace {

struct Shaped {
  const char* name;
  Construction (*make)(const HermiteSpline& data, const Deviation& tolerance);
  bool (*has_shape)(const Curve& curve);
  bool is_c1;
  long degree;  ///< of a segment, at most
};

bool is_without_twist(const Curve& curve) { return twist_numerator(curve.preimage()).is_zero(); }

const std::array<Shaped, 4> kinds{
    {{"rmf",
      [](const HermiteSpline& data, const Deviation& tolerance) {
        return rmf_spline(data, tolerance, PointRule::exact);
      },
      is_without_twist, true, 11},
     {"helical",
      [](const HermiteSpline& data, const Deviation& tolerance) {
        return helical_spline(data, 1, tolerance, PointRule::exact);
      },
      [](const Curve& curve) { return is_helical(PhPath(curve)); }, true, 9},
     {"rrmf",
      [](const HermiteSpline& data, const Deviation& tolerance) {
        return rrmf_spline(data, tolerance, PointRule::exact);
      },
      [](const Curve& curve) { return is_rrmf_of_class_one(PhPath(curve)); }, false, 7},
     {"cubic",
      [](const HermiteSpline& data, const Deviation& tolerance) {
        return cubic_spline(data, 1, tolerance, PointRule::exact);
      },
      [](const Curve& curve) { return preimage_degree(curve) <= 1; }, false, 5}}};

/// Position, and the tangent or the derivative by the parameter, are the same.
void check_joint(const Curve& before, const Rational& h, const Curve& after, const Rational& next,
                 bool is_c1) {
  CHECK(evaluate(position(before), 1) == after.start());
  const Vector<Rational> d = 1 / h * evaluate(hodograph(before), 1);
  const Vector<Rational> e = 1 / next * evaluate(hodograph(after), 0);
  if (is_c1) {
    CHECK(d == e);
  } else {
    CHECK(cross(d, e) == Vector<Rational>{});
    CHECK(dot(d, e) > 0);
  }
}

void check_exact(const Shaped& kind, const HermiteSpline& data, const char* tolerance = "1e-15") {
  CAPTURE(kind.name);
  Deviation asked = relative(data, parse_rational(tolerance));
  if (!kind.is_c1) asked.derivatives = parse_rational(tolerance);
  const Construction found = kind.make(data, asked);
  const auto& curves = found.path.segments();
  REQUIRE(curves.size() == data.segments());
  CHECK(found.deviation.points == 0);
  CHECK(found.deviation.derivatives <= asked.derivatives);
  const std::size_t n = curves.size();
  for (std::size_t k = 0; k < n; ++k) {
    CAPTURE(k);
    CHECK(curves[k].start() == data.points[k]);
    CHECK(evaluate(position(curves[k]), 1) == data.points[k + 1]);
    CHECK(kind.has_shape(curves[k]));
    CHECK(degree(curves[k]) <= kind.degree);
    CHECK_FALSE(multiplier_signs(curves[k]).negative);
    if (k + 1 < n || data.is_closed)
      check_joint(curves[k], data.step(k), curves[(k + 1) % n], data.step((k + 1) % n), kind.is_c1);
  }
  if (data.is_closed) CHECK(found.path.closing_turn().has_value());
}

const Shaped& rmf = kinds[0];

/// A point of the twisted cubic (t, t², t³), with its derivative: of these there are all kinds.
HermiteSpline twisted_cubic(long points) {
  HermiteSpline data;
  for (long k = 0; k < points; ++k) {
    const Rational t = Rational(k, 7) + Rational(1, 2);
    data.points.push_back({t, t * t, t * t * t});
    data.derivatives.push_back({1, 2 * t, 3 * t * t});
    data.parameters.push_back(t);
  }
  return data;
}

}  // namespace

TEST_CASE("exact points: all kinds with a shape keep it, and what is continuous") {
  for (const Shaped& kind : kinds)
    for (const char* tolerance : {"1e-3", "1e-15", "1e-40"})
      check_exact(kind, twisted_cubic(4), tolerance);
}

TEST_CASE("exact points: random splines with h = 0, open and closed, and of helices") {
  test::for_samples(4, [](Random& random) {
    HermiteSpline data = random_spline(random, 4);
    check_exact(kinds[0], data);
    check_exact(kinds[1], data);
    data.points.back() = data.points.front();
    data.derivatives.back() = data.derivatives.front();
    data.is_closed = true;
    check_exact(rmf, data);
  });
}

// Segments in planes that are not rational are out of them by the rounding of tangents.
TEST_CASE("exact points: lines, planes and parallel tangents in any direction") {
  const HermiteSpline tilted = one_segment({1, 2, 3}, {0, 1, 1}, {1, 3, 4});
  check_exact(rmf, tilted);
  check_exact(kinds[1], tilted);
  check_exact(kinds[2], tilted);
  check_exact(rmf, one_segment({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));           // line
  check_exact(rmf, one_segment({1, 2, 3}, {1, 1, 1}, {2, 2, 2}), "1e-40");  // parallel
  check_exact(rmf, one_segment({3, 0, 0}, {1, 0, 0}, {2, 0, 0}));
  const HermiteSpline flat = one_segment({1, 2, 0}, {1, 0, 0}, {1, 1, 0});
  for (const std::size_t k : {0U, 1U, 2U}) check_exact(kinds[k], flat);
  // One line, one plane and one in space, with joints.
  check_exact(rmf, {{{0, 0, 0}, {1, 2, 3}, {2, 3, 4}, {3, 3, 3}},
                    {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {0, -1, 2}},
                    {0, 1, 2, 3}});
}

// Natural splines are plane in their first and last segment: here along z, and then to the side.
TEST_CASE("exact points: of points only, with their natural spline") {
  GivenPoints given;
  given.points = {{0, 0, 0},
                  {0, 0, Rational(3, 20)},
                  {Rational(1, 10), Rational(1, 20), Rational(1, 4)},
                  {Rational(3, 10), Rational(1, 5), Rational(1, 4)}};
  const HermiteSpline data = hermite_spline(given, false);
  for (const Shaped& kind : kinds) check_exact(kind, data);
}

TEST_CASE("exact points: where a multiplier leads nowhere, a line says so") {
  const HermiteSpline line = one_segment({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
  const auto refusal = [&](const Shaped& kind) -> std::string {
    return test::refusal_of<Undecided>(
        [&] { kind.make(line, relative(line, parse_rational("1e-15"))); });
  };
  CHECK(refusal(kinds[3]).starts_with("segment 1: no slight change of its speed leads to"));
  CHECK(refusal(kinds[1]).starts_with("segment 1: "));
  CHECK(refusal(kinds[2]).starts_with("segment 1: "));
}
