#include "phrame/ph/construct/quintic_spline.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "support/energy.hpp"
#include "support/hermite.hpp"
#include "support/refusal.hpp"

namespace quintic_spline_test {

using namespace phrame;
using test::for_samples;
using test::is_within;
using test::one_segment;
using test::Random;
using test::random_spline;
using test::relative;

namespace {

Rational number(const char* text) { return parse_rational(text); }

const HermiteSpline left = one_segment({1, 1, 1}, {number("-0.8"), number("0.3"), number("1.2")},
                                       {number("0.5"), number("-1.3"), -1});
const HermiteSpline right = one_segment({1, 1, 1}, {number("0.4"), number("-1.5"), number("-1.2")},
                                        {number("-1.2"), number("-0.6"), number("-1.2")});

Vector<Rational> derivative(const Curve& curve, const Rational& h, const Rational& t) {
  Vector<Rational> d = evaluate(hodograph(curve), t);
  for (Rational& x : d) x /= h;
  return d;
}

/// What is claimed of a spline, recomputed by integrating its hodographs.
void check_claims(const HermiteSpline& data, const Construction& found,
                  const Deviation& tolerance) {
  const auto& segments = found.path.segments();
  REQUIRE(segments.size() == data.segments());
  CHECK(found.deviation.points <= tolerance.points);
  CHECK(found.deviation.derivatives <= tolerance.derivatives);
  const auto check_near = [](const Vector<Rational>& a, const Vector<Rational>& b,
                             const Rational& bound) { CHECK(is_within(a - b, bound)); };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    CAPTURE(k);
    const Rational h = data.parameters[k + 1] - data.parameters[k];
    CHECK(segments[k].multiplier() == Polynomial{h});
    const Vector<Rational> end = evaluate(position(segments[k]), 1);
    check_near(end, data.points[k + 1], found.deviation.points);
    check_near(derivative(segments[k], h, 0), data.derivatives[k], found.deviation.derivatives);
    check_near(derivative(segments[k], h, 1), data.derivatives[k + 1], found.deviation.derivatives);
    if (k + 1 == segments.size()) continue;
    CHECK(end == segments[k + 1].start());
    const Rational next = data.parameters[k + 2] - data.parameters[k + 1];
    CHECK(derivative(segments[k], h, 1) == derivative(segments[k + 1], next, 0));
    // The Euler–Rodrigues frame runs on, too: A itself is the same.
    CHECK(evaluate(segments[k].preimage(), 1) == evaluate(segments[k + 1].preimage(), 0));
  }
}

/// The most bits of a numerator over 2^−bits.
long height(const Construction& found, std::size_t segment) {
  long height = 0;
  const QuaternionPolynomial& a = found.path.segments()[segment].preimage();
  for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q})
    for (const Rational& x : to_bernstein(*p, 2)) {
      const Rational whole = x * power_of_two(found.bits);
      CHECK(denominator(whole) == 1);
      height = std::max(height, bit_length(numerator(whole)));
    }
  return height;
}

double twist(const Construction& found) { return round_to_double(erf_twist(found.path).value); }

PhPath path_in_pieces(const PhPath& path) {
  PhPath result(path.segments().front());
  for (std::size_t k = 1; k < path.segments().size(); ++k) result.append(path.segments()[k]);
  return result;
}

}  // namespace

TEST_CASE("quintic splines: deviations are proved and below every tolerance, joints equal") {
  for_samples(4, [](Random& random) {
    const HermiteSpline data = random_spline(random, random.integer(1, 6));
    for (const char* tolerance : {"1e-6", "1e-15", "1e-40", "1e-60"}) {
      CAPTURE(tolerance);
      const Deviation allowed = relative(data, number(tolerance));
      const Construction found = quintic_spline(data, QuinticSelection::automatic, allowed);
      check_claims(data, found, allowed);
      CHECK(path_in_pieces(found.path) == found.path);
    }
  });
}

TEST_CASE(
    "quintic splines: exact curves have the lengths and twists that Python has, of Farouki's "
    "talk") {
  constexpr double quarter = std::numbers::pi / 4;
  constexpr double third = std::numbers::pi / 3;
  struct Row {
    const HermiteSpline& data;
    SolutionAngles angles;
    double length;
    double twist;
  };
  for (const Row& row :
       {Row{left, {0, 0, 0}, 2.31036187855954887, 0.86264582773312778},
        Row{left, {quarter, 0, -third}, 2.29863983414699782, -2.32259767078048439},
        Row{right, {0, 0, 0}, 2.31808574387981922, 1.11863142962766327},
        Row{right, {quarter, 0, -third}, 2.74879039181415918, 0.59358439226725983}}) {
    const Construction found =
        quintic_spline(row.data, row.angles, relative(row.data, number("1e-17")));
    CHECK(round_to_double(total_length(Path(found.path)).value) ==
          doctest::Approx(row.length).epsilon(1e-14));
    CHECK(twist(found) == doctest::Approx(row.twist).epsilon(1e-13));
  }
}

TEST_CASE("quintic splines: the same of the three examples of Farouki and Moon 2018") {
  constexpr double pi = std::numbers::pi;
  struct Row {
    HermiteSpline data;
    double length;
    double twist;
  };
  const auto n = [](const char* text) { return number(text); };
  for (const Row& row :
       {Row{one_segment({1, 1, 0}, {n("1.5"), n("1.5"), 0}, {0, n("1.5"), n("-3.5")}),
            1.8645623629551393766, -2.4068112680694012105},
        Row{one_segment({1, 1, 1}, {n("3.5"), n("-1.5"), n("-1.5")},
                        {n("3.5"), n("2.5"), n("-1.5")}),
            3.0014700638336966888, -1.2327549271149083884},
        Row{one_segment({1, 1, 1}, {2, -1, n("3.5")}, {2, 2, n("3.5")}), 2.0779519701831729561,
            -2.5078371571670342734}}) {
    const Construction found = quintic_spline(row.data, SolutionAngles{pi / 4, 0, -7 * pi / 20},
                                              relative(row.data, number("1e-17")));
    CHECK(round_to_double(total_length(Path(found.path)).value) ==
          doctest::Approx(row.length).epsilon(1e-14));
    CHECK(twist(found) == doctest::Approx(row.twist).epsilon(1e-13));
  }
}

TEST_CASE("quintic splines: the numbers of segment 1000 are not longer than those of the first") {
  Random random(7);
  const HermiteSpline data = random_spline(random, 1000);
  for (const char* tolerance : {"1e-15", "1e-40"}) {
    const Deviation allowed = relative(data, number(tolerance));
    const Construction found = quintic_spline(data, FreeAngles{}, allowed);
    CHECK(found.deviation.points <= allowed.points);
    CHECK(found.deviation.derivatives <= allowed.derivatives);
    for (const std::size_t k : {0U, 1U, 500U, 998U, 999U})
      CHECK(height(found, k) <= found.bits + 16);
    for (const std::size_t k : {1U, 999U})
      for (const Rational& x : found.path.segments()[k].start())
        CHECK(bit_length(denominator(x)) <= 2 * found.bits + 64);
  }
}

TEST_CASE("quintic splines: the free angles are met, so that they are no accident of rounding") {
  const FreeAngles angles{Angle(Rational(1, 3), 0), Angle(Rational(-1, 5))};
  const Construction found = quintic_spline(left, angles, relative(left, number("1e-30")));
  CHECK(found.angles.front() == angles);
  const QuaternionPolynomial& a = found.path.segments().front().preimage();
  const auto at = [](const Polynomial& p, std::size_t k) { return to_bernstein(p, 2)[k]; };
  std::array<RationalQuaternion, 3> b;
  for (std::size_t k = 0; k < 3; ++k) b[k] = {at(a.u, k), at(a.v, k), at(a.p, k), at(a.q, k)};
  // tan(π/3)² = 3, and the argument of H(A₀ + A₂, 3A₀ + 4A₁ + 3A₂) is −1/5.
  const auto h = hermitian_product(b[0], b[2]);
  CHECK(h.re > 0);
  CHECK(h.im > 0);
  CHECK(abs(h.im * h.im / (h.re * h.re) - 3) < number("1e-28"));
  const RationalQuaternion sum = b[0] + b[2];
  const auto w = hermitian_product(sum, Rational(3) * sum + Rational(4) * b[1]);
  const RealBall argument_of_w = argument(w.re, w.im, 128);
  CHECK(abs(argument_of_w.midpoint() + Rational(1, 5)) < number("1e-27"));
}

TEST_CASE("quintic splines: plane data in z = 0 stay there, straight ones straight") {
  HermiteSpline plane{{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, -1, 0}},
                      {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}},
                      {0, 1, 2, 3}};
  const Construction found =
      quintic_spline(plane, QuinticSelection::automatic, relative(plane, number("1e-15")));
  for (const Curve& curve : found.path.segments()) CHECK(hodograph(curve)[2] == Polynomial());
  const HermiteSpline line{
      {{0, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {{1, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {0, 2, 3}};
  const Construction straight =
      quintic_spline(line, QuinticSelection::automatic, relative(line, number("1e-15")));
  for (const Curve& curve : straight.path.segments()) {
    CHECK(hodograph(curve)[1] == Polynomial());
    CHECK(hodograph(curve)[2] == Polynomial());
  }
}

TEST_CASE("quintic splines: data of any size and at the edge are met") {
  const auto check = [](const HermiteSpline& data) {
    const Deviation allowed = relative(data, number("1e-15"));
    check_claims(data, quintic_spline(data, QuinticSelection::automatic, allowed), allowed);
  };
  for (const char* size : {"1e150", "1e-150", "1e400"}) {
    const Rational c = number(size);
    check(one_segment({c, c, c}, {c, 0, c / 3}, {-c, c / 7, 0}));
  }
  check(one_segment({1, number("0.1"), number("0.2")}, {1'000'000, 300'000, 0},
                    {200'000, -1'000'000, 100'000}));
  check(one_segment({1, number("0.1"), number("0.2")}, {number("1e-9"), number("3e-9"), 0},
                    {number("2e-9"), number("-1e-9"), number("1e-9")}));
  check(
      one_segment({1, number("0.1"), number("0.2")}, {100'000'000, 0, 1}, {0, number("1e-8"), 0}));
  check(one_segment({1, 0, 0}, {0, 1, 0}, {0, -1, 0}));                // antiparallel
  check(one_segment({1, 0, 0}, {0, 1, 0}, {0, -1, number("1e-13")}));  // nearly so
  check(one_segment({1, 0, 0}, {1, 2, 3}, {-1, -2, -3}));
  check(one_segment({-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}));
  check(one_segment({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));              // a loop
  check(one_segment({1, number("0.2"), 0}, {0, 0, 0}, {1, 0, 0}));  // a cusp at the end
  check(one_segment({1, number("0.2"), 0}, {0, 0, 0}, {0, 0, 0}));
}

TEST_CASE("quintic splines: a derivative far below the tolerance still has its direction") {
  const Rational tiny = number("1e-30");
  const HermiteSpline data{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                           {{1, 0, 0}, {tiny, 2 * tiny, -tiny}, {0, 1, 0}},
                           {0, 1, 2}};
  const Construction found =
      quintic_spline(data, QuinticSelection::automatic, relative(data, number("1e-6")));
  const Vector<Rational> d = derivative(found.path.segments().front(), 1, 1);
  const Rational length_squared = dot(d, d);
  const Rational along = d[0] + 2 * d[1] - d[2];
  CHECK(along > 0);
  CHECK(along * along > number("0.999999") * 6 * length_squared);
}

TEST_CASE("quintic splines: what is no curve is refused, with its place") {
  const Deviation allowed{number("1e-15"), number("1e-15")};
  const auto refusal = [&](const HermiteSpline& data) -> std::string {
    return test::refusal_of<DomainError>(
        [&] { quintic_spline(data, QuinticSelection::automatic, allowed); });
  };
  CHECK(
      refusal({{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {0, 1, 2}}) ==
      "the derivative at point 2 is 0: the tangent would break there");
  CHECK(refusal({{{1, 2, 3}, {1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}, {0, 1}}) ==
        "segment 1 is a point: its points are equal and its derivatives are 0");
}

TEST_CASE("quintic splines: closed ones end at their start, with the derivative there, exactly") {
  // A trefoil through 12 points, to 6 decimals.
  HermiteSpline data;
  const auto decimal = [](double x) {
    return Rational(static_cast<long>(std::lround(x * 1e6)), 1'000'000);
  };
  constexpr long count = 12;
  for (long k = 0; k <= count; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k % count) / count;
    const double speed = 2 * std::numbers::pi / count;
    data.points.push_back({decimal(std::sin(t) + 2 * std::sin(2 * t)),
                           decimal(std::cos(t) - 2 * std::cos(2 * t)), decimal(-std::sin(3 * t))});
    data.derivatives.push_back({decimal(speed * (std::cos(t) + 4 * std::cos(2 * t))),
                                decimal(speed * (-std::sin(t) + 4 * std::sin(2 * t))),
                                decimal(speed * -3 * std::cos(3 * t))});
    data.parameters.emplace_back(k);
  }
  data.is_closed = true;
  for (const char* tolerance : {"1e-15", "1e-30"}) {
    CAPTURE(tolerance);
    const Deviation allowed = relative(data, number(tolerance));
    const Construction found = quintic_spline(data, QuinticSelection::automatic, allowed);
    CHECK(found.deviation.points <= allowed.points);
    CHECK(found.path.segments().size() == count + 1);
    CHECK(found.parameters[count] == count - Rational(1, 2));
    CHECK(found.path.ends_meet());
    CHECK(found.path.closing_turn().has_value());
    const auto& segments = found.path.segments();
    CHECK(derivative(segments.back(), Rational(1, 2), 1) == derivative(segments.front(), 1, 0));
    for (std::size_t k = 0; k + 1 < segments.size(); ++k) {
      const Rational h = found.parameters[k + 1] - found.parameters[k];
      const Rational next = found.parameters[k + 2] - found.parameters[k + 1];
      CHECK(derivative(segments[k], h, 1) == derivative(segments[k + 1], next, 0));
      CHECK(evaluate(position(segments[k]), 1) == segments[k + 1].start());
    }
    // In Python: 7.841.
    double energy = 0;
    for (const Curve& curve : segments) energy += test::energy_of(curve);
    CHECK(energy == doctest::Approx(7.841).epsilon(1e-3));
  }
}

TEST_CASE("quintic spline: law: exact points are joints, and derivatives stay as near as without") {
  for_samples(12, [](Random& random) {
    const long count = random.integer(1, 6);
    HermiteSpline data = random_spline(random, count);
    if (random.chance(2)) {  // denominators that are no powers of 10
      for (auto& p : data.points)
        for (Rational& x : p) x += Rational(random.integer(-20, 20), random.chance(2) ? 231 : 13);
    }
    data.is_closed = count > 1 && random.chance(2);
    if (data.is_closed) {
      data.points.back() = data.points.front();
      data.derivatives.back() = data.derivatives.front();
    }
    const Deviation allowed = relative(data, number(random.chance(2) ? "1e-15" : "1e-30"));
    const Construction found =
        quintic_spline(data, QuinticSelection::automatic, allowed, PointRule::exact);
    CHECK(found.deviation.points == 0);
    CHECK(found.deviation.derivatives <= allowed.derivatives);
    const auto& segments = found.path.segments();
    REQUIRE(segments.size() == 2 * data.segments());
    REQUIRE(found.parameters.size() == segments.size() + 1);
    REQUIRE(found.angles.size() == segments.size());
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const Rational h = found.parameters[k + 1] - found.parameters[k];
      const Vector<Rational> end = evaluate(position(segments[k]), 1);
      if (k % 2 == 0) {
        CHECK(segments[k].start() == data.points[k / 2]);
        CHECK(found.parameters[k] == data.parameters[k / 2]);
        const Vector<Rational> off = derivative(segments[k], h, 0) - data.derivatives[k / 2];
        CHECK(is_within(off, allowed.derivatives));
      } else {
        CHECK(end == data.points[k / 2 + 1]);
      }
      if (k + 1 == segments.size()) continue;
      const Rational next = found.parameters[k + 2] - found.parameters[k + 1];
      CHECK(derivative(segments[k], h, 1) == derivative(segments[k + 1], next, 0));
    }
    if (data.is_closed) CHECK(found.path.closing_turn().has_value());
    // The numbers are longer than those of a spline that is near, but by a factor.
    for (const Curve& curve : segments)
      for (const RationalQuaternion& b : to_bernstein(curve.preimage(), 2))
        CHECK(bit_length(numerator(b.u)) < 10 * (found.bits + 20));
  });
}

// Along (1, 2, 3) no rational PH curve is straight (its speed would be a multiple of √14), so a
// line through such points is bent a little; along (1, 2, 2) it could be one.
TEST_CASE("quintic spline: points on straight lines are met exactly, too") {
  for (const Vector<Rational>& d :
       {Vector<Rational>{1, 2, 3}, Vector<Rational>{1, 2, 2}, Vector<Rational>{1, 0, 0},
        Vector<Rational>{-1, 0, 0}, Vector<Rational>{0, 0, Rational(1, 3)}}) {
    HermiteSpline data;
    for (long k = 0; k < 3; ++k) {
      data.points.push_back({k * d[0], k * d[1], k * d[2]});
      data.derivatives.push_back(d);
      data.parameters.emplace_back(k);
    }
    const Deviation allowed = relative(data, number("1e-15"));
    const Construction found =
        quintic_spline(data, QuinticSelection::automatic, allowed, PointRule::exact);
    const auto& segments = found.path.segments();
    double energy = 0;
    for (const Curve& curve : segments) energy += test::energy_of(curve);
    CHECK(energy < 1e-10);
    CHECK(evaluate(position(segments.back()), 1) == data.points.back());
  }
}

}  // namespace quintic_spline_test
