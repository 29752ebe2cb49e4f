#include "phrame/ph/construct/helical_spline.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/totals.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/proof/classify.hpp"
#include "support/hermite.hpp"

namespace helical_spline_test {

using namespace phrame;
using test::for_samples;
using test::one_segment;
using test::Random;

namespace {

Deviation tolerance(const char* text) { return {parse_rational(text), parse_rational(text)}; }

Vector<Rational> vector(const char* x, const char* y, const char* z) {
  return {parse_rational(x), parse_rational(y), parse_rational(z)};
}

double energy_of(const Curve& curve) {
  return round_to_double(std::get<CurveTotal>(bending_energy(curve)).value);
}

/// How far the curves are from the data, anew, and whether they are joined.
Deviation measured(const Construction& found, const HermiteSpline& data) {
  Deviation squared;
  const auto& curves = found.path.segments();
  const auto look = [&](const Vector<Rational>& r, const Vector<Rational>& d, std::size_t k) {
    const Vector<Rational> off = r - data.points[k];
    const Vector<Rational> off_slope = d - data.derivatives[k];
    squared.points = std::max(squared.points, dot(off, off));
    squared.derivatives = std::max(squared.derivatives, dot(off_slope, off_slope));
  };
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Rational h = data.parameters[k + 1] - data.parameters[k];
    const auto slope = [&](const Curve& curve, long t, const Rational& step) -> Vector<Rational> {
      return Rational(1 / step) * evaluate(hodograph(curve), t);
    };
    look(curves[k].start(), slope(curves[k], 0, h), k);
    look(evaluate(position(curves[k]), 1), slope(curves[k], 1, h), k + 1);
    if (k + 1 == curves.size()) break;
    CHECK(evaluate(position(curves[k]), 1) == curves[k + 1].start());
    CHECK(slope(curves[k], 1, h) ==
          slope(curves[k + 1], 0, Rational(data.parameters[k + 2] - data.parameters[k + 1])));
  }
  return squared;
}

void check_met(const Construction& found, const HermiteSpline& data, const Deviation& asked) {
  const Deviation squared = measured(found, data);
  CHECK(squared.points <= found.deviation.points * found.deviation.points);
  CHECK(squared.derivatives <= found.deviation.derivatives * found.deviation.derivatives);
  CHECK(found.deviation.points <= asked.points);
  CHECK(found.deviation.derivatives <= asked.derivatives);
}

Vector<Rational> random_vector(Random& random, long size) {
  const auto number = [&] { return Rational(random.integer(-size, size), 1000); };
  return {number(), number(), number()};
}

/// The solutions of one segment.
std::vector<Construction> all_of(const HermiteSpline& data, const Deviation& asked) {
  std::vector<Construction> list;
  try {
    for (long k = 1; k <= helical_solutions; ++k) list.push_back(helical_spline(data, k, asked));
  } catch (const DomainError& error) {
    CHECK(std::string(error.what()).ends_with("so no solution " + std::to_string(list.size() + 1)));
  }
  return list;
}

}  // namespace

// Data and numbers of Farouki's talk on helical curves, with 18 digits. (Its energies of the second
// curves, too.)
TEST_CASE("helical quintics: the four of known data have the lengths, angles and energies known") {
  struct Known {
    double length;
    double squared_tangent;
    double energy;
  };
  const auto check = [](const HermiteSpline& data, const std::array<Known, 4>& known) {
    for (long k = 1; k <= 4; ++k) {
      const auto& [length, squared_tangent, energy] = known[static_cast<std::size_t>(k - 1)];
      const Construction found = helical_spline(data, k, tolerance("1e-25"));
      const Curve& curve = found.path.segments().front();
      CHECK(degree(curve) == 5);
      CHECK(static_cast<double>(arc_length(curve)(1)) == doctest::Approx(length).epsilon(1e-14));
      const auto axis = helix(curve.preimage());
      REQUIRE(axis.has_value());
      CHECK(axis->map_degree == 2);
      CHECK(static_cast<double>(1 / axis->cosine_squared - 1) ==
            doctest::Approx(squared_tangent).epsilon(1e-13));
      CHECK(energy_of(curve) == doctest::Approx(energy).epsilon(1e-13));
    }
  };
  check(one_segment({1, 1, 1}, vector("-0.8", "0.3", "1.2"), vector("0.5", "-1.3", "-1")),
        {{{2.35974267543260545, 24.7739631442188520, 8.43828938599157977},
          {2.06886961655150659, 22.9515646517220409, 94.9848842872045810},
          {2.35974267543260545, 24.7739631442188520, 181.211655783525102},
          {2.06886961655150659, 22.9515646517220409, 1484.97155238916563}}});
  check(one_segment({1, 1, 1}, vector("0.4", "-1.5", "-1.2"), vector("-1.2", "-0.6", "-1.2")),
        {{{2.87797896696405226, 219.84223073364729, 16.176671029907991},
          {2.87797896696405226, 219.84223073364729, 46.898068159643582},
          {2.30316776436017593, 169.80172990343519, 62.163845199205198},
          {2.30316776436017593, 169.80172990343519, 114.09335865322970}}});
}

TEST_CASE("helical quintics: random data have four with f = 1, and all are what they should be") {
  for_samples(14, [](Random& random) {
    const long size = random.integer(0, 1) == 0 ? 300 : 3000;
    const HermiteSpline data = one_segment(random_vector(random, 1000), random_vector(random, size),
                                           random_vector(random, size));
    const Deviation asked = tolerance("1e-15");
    double before = 0;
    std::size_t general = 0;
    for (const Construction& found : all_of(data, asked)) {
      check_met(found, data, asked);
      CHECK(is_helical(found.path));
      const Curve& curve = found.path.segments().front();
      const Classification kinds = classify(curve);
      REQUIRE(kinds.helix.has_value());
      const bool is_monotone = curve.multiplier().degree() > 0;
      CHECK(kinds.helix->map_degree == (is_monotone ? 1 : 2));
      CHECK(multiplier_signs(curve) == Signs{true, false});
      if (!is_monotone) ++general;
      const double energy = energy_of(curve);
      if (general == 1 || (is_monotone && general == 4)) before = 0;
      CHECK(energy >= before * (1 - 1e-3));
      before = energy;
      if (is_monotone) general = 5;
    }
    CHECK(general >= 4);
  });
}

TEST_CASE("helical quintics: one that is known comes back, of either form") {
  for_samples(30, [](Random& random) {
    const auto number = [&] { return Rational(random.integer(-9, 9), 4); };
    const auto quaternion = [&]() -> RationalQuaternion {
      return {number(), number(), number(), number()};
    };
    const RationalQuaternion a = quaternion();
    const RationalQuaternion b = quaternion();
    const Vector<Rational> across = cross(rotated_i(a), rotated_i(b));
    if (across == Vector<Rational>{}) return;
    const bool is_monotone = random.chance(2);
    // f = |κ|² > 0 with κ = 1 − t + (x + iy)t.
    const Rational x = number();
    const Rational y = number() + Rational(1, 8);
    const Curve known =
        is_monotone ? Curve(from_bernstein({a, b}),
                            from_bernstein(std::vector<Rational>{1, x, x * x + y * y}))
                    : Curve(from_bernstein({a, number() * a + number() * b, b}), Polynomial{1});
    const HermiteSpline data = one_segment(
        evaluate(position(known), 1), evaluate(hodograph(known), 0), evaluate(hodograph(known), 1));
    Rational least = 1000;
    for (const Construction& found : all_of(data, tolerance("1e-20"))) {
      const std::vector<Vector<Rational>> p = control_points(found.path.segments().front());
      const std::vector<Vector<Rational>> q = control_points(known);
      if (p.size() != q.size()) continue;
      Rational off;
      for (std::size_t k = 0; k < p.size(); ++k) off = std::max(off, largest(p[k] - q[k]));
      least = std::min(least, off);
    }
    CHECK(least < parse_rational("1e-10"));
  });
}

TEST_CASE("helical quintics: a spline is C1 and its numbers do not grow") {
  Random random(5);
  HermiteSpline data;
  for (long k = 0; k <= 60; ++k) {
    data.points.push_back(random_vector(random, 1000) + Vector<Rational>{k, 0, 0});
    data.derivatives.push_back(random_vector(random, 1000) + Vector<Rational>{1, 0, 0});
    data.parameters.push_back(k == 0 ? Rational(0)
                                     : data.parameters.back() + Rational(random.integer(2, 6), 4));
  }
  const Deviation asked = tolerance("1e-15");
  const Construction found = helical_spline(data, 1, asked);
  REQUIRE(found.path.segments().size() == 60);
  check_met(found, data, asked);
  CHECK(is_helical(found.path));
  CHECK(found.bits < 140);
  for (const Curve& curve : found.path.segments())
    for (const RationalQuaternion& a : to_bernstein(curve.preimage(), 2))
      for (const Rational& x : {a.u, a.v, a.p, a.q}) CHECK(rounded_to_places(x, found.bits) == x);
}

// The second derivative along −x and all that is parallel: a line, planes, and nearly so.
TEST_CASE("helical quintics: adverse data have a curve or a line that says why not") {
  const Deviation asked = tolerance("1e-15");
  const auto outcome = [&](const Vector<Rational>& step, const Vector<Rational>& d0,
                           const Vector<Rational>& d1) -> std::string {
    const HermiteSpline data = one_segment(step, d0, d1);
    try {
      std::string list;
      helical_spline(data, 1, asked);
      for (const Construction& found : all_of(data, asked)) {
        check_met(found, data, asked);
        CHECK(is_helical(found.path));
        const QuaternionPolynomial& a = found.path.segments().front().preimage();
        list += line_direction(a) ? 'l' : plane_normal(a) ? 'p' : 'h';
      }
      return list;
    } catch (const Error& error) {
      return error.what();
    }
  };
  const Vector<Rational> x{1, 0, 0};
  const Vector<Rational> y{0, 1, 0};
  const Vector<Rational> nothing{};
  const auto four = [](const std::string& list, char kind) {
    return list.starts_with(std::string(4, kind));
  };
  CHECK(four(outcome(x, y, {0, -1, 0}), 'p'));  // opposite
  CHECK(outcome(x, x, {-1, 0, 0}) == "pppp");   // opposite along the step
  CHECK(four(outcome(nothing, x, y), 'p'));
  CHECK(outcome(x, x, x) == "llll");
  CHECK(outcome({-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}) == "llll");
  CHECK(outcome(x, {9, 0, 0}, {9, 0, 0}).size() == 4);
  CHECK(outcome({1, 1, 0}, x, {2, 0, 0}) == "pppp");
  CHECK(outcome({1, 1, 2}, {3, 4, 7}, {6, 8, 14}).size() == 4);
  CHECK(outcome(vector("1/4", "0", "0"), x, x).size() == 4);
  CHECK(outcome({1, 1, 0}, nothing, x).size() == 2);
  CHECK(outcome({1, 1, 0}, x, nothing).size() == 2);
  CHECK(outcome({1, 1, 0}, nothing, nothing).size() == 2);
  CHECK(outcome(nothing, nothing, nothing) ==
        "segment 1 is a point: its points are equal and its derivatives are 0");
  CHECK(four(outcome(vector("1", "0.2", "0.1"), y, vector("0", "1", "1e-6")), 'h'));
  CHECK(four(outcome(vector("1", "0.2", "0.1"), y, vector("0", "1", "1e-13")), 'h'));
  CHECK(four(outcome(x, y, vector("0", "-1", "1e-13")), 'h'));
  CHECK(four(
      outcome(vector("1", "0.1", "0.2"), vector("1e6", "3e5", "0"), vector("2e5", "-1e6", "1e5")),
      'h'));
  // Four with f = 1, and a monotone one.
  CHECK(outcome(vector("1", "0.1", "0.2"), vector("1e-9", "3e-9", "0"),
                vector("2e-9", "-1e-9", "1e-9")) == "hhhhh");
  CHECK(outcome(vector("-1", "1e-12", "0"), vector("-1", "1e-15", "1e-16"),
                vector("-1", "0", "1e-14")) == "hhhh");
}

// The derivatives of the cubic spline through points of a line are off it by their rounding.
TEST_CASE("helical quintics: points of a line, and nearly so, have their four splines") {
  for (const char* off : {"0", "1e-13", "1e-10", "1e-7", "1e-5"}) {
    CAPTURE(off);
    const Vector<Rational> aside = parse_rational(off) * Vector<Rational>{1, 3, -2};
    GivenPoints given;
    given.points = {{0, 0, 0}, {1, 2, 3}, Vector<Rational>{2, 4, 6} + aside, {5, 10, 15}};
    const HermiteSpline data = hermite_spline(given, false);
    const Deviation asked = tolerance("1e-15");
    for (long k = 1; k <= 4; ++k) {
      const Construction found = helical_spline(data, k, asked);
      check_met(found, data, asked);
      CHECK(is_helical(found.path));
    }
  }
}

TEST_CASE("helical quintics: the size of the data does not matter") {
  const auto lengths = [](const Rational& size) {
    const HermiteSpline data =
        one_segment(size * Vector<Rational>{1, 2, 0}, size * Vector<Rational>{1, 0, 1},
                    size * Vector<Rational>{1, 1, -2});
    const Construction found =
        helical_spline(data, 1, {size * power_of_ten(-15), size * power_of_ten(-15)});
    return static_cast<double>(arc_length(found.path.segments().front())(1) / size);
  };
  const double one = lengths(1);
  CHECK(lengths(power_of_ten(150)) == doctest::Approx(one).epsilon(1e-13));
  CHECK(lengths(power_of_ten(-150)) == doctest::Approx(one).epsilon(1e-13));
}

// The middle leg of symmetric data is along a, so that the equation for f₁ vanishes: the arc of a
// circular helix, (cos, sin)(±1/2) and a climb, has a monotone one that is as symmetric.
TEST_CASE("helical quintics: symmetric data have their monotone ones, too") {
  const HermiteSpline data = one_segment(vector("0", "0.958851077208406", "0.5"),
                                         vector("0.479425538604203", "0.8775825618903728", "0.5"),
                                         vector("-0.479425538604203", "0.8775825618903728", "0.5"));
  const std::vector<Construction> found = all_of(data, tolerance("1e-15"));
  CHECK(found.size() > 4);
  for (std::size_t k = 4; k < found.size(); ++k)
    CHECK(helix(found[k].path.segments().front().preimage())->map_degree == 1);
}

TEST_CASE("helical: what is not in a plane of ℍ is not called so") {
  const QuaternionPolynomial plane = from_bernstein(std::vector<RationalQuaternion>{
      {1, 2, 0, 1}, {3, 3, Rational(1, 2), 1}, {2, 1, Rational(1, 2), 0}});
  CHECK(is_helical(PhPath(Curve(plane))));
  const QuaternionPolynomial other = from_bernstein(std::vector<RationalQuaternion>{
      {1, 2, 0, 1}, {3, 3, Rational(1, 2), 1}, {2, 1, Rational(1, 2), parse_rational("1e-30")}});
  CHECK_FALSE(is_helical(PhPath(Curve(other))));
}

}  // namespace helical_spline_test
