#include "phrame/ph/along/speed_profile.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/feedrate.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/travel_time.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace speed_profile_test {

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

Feedrate feed(const std::string& V, std::optional<Rational> normal = {},
              std::optional<Rational> tangential = {}, const Rational& start = 0,
              const Rational& end = 0) {
  Feedrate found = parse_feedrate(V);
  found.limits = {std::move(normal), std::move(tangential), start, end};
  return found;
}

std::string digits(const Real& x) { return round_to_decimal(x, 25).value; }
double rounded(const Real& x) { return round_to_double(x); }

/// κ ≠ 0 somewhere, σ > 0, and numbers that doubles hold.
Curve random_curve(Random& random) {
  const auto quadratic = [&] {
    return from_bernstein({random.integer(-4, 4), random.integer(-4, 4), random.integer(-4, 4)});
  };
  return Curve({quadratic() + Polynomial{5}, quadratic(), quadratic(), quadratic()});
}

std::vector<double> coefficients(const Polynomial& p) {
  std::vector<double> c;
  for (long k = 0; k <= p.degree(); ++k) c.push_back(static_cast<double>(p.coefficient(k)));
  return c;
}
double at(const std::vector<double>& p, double t) {
  double value = 0;
  for (std::size_t k = p.size(); k-- > 0;) value = value * t + p[k];
  return value;
}

/// The time by the two walks on a grid, in doubles: the greatest w there with w ≤ min(V², A/κ) and
/// |Δw| ≤ 2A Δs.
double time_on_grid(const Curve& curve, double V, double normal, double tangential) {
  constexpr std::size_t n = 4000;
  const auto speed = coefficients(sigma(curve.preimage()));
  const auto bend = coefficients(rho(curve.preimage()));
  const auto length = coefficients(arc_length(curve));
  std::vector<double> w(n + 1);
  std::vector<double> step(n);
  for (std::size_t k = 0; k <= n; ++k) {
    const double t = static_cast<double>(k) / n;
    const double square = std::pow(at(speed, t), 2);
    w[k] = std::min(V * V, normal * square / std::sqrt(std::abs(at(bend, t))));
    if (k > 0) step[k - 1] = at(length, t) - at(length, t - 1.0 / n);
  }
  w[0] = w[n] = 0;
  for (std::size_t k = 0; k < n; ++k)
    w[k + 1] = std::min(w[k + 1], w[k] + 2 * tangential * step[k]);
  for (std::size_t k = n; k-- > 0;) w[k] = std::min(w[k], w[k + 1] + 2 * tangential * step[k]);
  double time = 0;
  for (std::size_t k = 0; k < n; ++k) time += 2 * step[k] / (std::sqrt(w[k]) + std::sqrt(w[k + 1]));
  return time;
}

}  // namespace

// L = 10: v² = 4s up to 4, 10 = 4 + 2 and (10 − 8)/4.
TEST_CASE("speed profile: on a line it is the trapezoid or the triangle, exactly") {
  const Path line = test::polygon({{0, 0, 0}, {6, 0, 8}});
  TravelTime trapezoid(line, feed("4", {}, 2));
  CHECK(trapezoid.total().exact() == Rational(9, 2));  // L/V + V/A
  CHECK(trapezoid.at_time(1).arc_length.exact() == Rational(1));
  CHECK(trapezoid.at_time(1).speed->exact() == Rational(2));
  CHECK(trapezoid.at_time(Rational(9, 4)).arc_length.exact() == Rational(5));
  CHECK(trapezoid.at_time(4).arc_length.exact() == Rational(39, 4));
  CHECK(trapezoid.time({0, Rational(1, 40)}).exact() == Rational(1, 2));
  TravelTime triangle(line, feed("40", {}, 2));
  CHECK(digits(triangle.total()) == "4.472135954999579392818347");  // 2√(L/A) = √20
  // From 1 to 3 with v² = 1 + 4s, and down from there in no way: 9 is at s = 2.
  TravelTime between(line, feed("3", 1, 2, 1, 2));
  CHECK(between.total().exact() == Rational(1) + Rational(27, 12) + Rational(1, 2));
  // A corner is a stop, where there is a normal limit.
  const Path bend = test::polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}});
  CHECK(TravelTime(bend, feed("4", {}, 2)).total().exact() == Rational(7));
  CHECK(TravelTime(bend, feed("4", 1, 2)).total().exact() == Rational(9));
  CHECK_THROWS_WITH_AS(TravelTime(bend, feed("4", 1)), doctest::Contains("corner at t = 1"),
                       DomainError);
}

TEST_CASE("speed profile: on an arc the normal limit is a constant, and where it is V as well") {
  const Rational radius(2);  // a quarter of a circle: κ = 1/2
  const Path arc(bezier_curve({{2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {1, 1, 2}));
  for (const char* V : {"2", "5"}) {
    TravelTime time(arc, feed(V, 2));  // √(A r) = 2
    CHECK(digits(time.total()) == "1.570796326794896619231322");
    CHECK(digits(time.at_time(1).arc_length) == "2.000000000000000000000000");
  }
}

// κ = 2/(1 + t²)², so that 1 = √(A/κ) at t = 0 with A = 2, where both have the slope 0; and at 0 of
// the whole, in the middle, where they touch.
TEST_CASE("speed profile: limits that touch are told by algebra along rational curves") {
  const Curve cubic({{1}, {}, {}, {0, 1}});
  CHECK(TravelTime(Path(cubic), feed("1", 2)).total().exact() == Rational(4, 3));
  const Curve whole = segment(cubic, -1, 1);
  CHECK(TravelTime(Path(whole), feed("1", 2)).total().exact() == Rational(8, 3));
  CHECK(TravelTime(Path(whole), feed("1", 2, 1)).total().exact() == Rational(8, 3) + 1);
}

TEST_CASE("speed profile: speeds at the ends that the motion cannot have are refused") {
  const Path line = test::polygon({{0, 0, 0}, {6, 0, 8}});
  const auto refused = [&](const Feedrate& of, const char* why) {
    CHECK_THROWS_WITH_AS(TravelTime(line, of), doctest::Contains(why), DomainError);
  };
  refused(feed("4", {}, 2, 5), "start of the path is more than the motion may have");
  refused(feed("40", {}, 2, 7), "cannot brake in time: at most 6.32455532");  // √40
  refused(feed("40", {}, 2, 0, 7), "end of the path is more than the motion reaches: at most 6.32");
  refused(feed("s - 1", {}, 2), "0 or negative at t = 0");
  refused(feed("min(3, 1 - s/5)"), "0 or negative at t = 1");
  refused(feed("max(s - 2, 1 - s)"), "0 or negative at t = 0.1");
}

// ∫ max(σ/2, √κ σ) dt and ∫ √(1 + s)⁻¹ ds by mpmath's quad with its break points by findroot; the
// others by a linear programme for w on grids of 16 000 steps, by HiGHS, to the digits that those
// of 4000 share.
TEST_CASE("speed profile: the quintic of Farouki 2003") {
  const Path path(quintic);
  CHECK(digits(TravelTime(path, feed("2", 1)).total()) == "3.630830395138903411437607");
  TravelTime root(path, feed("sqrt(1 + s)"));
  CHECK(digits(root.total()) == "2.788875998951458894762977");  // 2√(86/15) − 2
  CHECK(rounded(root.at_time(1).arc_length) == 1.25);
  const auto near = [&](const Feedrate& of, double expected, double digit) {
    CHECK(std::abs(rounded(TravelTime(path, of).total()) - expected) < digit);
  };
  near(feed("2", 1, Rational(3, 2)), 4.3432819, 1e-7);
  near(feed("2", 1, Rational(3, 2), 1, Rational(1, 2)), 3.7281869, 1e-7);
  near(feed("2", 1, Rational(3, 10)), 7.944250191875, 1e-12);
}

TEST_CASE("speed profile: law: it is the fastest motion on a fine grid") {
  for_samples(4, [](Random& random) {
    const Curve curve = random_curve(random);
    const Rational normal(random.integer(1, 40), 10);
    const Rational tangential(random.integer(1, 40));
    const Rational V(random.integer(1, 12));
    const Feedrate of = feed(V.str(), normal, tangential);
    const double found = rounded(TravelTime(Path(curve), of).total());
    const double near = time_on_grid(curve, rounded(V), rounded(normal), rounded(tangential));
    CHECK(std::abs(found / near - 1) < 1e-4);
  });
}

TEST_CASE("speed profile: law: the limits hold at ticks and between them") {
  for_samples(2, [](Random& random) {
    const Path path(random_curve(random));
    const Rational normal(random.integer(1, 40), 10);
    const Rational tangential(random.integer(1, 40));
    TravelTime time(path, feed("6", normal, tangential));
    const Rational total = time.total().enclose(64).lower();
    Real before = Rational(0);
    constexpr long ticks = 12;
    for (long k = 1; k <= ticks; ++k) {
      const TravelTime::Point point = time.at_time(Rational(k, ticks) * total);
      const Real& v = *point.speed;
      const double bend = rounded(curvature(path, point.at)) * rounded(v) * rounded(v);
      const double gain = std::abs(rounded(v + -before)) * ticks / rounded(total);
      CHECK(rounded(v) <= 6);
      CHECK(bend <= rounded(normal) * (1 + 1e-14));
      CHECK(gain <= rounded(tangential) * (1 + 1e-12));
      CHECK(time.time(point.at).enclose(60).overlaps(RealBall(Rational(k, ticks) * total, 60)));
      before = v;
    }
  });
}

TEST_CASE("speed profile: law: back along the path the motion is the same one backwards") {
  for_samples(2, [](Random& random) {
    const Curve curve = random_curve(random);
    const Rational first(random.integer(0, 1), 8);
    TravelTime there(Path(curve), feed("6", 1, 9, first, 0));
    TravelTime back(Path(reversed(curve)), feed("6", 1, 9, 0, first));
    CHECK(there.total().enclose(90).overlaps(back.total().enclose(90)));
    const Rational total = there.total().enclose(90).midpoint();
    const Real sum =
        there.at_time(total / 3).arc_length + back.at_time(total - total / 3).arc_length;
    CHECK(std::abs(rounded(sum + -there.length().total())) < 1e-14 * rounded(total));
  });
}

TEST_CASE("speed profile: law: with ever more tangential acceleration the normal limit is left") {
  const Path path(quintic);
  const double normal_only = rounded(TravelTime(path, feed("2", 1)).total());
  double before = 1e9;
  for (const long A : {2, 1000}) {
    const double total = rounded(TravelTime(path, feed("2", 1, A)).total());
    CHECK(total < before);
    CHECK(total > normal_only);
    CHECK(total - normal_only < 2.0 / static_cast<double>(A));  // two ramps of v < 2
    before = total;
  }
}

TEST_CASE("speed profile: pieces, min and max are the functions that they are made of") {
  const Path path(quintic);
  const auto total = [&](const char* V) { return TravelTime(path, feed(V)).total(); };
  // log 2 + ¾·… : V = 1 + s up to 2, from there on 2.
  CHECK(digits(total("min(1 + s, 2)")) == "2.559813847226611976083899");  // log 2 + (56/15)/2
  CHECK(digits(total("s < 1 ? 1 + s : 2")) == "2.559813847226611976083899");
  CHECK(digits(total("max(min(1 + s, 2), 1)")) == "2.559813847226611976083899");
  CHECK(digits(total("t < 1/2 ? 2 : 2 + 0*t")) == "2.366666666666666666666667");
  // 1 + 11/4 at 4, by symmetry of pieces: 2 up to s = 2, then 4.
  TravelTime jump(path, feed("s < 2 ? 2 : 4"));
  CHECK(digits(jump.total()) == "1.683333333333333333333333");  // 1 + 41/60
  CHECK(digits(jump.at_time(Rational(3, 2)).arc_length) == "4.000000000000000000000000");
  // V starts with the speed at the start, and falls below 2 with that at the end.
  TravelTime starts(path, feed("min(2, 1 + s)", {}, 4, 1, 1));
  CHECK(starts.at_time(0).speed->exact() == Rational(1));
  CHECK(starts.total().enclose(60).lower() > Rational(255, 100));
  // With |dv/dt| ≤ 3/2 it starts to rise at the jump only, and falls before one.
  TravelTime rise(path, feed("s < 2 ? 2 : 4", {}, Rational(3, 2), 2, 2));
  CHECK(rounded(rise.at_time(1).arc_length) == 2);
  TravelTime fall(path, feed("s < 2 ? 4 : 2", {}, Rational(3, 2), 2, 2));
  CHECK(fall.total().enclose(60).upper() < Rational(5, 2));
}

TEST_CASE(
    "speed profile: formulas and curves that are no PH ones take the time of the same PH curve") {
  const Curve curve = quintic;
  const Feedrate of = feed("min(2, 3 - t)", 1, 2);
  const double expected = rounded(TravelTime(Path(curve), of).total());
  CHECK(rounded(TravelTime(test::by_positions(PhPath(curve)), of).total()) == expected);
  CHECK(rounded(TravelTime(Path(test::cut(curve, {Rational(2, 5)})), feed("min(2, 3)", 1, 2))
                    .total()) == rounded(TravelTime(Path(curve), feed("2", 1, 2)).total()));
}

// The normal limit is the least where the parts meet, and irrational there.
TEST_CASE("speed profile: formulas in parts take the time of the whole") {
  const auto part = [](const char* from, const char* to) {
    const auto read = [](const char* text) { return parse_formula(text, "p").value; };
    return ExpressionCurve({read("cos(p)"), read("sin(p)"), read("p^2/3")}, read(from), read(to),
                           "p");
  };
  const Feedrate of = feed("2", Rational(1, 2), 1);
  const Path whole(part("0", "2"));
  CHECK(rounded(TravelTime(whole, of).total()) ==
        rounded(TravelTime(joined({part("0", "1"), part("1", "2")}), of).total()));
}

}  // namespace speed_profile_test
