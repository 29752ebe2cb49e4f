#include "phrame/ph/along/travel_time.hpp"

#include <cmath>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/segment_time.hpp"
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

TravelTime travel_time(const PhPath& path, const Feedrate& feedrate) {
  return {Path(path), feedrate};
}

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
  TravelTime time = travel_time(quintic, feed({1, 0, 1}, Of::parameter));
  CHECK(digits(time.total()) == "3.771554259939347687003314");
  CHECK(digits(time.at_time(Rational(1, 2)).at.t) == "0.08997353912255595629644905");
  CHECK(digits(time.at_time(1).at.t) == "0.1909201813727231864857603");
  CHECK(digits(time.at_time(2).at.t) == "0.4141848760053972427056360");
  CHECK(digits(time.at_time(Rational(7, 2)).at.t) == "0.8862279435755414884843394");
  const Polynomial s = arc_length(quintic);
  CHECK(digits(value(s, time.at_time(2).at)) == "2.105770135463509054758258");
}

// T = ½ log(1 + 2s) and 2 arctan(s/2); s inverted by mpmath.
TEST_CASE("travel time: linear and quadratic in the arc length, from their closed forms") {
  TravelTime linear = travel_time(quintic, feed({1, 2}));
  CHECK(digits(linear.total()) == "1.174097802123048995714220");
  CHECK(digits(linear.at_time(Rational(1, 5)).at.t) == "0.04261324819385754514115826");
  CHECK(digits(linear.at_time(1).at.t) == "0.6439910419180355280337729");
  TravelTime quadratic = travel_time(quintic, feed({1, 0, Rational(1, 4)}));
  CHECK(digits(quadratic.total()) == "2.342030457104199658314130");
  CHECK(digits(quadratic.at_time(1).at.t) == "0.2073930838746667442668292");
}

// T = (t + t³/3 + 4 arctan t)/5, T(1) = 4/15 + π/5; inverted by mpmath.
TEST_CASE("travel time: V = 5/(1 + 2κ) on a plane cubic") {
  TravelTime time = travel_time(plane, {RationalFunction({5}, {1, 2}), Of::curvature});
  CHECK(digits(time.total()) == "0.8949851973846253143591953");
  CHECK(digits(time.at_time(Rational(1, 4)).at.t) == "0.2530831655286836770795377");
  CHECK(digits(time.at_time(Rational(1, 2)).at.t) == "0.5234085477355591330784293");
}

TEST_CASE("travel time: law: at constant speed it is the arc length over the speed") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational speed(random.integer(1, 40), random.integer(1, 7));
    const ArcLength length(curve);
    TravelTime time = travel_time(curve, feed({speed}));
    CHECK(time.total().exact() == length.total() / speed);
    const Rational t(random.integer(0, 30), 30);
    CHECK(time.time({0, t}).exact() == length.polynomial()(t) / speed);
    const Rational s = length.total() * Rational(random.integer(0, 50), 50);
    const Place point = time.at_time(s / speed).at;
    CHECK(round_to_double(point.t) == round_to_double(length.parameter(s)));
    CHECK(value(length.polynomial(), point).exact() == s);
  });
}

TEST_CASE("travel time: what rounds to the same double as the total is the end of the curve") {
  long beyond = 0;
  for_samples(12, [&](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    TravelTime time = travel_time(curve, random_feed(random));
    const Rational near = exact_rational(round_to_double(time.total()));
    const bool is_beyond = compare_time(near, time.total(), "") > 0;
    if (is_beyond) ++beyond;
    CHECK(is_rounded_total(near, time.total()) == is_beyond);
    if (is_beyond) CHECK(time.at_time(near).at.t.exact() == Rational(1));
    CHECK_THROWS_AS(time.at_time(near * (1 + power_of_two(-51))), DomainError);
  });
  CHECK(beyond > 0);
  const Rational huge = pow(Integer(10), 400);
  TravelTime slow =
      travel_time(plane, feed({1 / huge}));  // no double tells this total from another one
  CHECK_THROWS_AS(slow.at_time(2 * *slow.total().exact()), DomainError);
}

TEST_CASE("travel time: law: Arb's quadrature of |f|σ/V agrees") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    const Feedrate feedrate = random_feed(random);
    TravelTime time = travel_time(curve, feedrate);
    const Polynomial of_t = feedrate.of == Of::parameter ? Polynomial{0, 1} : arc_length(curve);
    const RationalFunction V = compose(feedrate.speed, of_t);
    const RationalFunction rate(differentiate(arc_length(curve)) * V.denominator(), V.numerator());
    const Rational t(random.integer(0, 12), 12);
    CHECK(quadrature(rate, 0, t, 60).overlaps(time.time({0, t}).enclose(60)));
  });
}

TEST_CASE("travel time: law: at the midpoints beside the rounded t the time is earlier and later") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    TravelTime time = travel_time(curve, random_feed(random));
    const Rational at = time.total().enclose(64).lower() * Rational(random.integer(1, 99), 100);
    const double t = round_to_double(time.at_time(at).at.t);
    const Rational low = (exact_rational(t) + exact_rational(std::nextafter(t, -1.0))) / 2;
    const Rational high = (exact_rational(t) + exact_rational(std::nextafter(t, 2.0))) / 2;
    if (low > 0) CHECK(time.time({0, low}).enclose(300).lower() <= at);
    if (high < 1) CHECK(time.time({0, high}).enclose(300).upper() >= at);
  });
}

// V = (2t − 1)² + 1/4 would be no harder; here a line stops at a cusp: T = s = ((2t − 1)³ + 1)/6.
TEST_CASE("travel time: exact cases: through a cusp, and where T is a rational function") {
  const Curve line({{-1, 2}, {}, {}, {}});
  TravelTime time = travel_time(line, feed({1}));
  CHECK(time.at_time(Rational(1, 6)).at.t.exact() == Rational(1, 2));
  CHECK(time.at_time(Rational(3, 16)).at.t.exact() == Rational(3, 4));
  // r′ = 1, V = (1 + t)²: T = 1 − 1/(1 + t), t = T/(1 − T).
  TravelTime rational = travel_time(Curve({{1}, {}, {}, {}}), feed({1, 2, 1}, Of::parameter));
  CHECK(rational.closed_form(0)->logs.empty());
  CHECK(rational.total().exact() == Rational(1, 2));
  CHECK(rational.at_time(Rational(1, 3)).at.t.exact() == Rational(1, 2));
  CHECK(rational.at_time(Rational(2, 5)).at.t.exact() == Rational(2, 3));
  // r′ = 1, V = 1/(1 + 2t): T = t + t², t = (√(1 + 4T) − 1)/2, irrational at T = 1.
  TravelTime square =
      travel_time(Curve({{1}, {}, {}, {}}), {RationalFunction({1}, {1, 2}), Of::parameter});
  const Place golden = square.at_time(1).at;
  CHECK_FALSE(golden.t.exact().has_value());
  CHECK(golden.algebraic != nullptr);
  CHECK(value(Polynomial{0, 1, 1}, golden).exact() == 1);
  CHECK(digits(golden.t) == "0.6180339887498948482045868");  // OEIS A094214
}

// 1/V = 1 + c(t − 1/2)/(t² − t + 5): the logarithm log(t² − t + 5) is the same at t and 1 − t.
TEST_CASE("travel time: a rational t at which the logarithms cancel is recognised") {
  const Polynomial d{5, -1, 1};
  TravelTime time =
      travel_time(Curve({{1}, {}, {}, {}}),
                  {RationalFunction(d, d + Polynomial{Rational(-1, 2), 1}), Of::parameter});
  CHECK_FALSE(time.closed_form(0)->logs.empty());
  CHECK(time.total().exact() == 1);
  CHECK(time.at_time(1).at.t.exact() == 1);
  CHECK_FALSE(time.at_time(Rational(1, 2)).at.t.exact().has_value());
  // 1/V = 1 + (t − 1/4)/(t² − t/2 + 5): at t = 1/2.
  const Polynomial e{5, Rational(-1, 2), 1};
  TravelTime half =
      travel_time(Curve({{1}, {}, {}, {}}),
                  {RationalFunction(e, e + Polynomial{Rational(-1, 4), 1}), Of::parameter});
  CHECK(half.at_time(Rational(1, 2)).at.t.exact() == Rational(1, 2));
}

TEST_CASE("travel time: ticks are counted exactly, an end that is a tick is not one of them") {
  TravelTime time = travel_time(quintic, feed({1}));  // 71/15
  CHECK(time.ticks(1) == 5);
  CHECK(time.ticks(Rational(71, 15)) == 1);
  CHECK(time.ticks(Rational(71, 30)) == 2);
  CHECK(time.ticks(100) == 1);
  CHECK(time.ticks(Rational(71, 15) / 1000 + parse_rational("1e-30")) == 1000);
  CHECK(time.ticks(Rational(71, 15) / 1000 - parse_rational("1e-30")) == 1001);
  TravelTime linear = travel_time(quintic, feed({1, 2}));  // 1.174…
  CHECK(linear.ticks(Rational(1, 5)) == 6);
  CHECK(linear.ticks(linear.total().enclose(100).upper()) == 1);
  CHECK(linear.ticks(linear.total().enclose(100).lower()) == 2);
  CHECK_THROWS_AS(time.ticks(0), DomainError);
  CHECK_THROWS_AS(time.ticks(-1), DomainError);
}

TEST_CASE("travel time: times off the curve are refused with the value") {
  TravelTime time = travel_time(quintic, feed({1, 2}));
  CHECK_THROWS_WITH_AS(time.at_time(2), doctest::Contains("2 is outside [0, 1.174"), DomainError);
  CHECK_THROWS_WITH_AS(time.at_time(-1), doctest::Contains("-1 is outside"), DomainError);
  CHECK(time.at_time(0).at.t.exact() == 0);
}

// s = 71/15 of the quintic, V = 2; the first third is as long as s(1/3).
TEST_CASE("travel time: a time at a joint is decided where times are rational") {
  const PhPath pieces = test::cut(quintic, {Rational(1, 3)});
  TravelTime time = travel_time(pieces, feed({2}));
  const Rational joint = arc_length(quintic)(Rational(1, 3)) / 2;
  CHECK(time.time({1, Rational(0)}).exact() == joint);
  CHECK(time.total().exact() == Rational(71, 30));
  const Place point = time.at_time(joint).at;
  CHECK(point.segment == 1);
  CHECK(point.t.exact() == Rational(0));
  CHECK(time.at_time(Rational(71, 30)).at.t.exact() == Rational(1));
  CHECK(time.at_time(joint - parse_rational("1e-40")).at.segment == 0);
  CHECK(time.ticks(joint) > 1);
}

// T = log(1 + s) on the x axis, s from 0 to 2: at s = 1 it is log 2, at time 1 s = e − 1.
TEST_CASE("travel time: behind a joint that is reached at an irrational time") {
  const Curve line({{1}, {}, {}, {}});
  TravelTime time = travel_time(test::chain({line, line}), feed({1, 1}));
  CHECK(digits(time.time({1, Rational(0)})) == "0.6931471805599453094172321");  // OEIS A002162
  CHECK(digits(time.total()) == "1.098612288668109691395245");                  // OEIS A002391
  const Place point = time.at_time(1).at;
  CHECK(point.segment == 1);
  CHECK(digits(point.t) == "0.7182818284590452353602875");  // OEIS A001113, e − 2
  CHECK(time.at_time(Rational(1, 2)).at.segment == 0);
  CHECK_THROWS_AS(time.at_time(Rational(11, 10)), DomainError);
}

// 1/V = 1 + (t − 1/2)/(t² − t + 5) along x, cut at 1/3: the logarithms cancel at the end only. With
// (t − 1/4)/(t² − t/2 + 5) they cancel at t = 1/2, 1/4 of the second segment.
TEST_CASE("travel time: logarithms of different segments that cancel are recognised") {
  const PhPath pieces = test::cut(Curve({{1}, {}, {}, {}}), {Rational(1, 3)});
  const auto of_length = [](const Polynomial& d, const Rational& middle) {
    return Feedrate{RationalFunction(d, d + Polynomial{-middle, 1}), Of::arc_length};
  };
  TravelTime whole = travel_time(pieces, of_length({5, -1, 1}, Rational(1, 2)));
  CHECK_FALSE(whole.time({1, Rational(0)}).exact());
  CHECK(whole.total().exact() == Rational(1));
  CHECK(whole.ticks(1) == 1);
  TravelTime half = travel_time(pieces, of_length({5, Rational(-1, 2), 1}, Rational(1, 4)));
  const Place point = half.at_time(Rational(1, 2)).at;
  CHECK(point.segment == 1);
  CHECK(point.t.exact() == Rational(1, 4));
}

TEST_CASE("travel time: a speed that fails on a later segment is refused at its place") {
  const Curve line({{1}, {}, {}, {}});
  const PhPath two = test::chain({line, line});
  const auto refused = [&](const PhPath& path, const Feedrate& feedrate, const char* why) {
    CHECK_THROWS_WITH_AS(travel_time(path, feedrate), doctest::Contains(why), DomainError);
  };
  refused(two, feed({3, -2}), "the speed is 0 at t = 3/2");
  refused(plane, feed({0, 1}), "the speed is 0 at t = 0");
  refused(plane, feed({Rational(-4, 3), 1}), "the speed is 0 at t = 1");
  refused(plane, {RationalFunction({1}, {-7, 12}), Of::arc_length}, "is infinite at t ≈ 0.");
  refused(two, feed({-3, 1}), "negative, -3 at t = 0");
  refused(two, feed({-5}), "negative, -5");
  CHECK_NOTHROW(travel_time(two, feed({Rational(20001, 10000), -1})));
  refused(two, feed({-2, 0, 1}, Of::parameter), "negative, -2 at t = 0");
  refused(two, feed({2, 0, -1}, Of::parameter), "the speed is 0 at t ≈ 1.414213562");
  refused(two, {RationalFunction({1}, {2, -1}), Of::parameter}, "is infinite at t = 2");
  const Curve upright({{1}, {}, {0, 1}, {}});
  const PhPath bent = test::chain({reversed(rotated(plane, {0, 0, 0, 1})), upright});
  refused(bent, {RationalFunction(Polynomial{3, 1}), Of::curvature}, "the spline is not plane");
}

/// (t, t², t³)·k: the arc length is an elliptic integral.
TEST_CASE("travel time: what rounds to the same double as the total is the end of any path") {
  long beyond = 0;
  for_samples(12, [&](Random& random) {
    const Rational k(random.integer(1, 50), random.integer(1, 20));
    const Path path(
        Segment(RationalCurve({Polynomial{0, k}, Polynomial{0, 0, k}, Polynomial{0, 0, 0, k}})));
    const Polynomial speed =
        random.chance(2) ? Polynomial{k + 1} : Polynomial{k, random.integer(1, 9)};
    TravelTime time(path, {RationalFunction(speed), Feedrate::Of::arc_length});
    const Rational near = exact_rational(round_to_double(time.total()));
    if (compare_time(near, time.total(), "") > 0) {
      ++beyond;
      CHECK(time.at_time(near).at.t.exact() == Rational(1));
    }
    CHECK_THROWS_AS(time.at_time(near * (1 + power_of_two(-51))), DomainError);
  });
  CHECK(beyond > 0);
}

// r′ = 1, then 1 − 2t, then −1, along x: back at t = 1/2 of the second, at the length 5/4.
TEST_CASE("travel time: through a segment that turns back") {
  const Curve line({{1}, {}, {}, {}});
  const PhPath path =
      test::chain({line, Curve({{1}, {}, {}, {}}, {1, -2}), Curve({{1}, {}, {}, {}}, {-1})});
  TravelTime constant = travel_time(path, feed({Rational(1, 2)}));
  CHECK(constant.total().exact() == Rational(5));
  const TravelTime::Point back = constant.at_time(Rational(5, 2));
  CHECK(back.at.t.exact() == Rational(1, 2));
  CHECK(back.arc_length.exact() == Rational(5, 4));
  // log(1 + s): s = 1 + t − t² on the second segment.
  TravelTime of_length = travel_time(path, feed({1, 1}));
  CHECK(digits(of_length.total()) == "1.252762968495367995688121");
  CHECK(digits(of_length.time({1, Rational(1, 4)})) == "0.7827593392496324420371836");
  // log 2 + ∫ |1 − 2t|/(2 + t) dt + log(4/3), by mpmath.
  TravelTime of_t = travel_time(path, feed({1, 1}, Of::parameter));
  CHECK(of_t.closed_form(0) != nullptr);
  CHECK(of_t.closed_form(1) == nullptr);
  CHECK(digits(of_t.total()) == "1.184939225613001884629336");
}

// A PH line, then (1 + t, t²/2): log 2 + ∫ √(1 + t²)/(2 + t) dt, by mpmath.
TEST_CASE("travel time: along segments of several kinds, where the PH ones have closed forms") {
  const Curve first({{3}, {}, {}, {}}, {Rational(1, 9)});
  Path path{PhSegment(first)};
  path.append(RationalCurve({Polynomial{1, 1}, Polynomial{0, 0, Rational(1, 2)}, {}}));
  TravelTime time(path, feed({1, 1}, Of::parameter));
  CHECK(time.closed_form(0) != nullptr);
  CHECK(time.closed_form(1) == nullptr);
  CHECK(digits(time.time({1, Rational(0)})) == "0.6931471805599453094172321");
  CHECK(digits(time.total()) == "1.152836716476993173539894");
  const TravelTime::Point point = time.at_time(1);
  CHECK(point.at.segment == 1);
  CHECK(time.time(point.at).enclose(80).overlaps(RealBall(1, 80)));
}

TEST_CASE("travel time: law: pieces take the time of the whole") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    const Feedrate feedrate = feed({Rational(1, random.integer(1, 9)), abs(random.rational())});
    const Rational joint(random.integer(1, 6), 7);
    TravelTime whole = travel_time(curve, feedrate);
    TravelTime pieces = travel_time(test::cut(curve, {joint}), feedrate);
    CHECK(round_to_double(pieces.total()) == round_to_double(whole.total()));
    const Rational at = whole.total().enclose(64).lower() * Rational(random.integer(1, 99), 100);
    const Place point = pieces.at_time(at).at;
    const Rational from = point.segment == 0 ? Rational(0) : joint;
    const Rational to = point.segment == 0 ? joint : Rational(1);
    const Real t = point.t * Real(to - from) + from;
    CHECK(round_to_double(t) == round_to_double(whole.at_time(at).at.t));
  });
}

}  // namespace travel_time_test
