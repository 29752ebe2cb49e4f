#include "phrame/ph/construct/c2_hermite.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/construct/c2_spline.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "support/hermite.hpp"

using namespace phrame;
using test::is_within;
using test::Motion;
using test::motion;
using test::Random;
using test::relative;

namespace {

Rational number(const char* text) { return parse_rational(text); }

HermiteSpline hermite_data(Random& random, long segments, bool is_plane = false) {
  const auto decimal = [&] { return Rational(random.integer(-1'000'000, 1'000'000), 1'000'000); };
  const auto last = [&] { return is_plane ? Rational(0) : decimal(); };
  HermiteSpline data;
  for (long k = 0; k <= segments; ++k) {
    data.points.push_back({decimal() + k, decimal(), last()});
    data.derivatives.push_back({1 + decimal() / 2, decimal(), last()});
    data.accelerations.push_back({decimal(), decimal(), last()});
    data.parameters.push_back(
        k == 0 ? Rational(0) : data.parameters.back() + Rational(random.integer(50, 150), 100));
  }
  return data;
}

void check_claims(const HermiteSpline& data, const Construction& found,
                  const Deviation& tolerance) {
  CHECK(found.deviation.points <= tolerance.points);
  CHECK(found.deviation.derivatives <= tolerance.derivatives);
  CHECK(found.deviation.accelerations <= tolerance.accelerations);
  const auto& segments = found.path.segments();
  REQUIRE(found.parameters.size() == segments.size() + 1);
  std::vector<Motion> states;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Rational h = found.parameters[k + 1] - found.parameters[k];
    CHECK(degree(segments[k]) <= 9);
    const Motion start = motion(segments[k], h, 0);
    if (k > 0) CHECK(start == states.back());
    if (k == 0) states.push_back(start);
    states.push_back(motion(segments[k], h, 1));
  }
  if (data.is_closed) CHECK(states.front() == states.back());
  std::size_t point = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (found.parameters[k] != data.parameters[point]) continue;
    CHECK(is_within(states[k].r - data.points[point], found.deviation.points));
    CHECK(is_within(states[k].d - data.derivatives[point], found.deviation.derivatives));
    CHECK(is_within(states[k].dd - data.accelerations[point], found.deviation.accelerations));
    ++point;
  }
  CHECK(point == data.points.size());
}

Construction c2_hermite(const HermiteSpline& data) {
  return c2_hermite_spline(data, relative(data, power_of_ten(-15)));
}

}  // namespace

TEST_CASE("c2_hermite_spline: joints are C2 exactly; deviations are what is said") {
  Random random(1);
  for (const long digits : {6, 15, 40, 60})
    for (const long segments : {1, 2, 12}) {
      CAPTURE(digits);
      CAPTURE(segments);
      const HermiteSpline data = hermite_data(random, segments);
      const Deviation tolerance = relative(data, power_of_ten(-digits));
      const Construction found = c2_hermite_spline(data, tolerance);
      CHECK(found.path.segments().size() == static_cast<std::size_t>(segments));
      check_claims(data, found, tolerance);
      CHECK(is_c2(found.path, data.is_closed));
    }
}

TEST_CASE("c2_hermite_spline: the curve that Python makes") {
  // reference/construct/t_more.py, c2_hermite() with D = 0.
  HermiteSpline data;
  data.points = {{0, 0, 0}, {1, 1, 1}};
  data.derivatives = {{number("-0.8"), number("0.3"), number("1.2")},
                      {number("0.5"), number("-1.3"), -1}};
  data.accelerations = {{1, -2, number("0.5")}, {number("-0.5"), number("0.25"), 2}};
  data.parameters = {0, 1};
  const Construction found = c2_hermite(data);
  const Curve& curve = found.path.segments().front();
  CHECK(static_cast<double>(arc_length(curve)(1)) ==
        doctest::Approx(2.3790026145017356).epsilon(1e-14));
  const Vector<Rational> middle = evaluate(position(curve), Rational(1, 2));
  CHECK(static_cast<double>(middle[0]) == doctest::Approx(0.3485511237608588).epsilon(1e-14));
  CHECK(static_cast<double>(middle[1]) == doctest::Approx(0.8273985977234873).epsilon(1e-14));
  CHECK(static_cast<double>(middle[2]) == doctest::Approx(0.7347012598855127).epsilon(1e-14));
}

TEST_CASE("c2_hermite_spline: a closed one ends where it starts, exactly, and is C2 there") {
  Random random(3);
  for (const bool is_plane : {false, true}) {
    HermiteSpline data = hermite_data(random, 4, is_plane);
    data.points.back() = data.points.front();
    data.derivatives.back() = data.derivatives.front();
    data.accelerations.back() = data.accelerations.front();
    data.is_closed = true;
    const Deviation tolerance = relative(data, power_of_ten(-15));
    const Construction found = c2_hermite_spline(data, tolerance);
    CHECK(found.path.ends_meet());
    CHECK(found.path.closing_turn());
    CHECK(is_c2(found.path, data.is_closed));
    check_claims(data, found, tolerance);
  }
}

TEST_CASE("c2_hermite_spline: points are met exactly where that is asked for, and C2 stays") {
  Random random(8);
  const HermiteSpline data = hermite_data(random, 3);
  const Deviation tolerance = relative(data, power_of_ten(-15));
  const Construction found = c2_hermite_spline(data, tolerance, PointRule::exact);
  CHECK(found.path.segments().size() == 6);
  CHECK(found.deviation.points == 0);
  check_claims(data, found, tolerance);
  CHECK(is_c2(found.path, false));
}

TEST_CASE("c2_hermite_spline: plane data have a curve in their plane") {
  Random random(4);
  const Construction found = c2_hermite(hermite_data(random, 5, true));
  for (const Curve& curve : found.path.segments()) CHECK(rotated_i(curve.preimage())[2].is_zero());
}

TEST_CASE("c2_hermite_spline: the order is six") {
  const auto vector = [](double x, double y, double z) {
    return Vector<Rational>{exact_rational(x), exact_rational(y), exact_rational(z)};
  };
  double last = 0;
  for (const double h : {0.4, 0.2, 0.1}) {
    HermiteSpline data;
    data.parameters = {0, exact_rational(h)};
    for (const double t : {0.25, 0.25 + h}) {
      data.points.push_back(vector(std::cos(t), std::sin(2 * t) / 2, t * t / 3));
      data.derivatives.push_back(vector(-std::sin(t), std::cos(2 * t), 2 * t / 3));
      data.accelerations.push_back(vector(-std::cos(t), -2 * std::sin(2 * t), 2.0 / 3));
    }
    const Construction found = c2_hermite(data);
    const Vector<Polynomial> p = position(found.path.segments().front());
    double error = 0;
    for (long k = 1; k < 20; ++k) {
      const Vector<Rational> at = evaluate(p, Rational(k, 20));
      const double t = 0.25 + h * static_cast<double>(k) / 20;
      error = std::max(error, std::hypot(static_cast<double>(at[0]) - std::cos(t),
                                         static_cast<double>(at[1]) - std::sin(2 * t) / 2,
                                         static_cast<double>(at[2]) - t * t / 3));
    }
    if (last != 0) CHECK(last / error > 50);  // 64, and the oracle has 83
    last = error;
  }
}

TEST_CASE("c2_hermite_spline: numbers do not grow along a spline") {
  Random random(5);
  const Rational tolerance = power_of_ten(-15);
  const Construction found =
      c2_hermite_spline(hermite_data(random, 300), {tolerance, tolerance, tolerance});
  const Rational grid = power_of_two(found.bits);
  CHECK(found.deviation.points * grid < 2);  // of one rounding: each segment aims at its end anew
  long height_of_starts = 0;
  for (const Curve& curve : found.path.segments()) {
    for (const RationalQuaternion& a : to_bernstein(curve.preimage(), 4))
      for (const Rational& x : {a.u, a.v, a.p, a.q}) {
        CHECK(denominator(Rational(x * grid)) == 1);
        CHECK(abs(x) < 100);
      }
    for (const Rational& x : curve.start())
      height_of_starts = std::max(height_of_starts, bit_length(denominator(x)));
  }
  CHECK(found.bits < 80);
  CHECK(height_of_starts < 2 * found.bits + 60);
}

TEST_CASE("c2_hermite_spline: any size, antiparallel tangents, no way to go") {
  Random random(6);
  const HermiteSpline data = hermite_data(random, 3);
  for (const long exponent : {150, -150}) {
    const Rational scale = power_of_ten(exponent);
    HermiteSpline scaled = data;
    for (auto* list : {&scaled.points, &scaled.derivatives, &scaled.accelerations})
      for (auto& v : *list) v = scale * v;
    check_claims(scaled, c2_hermite(scaled), relative(scaled, power_of_ten(-15)));
    scaled = data;
    for (Rational& t : scaled.parameters) t *= scale;
    for (auto& v : scaled.derivatives) v = Rational(1 / scale) * v;
    for (auto& v : scaled.accelerations) v = Rational(1 / (scale * scale)) * v;
    check_claims(scaled, c2_hermite(scaled), relative(scaled, power_of_ten(-15)));
  }
  HermiteSpline odd;
  odd.points = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  odd.derivatives = {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
  odd.accelerations = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  odd.parameters = {0, Rational(1, 3), 1};
  const Construction found = c2_hermite(odd);
  check_claims(odd, found, relative(odd, power_of_ten(-15)));
  CHECK(found.deviation.accelerations == 0);
}

TEST_CASE("c2_hermite_spline: what it wants") {
  Random random(7);
  HermiteSpline data = hermite_data(random, 2);
  data.derivatives[1] = {};
  CHECK_THROWS_WITH_AS(c2_hermite(data),
                       "the derivative at point 2 is 0: no acceleration can be had there",
                       DomainError);
  data.accelerations.clear();
  CHECK_THROWS_WITH_AS(
      c2_hermite(data),
      "C2 Hermite data are points, derivatives and accelerations; the last are missing",
      DomainError);
}

// With the laws of check_claims, which recomputes all that is said.
TEST_CASE("c2_hermite_spline: data that are no more than allowed") {
  const Rational huge = power_of_ten(12);
  const Rational tiny = power_of_ten(-12);
  const Vector<Rational> a{1, 0, 0};
  const Vector<Rational> b{0, 1, 0};
  const Vector<Rational> c{0, 0, 1};
  const Vector<Rational> l{1, 2, 3};
  const Vector<Rational> none{};
  using Vectors = std::vector<Vector<Rational>>;
  const struct {
    const char* what;
    Vectors points;
    Vectors derivatives;
    Vectors accelerations;
  } cases[] = {
      {"parallel", {none, l, a}, {b, b, b}, {a, c, a}},
      {"opposite", {none, l, a}, {b, Rational(-1) * b, b}, {a, c, a}},
      {"opposite, along -i", {none, l, a}, {Rational(-1) * a, a, Rational(-1) * a}, {b, c, b}},
      {"nearly opposite", {none, l, a}, {b, tiny * a - b, b}, {a, c, a}},
      {"no way", {l, l, l}, {a, b, c}, {c, a, b}},
      {"no acceleration", {none, l, a}, {a, b, c}, {none, none, none}},
      {"straight", {none, l, Rational(2) * l}, {l, l, l}, {none, none, none}},
      {"straight, faster", {none, l, Rational(4) * l}, {l, l, l}, {l, none, Rational(-1) * l}},
      {"there and back", {none, a, none}, {a, a, a}, {none, none, none}},
      {"in a tilted plane", {none, a + b, b + c}, {a + b, b + c, b + c}, {b + c, a + b, a + b}},
      {"great and small speeds", {none, l, a}, {huge * a, tiny * b, c}, {c, a, b}},
      {"great accelerations", {none, l, a}, {a, b, c}, {huge * c, a, huge * b}},
      {"small accelerations", {none, l, a}, {a, b, c}, {tiny * c, tiny * a, tiny * b}},
      {"a long way", {none, huge * l, a}, {a, b, c}, {c, a, b}},
      {"a short way", {none, tiny * l, a}, {a, b, c}, {c, a, b}},
  };
  for (const auto& known : cases) {
    CAPTURE(known.what);
    const HermiteSpline data{
        known.points, known.derivatives, {0, 1, 2}, false, known.accelerations};
    const Deviation tolerance = relative(data, power_of_ten(-15));
    check_claims(data, c2_hermite_spline(data, tolerance), tolerance);
  }
}

// λ with an odd number of binary places, with an even one, and with other denominators.
TEST_CASE("c2_hermite_spline: straight data are met exactly where that is possible") {
  for (const Vector<Rational>& l :
       {Vector<Rational>{-1, 0, 0}, Vector<Rational>{1, 0, 0}, Vector<Rational>{1, 2, 2},
        Vector<Rational>{0, Rational(1, 3), 0}, Vector<Rational>{0, 3, Rational(-4)}}) {
    HermiteSpline data;
    for (const long s : {0, 1, 3, 7}) {
      data.points.push_back(Rational(s) * l);
      data.derivatives.push_back(Rational(1 + s / 2) * l);
      data.accelerations.push_back(Rational(s % 2) * l);
      data.parameters.emplace_back(data.points.size());
    }
    const Deviation tolerance = relative(data, power_of_ten(-15));
    const Construction found = c2_hermite_spline(data, tolerance, PointRule::exact);
    CHECK(found.deviation.points == 0);
    check_claims(data, found, tolerance);
  }
}
