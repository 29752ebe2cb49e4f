#include "phrame/ph/construct/rmf_difference.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/construct/exact_fit.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/random.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

using Triple = Vector<double>;

double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Triple plus(const Triple& a, double c, const Triple& b) {
  return {a[0] + c * b[0], a[1] + c * b[1], a[2] + c * b[2]};
}

struct Moving {
  Triple tangent;
  Triple normal;
};

/// The normal of u, rotated by the shortest rotation of its tangent to that of v, has this angle to
/// the normal of v.
double angle_between(const Moving& u, const Moving& v) {
  const Triple c = cross(u.tangent, v.tangent);
  Triple x = u.normal;
  const double cosine = dot(u.tangent, v.tangent);
  const Triple turned = cross(c, x);
  const double along = dot(c, x) / (1 + cosine);
  x = {x[0] * cosine + turned[0] + along * c[0], x[1] * cosine + turned[1] + along * c[1],
       x[2] * cosine + turned[2] + along * c[2]};
  return std::atan2(dot(cross(x, v.normal), v.tangent), dot(x, v.normal));
}

/// The exact rotation-minimizing frame, rounded to doubles.
Moving frame_of(const Curve& curve, const RmfAngle& angle, const Rational& t) {
  const Frame<Real> frame = rotation_minimizing_frame(curve, angle, t);
  return {round_to_double(frame.e1), round_to_double(frame.e2)};
}

double change(const Curve& a, const Curve& b, const Rational& t) {
  const RmfAngle of_a(a);
  const RmfAngle of_b(b);
  const double d = angle_between(frame_of(a, of_a, t), frame_of(b, of_b, t)) -
                   angle_between(frame_of(a, of_a, 0), frame_of(b, of_b, 0));
  return std::remainder(d, 2 * std::numbers::pi);
}

HodographPair pair(const Curve& given, const Curve& other) {
  const auto degree =
      static_cast<std::size_t>(std::max(phrame::degree(given), phrame::degree(other)));
  return {bezier_derivatives(control_points_in_degree(given, degree)),
          bezier_derivatives(control_points_in_degree(other, degree))};
}

/// A, and A with its coefficients moved by about `by`.
std::pair<Curve, Curve> near_pair(std::mt19937_64& engine, long m, double by) {
  std::normal_distribution<double> gauss;
  std::array<std::array<std::vector<Rational>, 4>, 2> lists;
  for (long k = 0; k <= m; ++k)
    for (std::size_t c = 0; c < 4; ++c) {
      const double x = gauss(engine);
      lists[0][c].push_back(exact_rational(x));
      lists[1][c].push_back(exact_rational(x + by * gauss(engine)));
    }
  const auto curve = [](const std::array<std::vector<Rational>, 4>& b) {
    return Curve(
        {from_bernstein(b[0]), from_bernstein(b[1]), from_bernstein(b[2]), from_bernstein(b[3])});
  };
  return {curve(lists[0]), curve(lists[1])};
}

/// The frame of r′ at t = 1 by double reflection in so many steps, of the order 4 [Wang, Jüttler,
/// Zheng, Liu 2008]; it starts with `normal`.
Moving by_double_reflection(const Vector<Polynomial>& r, Triple normal, long steps) {
  const auto value = [](const Vector<Polynomial>& v, const Rational& t) {
    Triple result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<double>(v[c](t));
    return result;
  };
  const Vector<Polynomial> derivative{differentiate(r[0]), differentiate(r[1]),
                                      differentiate(r[2])};
  const auto tangent = [&](const Rational& t) {
    const Triple d = value(derivative, t);
    return plus({}, 1 / std::sqrt(dot(d, d)), d);
  };
  Triple at = value(r, 0);
  Triple t0 = tangent(0);
  for (long k = 1; k <= steps; ++k) {
    const Rational t(k, steps);
    const Triple next = value(r, t);
    const Triple t1 = tangent(t);
    const Triple v1 = plus(next, -1, at);
    const double c1 = dot(v1, v1);
    const Triple reflected = plus(normal, -2 / c1 * dot(v1, normal), v1);
    const Triple t_reflected = plus(t0, -2 / c1 * dot(v1, t0), v1);
    const Triple v2 = plus(t1, -1, t_reflected);
    normal = plus(reflected, -2 / dot(v2, v2) * dot(v2, reflected), v2);
    at = next;
    t0 = t1;
  }
  return {t0, normal};
}

}  // namespace

TEST_CASE("rmf_difference_bound: no two exact frames differ by more") {
  // PHRAME_TEST_MULTIPLIER=9 makes them 540.
  std::mt19937_64 engine(3);
  long bounded = 0;
  double closest = 0;
  for (long k = 0; k < 60 * multiplier(); ++k) {
    CAPTURE(k);
    const double by = std::pow(10.0, -1 - static_cast<double>(k % 5));
    const auto [a, b] = near_pair(engine, 1 + k % 4, by);
    const auto bound = rmf_difference_bound({pair(a, b)});
    if (!bound) continue;
    ++bounded;
    for (const Rational& t : {Rational(1, 3), Rational(1)}) {
      const double measured = std::abs(change(a, b, t));
      // The frames are rounded to doubles.
      CHECK(measured <= static_cast<double>(*bound) + 1e-14);
      closest = std::max(closest, measured / static_cast<double>(*bound));
    }
  }
  CHECK(bounded > 45 * multiplier());
  CHECK(closest > 0.1);  // the bound is of the size of the truth
}

// Where a frame starts depends on the tangent there alone: with φ from the x axis to it, two that
// are δ apart have starts that differ by at most the area δ tan(φ/2) of a triangle on the sphere.
TEST_CASE(
    "rmf_difference_bound: from where they start by themselves, nor do frames of a PH curve "
    "and of its control points in doubles") {
  // PHRAME_TEST_MULTIPLIER=13 makes them 520.
  const auto frame_at = [](const PathAngle& angle, const Rational& t) {
    const StartAngle start = start_angle(LeastRotation(), angle);
    const Frame<Real> frame = rotation_minimizing_frame(angle, {0, t}, start);
    return Moving{round_to_double(frame.e1), round_to_double(frame.e2)};
  };
  std::mt19937_64 engine(7);
  long as_near_as_doubles = 0;
  for (long k = 0; k < 40 * multiplier(); ++k) {
    CAPTURE(k);
    const Curve curve = near_pair(engine, 1 + k % 3, 0).first;
    const BezierPoints exact =
        control_points_in_degree(curve, static_cast<std::size_t>(degree(curve)));
    BezierPoints rounded = exact;
    for (auto& point : rounded)
      for (Rational& x : point) x = exact_rational(round_to_double(x));
    const auto bound =
        rmf_difference_bound({{bezier_derivatives(rounded), bezier_derivatives(exact)}});
    REQUIRE(bound.has_value());
    const PathAngle of_curve{Path(curve)};
    const PathAngle of_points = angle_to(std::nullopt, Path(bezier_curve(rounded)));
    CHECK(of_points.reference() == Reference::up);
    const Triple e1 = frame_at(of_curve, 0).tangent;
    const Triple off = plus(frame_at(of_points, 0).tangent, -1, e1);
    const double start = std::sqrt(dot(off, off)) * std::tan(std::acos(e1[0]) / 2);
    const double most = static_cast<double>(*bound) + 1.01 * start + 1e-15;
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)})
      CHECK(std::abs(angle_between(frame_at(of_curve, t), frame_at(of_points, t))) <= most);
    if (most < 1e-13) ++as_near_as_doubles;
  }
  CHECK(as_near_as_doubles > 35 * multiplier());
}

TEST_CASE("rmf_difference_bound: nor do frames of curves that are not PH, by double reflection") {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> gauss;
  for (long k = 0; k < 5 * multiplier(); ++k) {
    CAPTURE(k);
    const Curve exact = near_pair(engine, 2, 0).first;
    auto points = control_points(exact);
    for (auto& p : points)
      for (Rational& x : p) x += exact_rational(1e-3 * gauss(engine));
    const auto bound = rmf_difference_bound(
        {{bezier_derivatives(points), bezier_derivatives(control_points(exact))}});
    if (!bound) continue;
    const Vector<Polynomial> derivative = bezier_hodograph(points);
    Vector<Polynomial> r;
    for (std::size_t c = 0; c < 3; ++c)
      r[c] = antiderivative(derivative[c]) + Polynomial{points[0][c]};
    Moving start;
    const Triple d = {static_cast<double>(derivative[0](0)), static_cast<double>(derivative[1](0)),
                      static_cast<double>(derivative[2](0))};
    start.tangent = plus({}, 1 / std::sqrt(dot(d, d)), d);
    const Triple axis = std::abs(d[0]) < std::abs(d[1]) ? Triple{1, 0, 0} : Triple{0, 1, 0};
    const Triple normal = cross(start.tangent, axis);
    start.normal = plus({}, 1 / std::sqrt(dot(normal, normal)), normal);
    const RmfAngle angle(exact);
    const Moving end = by_double_reflection(r, start.normal, 1000);
    const double measured =
        std::abs(std::remainder(angle_between(end, frame_of(exact, angle, 1)) -
                                    angle_between(start, frame_of(exact, angle, 0)),
                                2 * std::numbers::pi));
    CHECK(measured <= static_cast<double>(*bound) + 1e-9);
  }
}

TEST_CASE("rmf_difference_bound: the same curve and a straight line differ by nothing") {
  std::mt19937_64 engine(1);
  const Curve curve = near_pair(engine, 3, 0).first;
  CHECK(rmf_difference_bound({pair(curve, curve)}) == Rational(0));
  const Curve line({{1}, {2}, {3}, {4}}, {1, 1});
  const Curve other({{1}, {2}, {3}, {5}}, {1, 1});
  CHECK(*rmf_difference_bound({pair(line, other)}) < power_of_two(-50));
}

/// On [0, 1/2] or on [1/2, 1], again on [0, 1].
Curve half_of(const Curve& curve, const Rational& from) {
  const Polynomial t{from, Rational(1, 2)};
  const auto& [u, v, p, q] = curve.preimage();
  return Curve({compose(u, t), compose(v, t), compose(p, t), compose(q, t)});
}

/// The bounds of the whole and of its halves, one after the other, are about the same.
void check_halves(const Curve& a, const Curve& b) {
  const auto whole = rmf_difference_bound({pair(a, b)});
  const Rational middle(1, 2);
  const auto halves = rmf_difference_bound(
      {pair(half_of(a, 0), half_of(b, 0)), pair(half_of(a, middle), half_of(b, middle))});
  REQUIRE(whole);
  REQUIRE(halves);
  CHECK(*halves <= Rational(11, 10) * *whole);
  CHECK(*whole <= Rational(11, 10) * *halves);
}

TEST_CASE("rmf_difference_bound: a piece cut in two has about the bound of the whole") {
  std::mt19937_64 engine(2);
  const auto [a, b] = near_pair(engine, 2, 1e-6);
  check_halves(a, b);
}

// The means in doubles are off by more than the speed there.
TEST_CASE("rmf_difference_bound: where the speed falls by 2^80, the frames differ by no more") {
  std::mt19937_64 engine(2);
  const auto [a, b] = near_pair(engine, 2, 1e-6);
  const auto slowed = [](const Curve& curve) {
    const auto& [u, v, p, q] = curve.preimage();
    const auto part = [](const Polynomial& x) {
      auto coefficients = to_bernstein(x, 2);
      for (std::size_t k = 0; k < 3; ++k)
        coefficients[k] *= power_of_two(-20 * static_cast<long>(k));
      return from_bernstein(coefficients);
    };
    return Curve({part(u), part(v), part(p), part(q)});
  };
  const auto [c, d] = std::pair(slowed(a), slowed(b));
  check_halves(c, d);
  // c is a(s)·(a rational function of t)², s = s(t) from 0 to 1: the same tangents, so that the
  // truth is the same.
  const auto bound = rmf_difference_bound({pair(c, d)});
  REQUIRE(bound);
  CHECK(static_cast<double>(*bound) >= std::abs(change(a, b, 1)));
  CHECK(*bound <= 4 * *rmf_difference_bound({pair(a, b)}));
}

TEST_CASE("rmf_difference_bound: units do not matter, be they beyond the doubles") {
  std::mt19937_64 engine(4);
  const auto [a, b] = near_pair(engine, 3, 1e-3);
  const HodographPair whole = pair(a, b);
  for (const long e : {-2000L, 2000L}) {
    HodographPair scaled = whole;
    for (auto* hodograph : {&scaled.given, &scaled.other})
      for (auto& v : *hodograph)
        for (Rational& x : v) x *= power_of_two(e);
    CHECK(rmf_difference_bound({scaled}) == rmf_difference_bound({whole}));
  }
}

TEST_CASE("rmf_difference_bound: where the given tangent breaks at a joint, that counts") {
  // Two lines of the given curve at the angle 2δ, near one line.
  const Rational d(1, 1000);
  const HodographPair before{{{1, d, 0}}, {{1, 0, 0}}};
  const HodographPair after{{{1, -d, 0}}, {{1, 0, 0}}};
  const auto bound = rmf_difference_bound({before, after});
  REQUIRE(bound);
  CHECK(*bound >= Rational(999, 1000) * d * d);  // tan(δ/2)·2δ
  CHECK(*bound <= Rational(1001, 1000) * d * d);
}

TEST_CASE(
    "rmf_difference_bound: there is none where the speed is 0 or the curves differ too much") {
  const Curve cusp({{0, 1}, {0, 1}, {0, 2}, {1, 1}}, {Rational(-1, 2), 1});
  CHECK_FALSE(rmf_difference_bound({pair(cusp, cusp)}));
  const Curve a({{1}, {}, {}, {0, 1}});
  const Curve b({{1}, {}, {}, {2, 1}});
  CHECK_FALSE(rmf_difference_bound({pair(a, b)}));
}
