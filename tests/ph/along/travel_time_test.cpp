#include "phrame/ph/along/travel_time.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace travel_time_test {

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

using Of = Feedrate::Of;

/// A = 1 + tk: σ = 1 + t², κ = 2/(1 + t²)².
const Curve plane({{1}, {}, {}, {0, 1}});

Feedrate feed(const Polynomial& v, Of of = Of::arc_length) { return {RationalFunction(v), of}; }

std::string digits(const Real& x) { return round_to_decimal(x, 25).value; }

/// A feedrate that is positive on the curve, with poles of 1/V off the real line or beyond it.
Feedrate random_feed(Random& random) {
  const Of of = random.chance(2) ? Of::arc_length : Of::parameter;
  const Polynomial q = random.polynomial(2);
  const Rational least(1, random.integer(1, 50));
  if (random.chance(3)) return feed({least, abs(random.rational())}, of);
  return feed(q * q + Polynomial{least}, of);
}

}  // namespace

// Values of mpmath to 30 digits or more: quadrature of |r′|/V from the Bernstein coefficients, and
// its root finder.
TEST_CASE("travel time: the quintic of Farouki 2003 with V = 1 + t²") {
  TravelTime time(quintic, feed({1, 0, 1}, Of::parameter));
  CHECK(digits(time.total()) == "3.771554259939347687003314");
  CHECK(digits(time.at_time(Rational(1, 2)).parameter) == "0.08997353912255595629644905");
  CHECK(digits(time.at_time(1).parameter) == "0.1909201813727231864857603");
  CHECK(digits(time.at_time(2).parameter) == "0.4141848760053972427056360");
  CHECK(digits(time.at_time(Rational(7, 2)).parameter) == "0.8862279435755414884843394");
  const Polynomial s = arc_length(quintic);
  CHECK(digits(time.at_time(2).value(s)) == "2.105770135463509054758258");
}

// T = ½ log(1 + 2s) and 2 arctan(s/2); s inverted by mpmath.
TEST_CASE("travel time: linear and quadratic in the arc length, from their closed forms") {
  TravelTime linear(quintic, feed({1, 2}));
  CHECK(digits(linear.total()) == "1.174097802123048995714220");
  CHECK(digits(linear.at_time(Rational(1, 5)).parameter) == "0.04261324819385754514115826");
  CHECK(digits(linear.at_time(1).parameter) == "0.6439910419180355280337729");
  TravelTime quadratic(quintic, feed({1, 0, Rational(1, 4)}));
  CHECK(digits(quadratic.total()) == "2.342030457104199658314130");
  CHECK(digits(quadratic.at_time(1).parameter) == "0.2073930838746667442668292");
}

// T = (t + t³/3 + 4 arctan t)/5, T(1) = 4/15 + π/5; inverted by mpmath.
TEST_CASE("travel time: V = 5/(1 + 2κ) on a plane cubic") {
  TravelTime time(plane, {RationalFunction({5}, {1, 2}), Of::curvature});
  CHECK(digits(time.total()) == "0.8949851973846253143591953");
  CHECK(digits(time.at_time(Rational(1, 4)).parameter) == "0.2530831655286836770795377");
  CHECK(digits(time.at_time(Rational(1, 2)).parameter) == "0.5234085477355591330784293");
}

TEST_CASE("travel time: law: at constant speed it is the arc length over the speed") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational speed(random.integer(1, 40), random.integer(1, 7));
    const ArcLength length(curve);
    TravelTime time(curve, feed({speed}));
    CHECK(time.total().exact() == length.total() / speed);
    const Rational t(random.integer(0, 30), 30);
    CHECK(time.time(t).exact() == length.polynomial()(t) / speed);
    const Rational s = length.total() * Rational(random.integer(0, 50), 50);
    const TimedPoint point = time.at_time(s / speed);
    CHECK(round_to_double(point.parameter) == round_to_double(length.parameter(s)));
    CHECK(point.value(length.polynomial()).exact() == s);
  });
}

TEST_CASE("travel time: what rounds to the same double as the total is the end of the curve") {
  long beyond = 0;
  for_samples(12, [&](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    TravelTime time(curve, random_feed(random));
    const Rational near = exact_rational(round_to_double(time.total()));
    const bool is_beyond = compare_time(near, time.total(), "") > 0;
    if (is_beyond) ++beyond;
    CHECK(is_rounded_total(near, time.total()) == is_beyond);
    if (is_beyond) CHECK(time.at_time(near).parameter.exact() == Rational(1));
    CHECK_THROWS_AS(time.at_time(near * (1 + power_of_two(-51))), DomainError);
  });
  CHECK(beyond > 0);
  const Rational huge = pow(Integer(10), 400);
  TravelTime slow(plane, feed({1 / huge}));  // no double tells this total from another one
  CHECK_THROWS_AS(slow.at_time(2 * *slow.total().exact()), DomainError);
}

TEST_CASE("travel time: law: Arb's quadrature of |f|σ/V agrees") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    TravelTime time(curve, random_feed(random));
    const Rational t(random.integer(0, 12), 12);
    CHECK(quadrature(time.rate(), 0, t, 60).overlaps(time.time(t).enclose(60)));
  });
}

TEST_CASE("travel time: law: at the midpoints beside the rounded t the time is earlier and later") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    TravelTime time(curve, random_feed(random));
    const Rational at = time.total().enclose(64).lower() * Rational(random.integer(1, 99), 100);
    const double t = round_to_double(time.at_time(at).parameter);
    const Rational low = (exact_rational(t) + exact_rational(std::nextafter(t, -1.0))) / 2;
    const Rational high = (exact_rational(t) + exact_rational(std::nextafter(t, 2.0))) / 2;
    if (low > 0) CHECK(time.time(low).enclose(300).lower() <= at);
    if (high < 1) CHECK(time.time(high).enclose(300).upper() >= at);
  });
}

// V = (2t − 1)² + 1/4 would be no harder; here a line stops at a cusp: T = s = ((2t − 1)³ + 1)/6.
TEST_CASE("travel time: exact cases: through a cusp, and where T is a rational function") {
  const Curve line({{-1, 2}, {}, {}, {}});
  TravelTime time(line, feed({1}));
  CHECK(time.at_time(Rational(1, 6)).parameter.exact() == Rational(1, 2));
  CHECK(time.at_time(Rational(3, 16)).parameter.exact() == Rational(3, 4));
  // r′ = 1, V = (1 + t)²: T = 1 − 1/(1 + t), t = T/(1 − T).
  TravelTime rational(Curve({{1}, {}, {}, {}}), feed({1, 2, 1}, Of::parameter));
  CHECK(rational.antiderivative().logs.empty());
  CHECK(rational.total().exact() == Rational(1, 2));
  CHECK(rational.at_time(Rational(1, 3)).parameter.exact() == Rational(1, 2));
  CHECK(rational.at_time(Rational(2, 5)).parameter.exact() == Rational(2, 3));
  // r′ = 1, V = 1/(1 + 2t): T = t + t², t = (√(1 + 4T) − 1)/2, irrational at T = 1.
  TravelTime square(Curve({{1}, {}, {}, {}}), {RationalFunction({1}, {1, 2}), Of::parameter});
  const TimedPoint golden = square.at_time(1);
  CHECK_FALSE(golden.parameter.exact().has_value());
  CHECK(golden.algebraic.has_value());
  CHECK(golden.value({0, 1, 1}).exact() == 1);
  CHECK(digits(golden.parameter) == "0.6180339887498948482045868");  // OEIS A094214
}

// 1/V = 1 + c(t − 1/2)/(t² − t + 5): the logarithm log(t² − t + 5) is the same at t and 1 − t.
TEST_CASE("travel time: a rational t at which the logarithms cancel is recognised") {
  const Polynomial d{5, -1, 1};
  TravelTime time(Curve({{1}, {}, {}, {}}),
                  {RationalFunction(d, d + Polynomial{Rational(-1, 2), 1}), Of::parameter});
  CHECK_FALSE(time.antiderivative().logs.empty());
  CHECK(time.total().exact() == 1);
  CHECK(time.at_time(1).parameter.exact() == 1);
  CHECK_FALSE(time.at_time(Rational(1, 2)).parameter.exact().has_value());
  // 1/V = 1 + (t − 1/4)/(t² − t/2 + 5): at t = 1/2.
  const Polynomial e{5, Rational(-1, 2), 1};
  TravelTime half(Curve({{1}, {}, {}, {}}),
                  {RationalFunction(e, e + Polynomial{Rational(-1, 4), 1}), Of::parameter});
  CHECK(half.at_time(Rational(1, 2)).parameter.exact() == Rational(1, 2));
}

TEST_CASE("travel time: ticks are counted exactly, an end that is a tick is not one of them") {
  TravelTime time(quintic, feed({1}));  // 71/15
  CHECK(time.ticks(1) == 5);
  CHECK(time.ticks(Rational(71, 15)) == 1);
  CHECK(time.ticks(Rational(71, 30)) == 2);
  CHECK(time.ticks(100) == 1);
  CHECK(time.ticks(Rational(71, 15) / 1000 + parse_rational("1e-30")) == 1000);
  CHECK(time.ticks(Rational(71, 15) / 1000 - parse_rational("1e-30")) == 1001);
  TravelTime linear(quintic, feed({1, 2}));  // 1.174…
  CHECK(linear.ticks(Rational(1, 5)) == 6);
  CHECK(linear.ticks(linear.total().enclose(100).upper()) == 1);
  CHECK(linear.ticks(linear.total().enclose(100).lower()) == 2);
  CHECK_THROWS_AS(time.ticks(0), DomainError);
  CHECK_THROWS_AS(time.ticks(-1), DomainError);
}

TEST_CASE("travel time: times off the curve are refused with the value") {
  TravelTime time(quintic, feed({1, 2}));
  CHECK_THROWS_WITH_AS(time.at_time(2), doctest::Contains("2 is outside [0, 1.174"), DomainError);
  CHECK_THROWS_WITH_AS(time.at_time(-1), doctest::Contains("-1 is outside"), DomainError);
  CHECK(time.at_time(0).parameter.exact() == 0);
}

// s = 71/15 of the quintic, V = 2; the first third is as long as s(1/3).
TEST_CASE("travel time: a time at a joint is decided where times are rational") {
  const PhPath pieces = test::cut(quintic, {Rational(1, 3)});
  TravelTime time(pieces, feed({2}));
  const Rational joint = arc_length(quintic)(Rational(1, 3)) / 2;
  CHECK(time.time(1).exact() == joint);
  CHECK(time.total().exact() == Rational(71, 30));
  const TimedPoint point = time.at_time(joint);
  CHECK(point.segment == 1);
  CHECK(point.parameter.exact() == Rational(0));
  CHECK(time.at_time(Rational(71, 30)).parameter.exact() == Rational(1));
  CHECK(time.at_time(joint - parse_rational("1e-40")).segment == 0);
  CHECK(time.ticks(joint) > 1);
}

// T = log(1 + s) on the x axis, s from 0 to 2: at s = 1 it is log 2, at time 1 s = e − 1.
TEST_CASE("travel time: behind a joint that is reached at an irrational time") {
  const Curve line({{1}, {}, {}, {}});
  TravelTime time(test::chain({line, line}), feed({1, 1}));
  CHECK(digits(time.time(1)) == "0.6931471805599453094172321");  // OEIS A002162
  CHECK(digits(time.total()) == "1.098612288668109691395245");   // OEIS A002391
  const TimedPoint point = time.at_time(1);
  CHECK(point.segment == 1);
  CHECK(digits(point.parameter) == "0.7182818284590452353602875");  // OEIS A001113, e − 2
  CHECK(time.at_time(Rational(1, 2)).segment == 0);
  CHECK_THROWS_AS(time.at_time(Rational(11, 10)), DomainError);
}

// 1/V = 1 + (t − 1/2)/(t² − t + 5) along x, cut at 1/3: the logarithms cancel at the end only. With
// (t − 1/4)/(t² − t/2 + 5) they cancel at t = 1/2, 1/4 of the second segment.
TEST_CASE("travel time: logarithms of different segments that cancel are recognised") {
  const PhPath pieces = test::cut(Curve({{1}, {}, {}, {}}), {Rational(1, 3)});
  const auto of_length = [](const Polynomial& d, const Rational& middle) {
    return Feedrate{RationalFunction(d, d + Polynomial{-middle, 1}), Of::arc_length};
  };
  TravelTime whole(pieces, of_length({5, -1, 1}, Rational(1, 2)));
  CHECK_FALSE(whole.time(1).exact());
  CHECK(whole.total().exact() == Rational(1));
  CHECK(whole.ticks(1) == 1);
  TravelTime half(pieces, of_length({5, Rational(-1, 2), 1}, Rational(1, 4)));
  const TimedPoint point = half.at_time(Rational(1, 2));
  CHECK(point.segment == 1);
  CHECK(point.parameter.exact() == Rational(1, 4));
}

TEST_CASE("travel time: a speed that fails on a later segment is refused at its place") {
  const Curve line({{1}, {}, {}, {}});
  const PhPath two = test::chain({line, line});
  const auto refused = [&](const PhPath& path, const Feedrate& feedrate, const char* why) {
    CHECK_THROWS_WITH_AS(TravelTime(path, feedrate), doctest::Contains(why), DomainError);
  };
  refused(two, feed({3, -2}), "the speed is 0 at t = 3/2");
  refused(two, feed({-2, 0, 1}, Of::parameter), "negative, -2 at t = 0");
  refused(two, feed({2, 0, -1}, Of::parameter), "the speed is 0 at t ≈ 1.414213562");
  refused(two, {RationalFunction({1}, {2, -1}), Of::parameter}, "is infinite at t = 2");
  refused(test::chain({line, Curve({{1}, {}, {}, {}}, {1, -2}), Curve({{1}, {}, {}, {}}, {-1})}),
          feed({1}), "segment 2: arc length: the multiplier changes sign");
  const Curve upright({{1}, {}, {0, 1}, {}});
  const PhPath bent = test::chain({reversed(rotated(plane, {0, 0, 0, 1})), upright});
  refused(bent, {RationalFunction(Polynomial{3, 1}), Of::curvature}, "the spline is not plane");
}

TEST_CASE("travel time: law: pieces take the time of the whole") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    const Feedrate feedrate = feed({Rational(1, random.integer(1, 9)), abs(random.rational())});
    const Rational joint(random.integer(1, 6), 7);
    TravelTime whole(curve, feedrate);
    TravelTime pieces(test::cut(curve, {joint}), feedrate);
    CHECK(round_to_double(pieces.total()) == round_to_double(whole.total()));
    const Rational at = whole.total().enclose(64).lower() * Rational(random.integer(1, 99), 100);
    const TimedPoint point = pieces.at_time(at);
    const Rational from = point.segment == 0 ? Rational(0) : joint;
    const Rational to = point.segment == 0 ? joint : Rational(1);
    const Real t = point.parameter * Real(to - from) + from;
    CHECK(round_to_double(t) == round_to_double(whole.at_time(at).parameter));
  });
}

}  // namespace travel_time_test
