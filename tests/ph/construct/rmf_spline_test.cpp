#include "phrame/ph/construct/rmf_spline.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/rational_frame.hpp"
#include "support/energy.hpp"
#include "support/hermite.hpp"
#include "support/refusal.hpp"

namespace rmf_spline_test {

using namespace phrame;
using test::for_samples;
using test::one_segment;
using test::Random;
using test::random_spline;
using test::relative;

namespace {

Rational decimal(const char* text) { return parse_rational(text); }

Vector<Rational> derivative_at(const Curve& curve, const Rational& h, const Rational& t) {
  return 1 / h * evaluate(hodograph(curve), t);
}

long longest_number(const Curve& curve) {
  long bits = 0;
  for (const RationalQuaternion& a : to_bernstein(curve.preimage(), preimage_degree(curve)))
    for (const Rational* x : {&a.u, &a.v, &a.p, &a.q})
      bits = std::max({bits, bit_length(numerator(*x)), bit_length(denominator(*x))});
  return bits;
}

double energy_of(const Construction& found) {
  double sum = 0;
  for (const Curve& curve : found.path.segments()) sum += test::energy_of(curve);
  return sum;
}

/// What is claimed of it, recomputed by integrating its hodographs.
void check_claims(const HermiteSpline& data, const Construction& found, const Deviation& allowed) {
  const auto& segments = found.path.segments();
  REQUIRE(segments.size() == data.segments());
  CHECK(found.parameters == data.parameters);
  CHECK(found.deviation.points <= allowed.points);
  CHECK(found.deviation.derivatives <= allowed.derivatives);
  const auto check_near = [](const Vector<Rational>& a, const Vector<Rational>& b,
                             const Rational& bound) { CHECK(dot(a - b, a - b) <= bound * bound); };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    CAPTURE(k);
    CHECK(twist_numerator(segments[k].preimage()).is_zero());
    const Signs signs = multiplier_signs(segments[k]);
    CHECK(!signs.negative);
    const Rational h = data.parameters[k + 1] - data.parameters[k];
    const Vector<Rational> end = evaluate(position(segments[k]), 1);
    check_near(end, data.points[k + 1], found.deviation.points);
    check_near(derivative_at(segments[k], h, 0), data.derivatives[k], found.deviation.derivatives);
    check_near(derivative_at(segments[k], h, 1), data.derivatives[k + 1],
               found.deviation.derivatives);
    if (k + 1 == segments.size()) continue;
    CHECK(end == segments[k + 1].start());
    const Rational next = data.parameters[k + 2] - data.parameters[k + 1];
    CHECK(derivative_at(segments[k], h, 1) == derivative_at(segments[k + 1], next, 0));
  }
  if (!data.is_closed) return;
  CHECK(found.path.ends_meet());
  CHECK(found.path.closing_turn().has_value());
  const std::size_t n = segments.size();
  CHECK(derivative_at(segments.back(), data.parameters[n] - data.parameters[n - 1], 1) ==
        derivative_at(segments.front(), data.parameters[1] - data.parameters[0], 0));
}

void check(const HermiteSpline& data, const char* tolerance = "1e-15") {
  const Deviation allowed = relative(data, decimal(tolerance));
  check_claims(data, rmf_spline(data, allowed), allowed);
}

}  // namespace

TEST_CASE("RMF splines: h = 0, the joints are equal, the data are met, whatever the tolerance") {
  for (const char* tolerance : {"1e-6", "1e-15", "1e-40", "1e-60"}) {
    CAPTURE(tolerance);
    Random random(5);
    check(random_spline(random, 6), tolerance);
  }
}

TEST_CASE("RMF splines: the Euler-Rodrigues frame is rotation-minimizing through the joints") {
  Random random(8);
  const HermiteSpline data = random_spline(random, 4);
  const Construction found = rmf_spline(data, relative(data, decimal("1e-15")));
  for (const Curve& curve : found.path.segments()) {
    const auto frame = rational_frame(curve.preimage());
    REQUIRE(std::holds_alternative<RationalFrame>(frame));
    CHECK(std::get<RationalFrame>(frame).w == GaussianPolynomial{Polynomial{1}, {}});
  }
  for (const Rational& t : {Rational(1, 2), Rational(2), Rational(7, 2), Rational(4)})
    CHECK(round_to_double(PathAngle(found.path).value(t)) == 0);
}

TEST_CASE("RMF splines: the numbers of segment 300 are not longer than those of the first") {
  Random random(7);
  const HermiteSpline data = random_spline(random, 300);
  const Construction found = rmf_spline(data, relative(data, decimal("1e-15")));
  const auto& segments = found.path.segments();
  for (const std::size_t k : {0U, 1U, 150U, 299U}) {
    CHECK(longest_number(segments[k]) < 5 * found.bits + 40);
    for (const Rational& x : segments[k].start())
      CHECK(bit_length(denominator(x)) < 9 * found.bits + 120);
  }
}

TEST_CASE("RMF splines: plane data and parallel tangents, nearly and exactly") {
  for (const char* text : {"1e-1", "1e-3", "1e-6", "1e-9", "1e-12", "1e-15", "1e-18", "0"}) {
    CAPTURE(text);
    const Rational e = decimal(text);
    check(one_segment({1, decimal("0.1"), 7 * e / 10}, {1, Rational(1, 2), 0},
                      {1, -Rational(1, 2), e}));
    check(one_segment({1, decimal("0.3"), decimal("0.2")}, {1, 1, 1}, {1 + e, 1, 1 - e}));
    check(one_segment({1, 0, 0}, {1, 0, e}, {1, e, -e}));
  }
}

TEST_CASE("RMF splines: what is plane or straight and on an axis stays there") {
  const HermiteSpline plane{{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, -1, 0}, {2, -1, 0}},
                            {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {-2, 0, 0}},
                            {0, 1, 2, 3, 4}};
  check(plane);
  const Construction in_plane = rmf_spline(plane, relative(plane, decimal("1e-15")));
  for (const Curve& curve : in_plane.path.segments()) CHECK(hodograph(curve)[2].is_zero());
  const HermiteSpline line{{{0, 0, 0}, {3, 0, 0}, {4, 0, 0}, {9, 0, 0}},
                           {{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}},
                           {0, 2, 3, 7}};
  check(line);
  const Construction on_line = rmf_spline(line, relative(line, decimal("1e-15")));
  for (const Curve& curve : on_line.path.segments()) {
    CHECK(preimage_degree(curve) == 0);
    CHECK(hodograph(curve)[1].is_zero());
    CHECK(hodograph(curve)[2].is_zero());
  }
}

TEST_CASE("RMF splines: data of any size and at the edge are met") {
  for (const char* size : {"1e150", "1e-150", "1e400"}) {
    const Rational c = decimal(size);
    check(one_segment({c, c, c}, {c, 0, c / 3}, {-c, c / 7, 0}));
  }
  const Vector<Rational> step{1, decimal("0.1"), decimal("0.2")};
  check(one_segment(step, {1'000'000, 300'000, 0}, {200'000, -1'000'000, 100'000}));
  check(one_segment(step, {decimal("1e-9"), decimal("3e-9"), 0},
                    {decimal("2e-9"), decimal("-1e-9"), decimal("1e-9")}));
  check(one_segment({1, 0, 0}, {0, 1, 0}, {0, -1, 0}));                 // antiparallel
  check(one_segment({1, 0, 0}, {0, 1, 0}, {0, -1, decimal("1e-13")}));  // nearly so
  check(one_segment({1, 0, 0}, {1, 2, 3}, {-1, -2, -3}));
  check(one_segment({-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}));
  check(one_segment({-1, decimal("1e-12"), 0}, {-1, decimal("1e-15"), decimal("1e-16")},
                    {-1, 0, decimal("1e-14")}));
  check(one_segment({1, 1, 1}, {9, 9, 9}, {9, 9, 9}));   // too fast for a line
  check(one_segment({-1, 0, 0}, {1, 0, 0}, {1, 0, 0}));  // back
  check(one_segment({Rational(1, 4), 0, 0}, {1, 0, 0}, {1, 0, 0}));
  check(one_segment({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));  // loops
  check(one_segment({0, 0, 0}, {1, 2, 2}, {1, 2, 2}));
  check(one_segment({1, decimal("0.2"), 0}, {0, 0, 0}, {1, 0, decimal("0.3")}));  // from rest
  check(one_segment({1, decimal("0.2"), 0}, {1, 0, decimal("0.3")}, {0, 0, 0}));
  check(one_segment({1, decimal("0.2"), 0}, {0, 0, 0}, {0, 0, 0}));
  check({{{0, 0, 0}, {1, 1, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 2, 0}, {0, 0, 0}}, {0, 1, 2}});
}

TEST_CASE("RMF splines: a run of parallel tangents has one direction, and no longer numbers") {
  HermiteSpline data;
  for (long k = 0; k <= 40; ++k) {
    data.points.push_back({Rational(3 * k), Rational(k + k % 3), Rational(k % 2)});
    data.derivatives.push_back({3 + k % 4, 3 + k % 4, -(3 + k % 4)});
    data.parameters.emplace_back(k);
  }
  check(data);
  const Construction found = rmf_spline(data, relative(data, decimal("1e-15")));
  for (const Curve& curve : found.path.segments()) {
    CHECK(preimage_degree(curve) == 2);
    CHECK(longest_number(curve) < 4 * found.bits + 20);
    const auto same = cross(evaluate(hodograph(curve), 1), evaluate(hodograph(curve), 0));
    CHECK(same == Vector<Rational>{});
  }
}

TEST_CASE("RMF splines: what is no curve is refused, with its place") {
  const auto refusal = [](const HermiteSpline& data) -> std::string {
    return test::refusal_of<Error>([&] { rmf_spline(data, relative(data, decimal("1e-15"))); });
  };
  CHECK(
      refusal({{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {0, 1, 2}}) ==
      "the derivative at point 2 is 0: the tangent would break there");
  CHECK(refusal({{{1, 2, 3}, {1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}, {0, 1}}) ==
        "segment 1 is a point: its points are equal and its derivatives are 0");
  const Rational fast = decimal("1e8");
  CHECK(refusal(one_segment({1, decimal("0.1"), decimal("0.2")}, {fast, 0, 1}, {0, 1 / fast, 0})) ==
        "segment 1: no septic with h = 0 was found that has its points and derivatives");
}

namespace {

HermiteSpline closed(std::vector<Vector<Rational>> points,
                     std::vector<Vector<Rational>> derivatives = {}) {
  GivenPoints given;
  given.points = std::move(points);
  given.derivatives = std::move(derivatives);
  return hermite_spline(given, true);
}

}  // namespace

TEST_CASE("RMF splines: closed ones end at their start, with the derivative there, exactly") {
  // A trefoil through 12 points, to 6 decimals.
  std::vector<Vector<Rational>> points;
  std::vector<Vector<Rational>> derivatives;
  const auto rounded = [](double x) {
    return Rational(static_cast<long>(std::lround(x * 1e6)), 1'000'000);
  };
  for (long k = 0; k < 12; ++k) {
    const double speed = 2 * std::numbers::pi / 12;
    const double t = speed * static_cast<double>(k);
    points.push_back({rounded(std::sin(t) + 2 * std::sin(2 * t)),
                      rounded(std::cos(t) - 2 * std::cos(2 * t)), rounded(-std::sin(3 * t))});
    derivatives.push_back({rounded(speed * (std::cos(t) + 4 * std::cos(2 * t))),
                           rounded(speed * (-std::sin(t) + 4 * std::sin(2 * t))),
                           rounded(speed * -3 * std::cos(3 * t))});
  }
  const HermiteSpline trefoil = closed(points, derivatives);
  for (const char* tolerance : {"1e-15", "1e-40"}) check(trefoil, tolerance);
  // In Python: energy 7.848, and f differs from 1 by 2e-17 at most.
  const Construction found = rmf_spline(trefoil, relative(trefoil, decimal("1e-15")));
  CHECK(energy_of(found) == doctest::Approx(7.848).epsilon(1e-4));
  const Polynomial& f = found.path.segments().back().multiplier();
  CHECK(f.degree() == 4);
  for (const Rational& x : to_bernstein(f, 4)) CHECK(abs(x - 1) < decimal("1e-16"));
}

TEST_CASE("RMF splines: closed ones in a plane, and along parallels at the end") {
  check(closed({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -2, 0}}));
  // The planes are such that a curve with rational numbers is only nearly in them.
  check(closed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  check(closed({{1, 2, -3}, {0, 1, -1}, {-1, 1, 0}, {-2, 0, 2}, {0, -1, 1}}));
  // The last segment goes along parallels, a line or not.
  check(closed({{1, 0, 0}, {2, 0, 0}, {3, 1, 1}, {2, 2, 0}, {1, 2, 0}, {-1, 1, 1}, {0, 0, 0}},
               {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-2, 0, 0}, {0, -1, 0}, {1, 0, 0}}));
  check(closed({{1, 1, 0}, {2, 2, 0}, {3, 1, 1}, {-1, 2, 1}, {-2, -1, 1}, {0, 0, 1}},
               {{1, 1, 0}, {2, 2, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 1, 0}}));
  // A loop alone.
  check(closed({{0, 0, 0}, {0, 0, 0}}, {{1, 2, 3}, {1, 2, 3}}));
}

}  // namespace rmf_spline_test
