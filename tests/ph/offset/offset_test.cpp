#include "phrame/ph/offset/offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/exact_meetings.hpp"
#include "phrame/ph/offset/offset_join.hpp"
#include "phrame/ph/offset/offset_measure.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "phrame/ph/offset/offset_trim.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace offset_test {
namespace {

using namespace phrame;
using test::for_samples;
using test::Random;

/// In the plane z = const, of a preimage u + qk times a constant that turns nothing out of it.
Curve plane_curve(Random& random, long degree) {
  for (;;) {
    const QuaternionPolynomial a{
        random.polynomial(degree), {}, {}, random.nonzero_polynomial(degree)};
    const QuaternionPolynomial turn{{random.rational()}, {Rational(1)}, {}, {}};
    const Polynomial f = random.chance(4) ? Polynomial{1, -3} : Polynomial{1};
    return Curve(random.chance(3) ? a * turn : a, f,
                 {random.rational(), random.rational(), random.rational()});
  }
}

Rational distance(Random& random) {
  for (;;)
    if (const Rational d = random.rational(); d != 0) return d;
}

/// Of degree 2 and small coefficients.
Curve tame_curve(Random& random) {
  const auto p = [&] {
    return from_bernstein({random.integer(-6, 6), random.integer(-6, 6), random.integer(-6, 6)});
  };
  return Curve({p(), {}, {}, p() + Polynomial{0, Rational(1, 7)}});
}

PhPath lines(const std::vector<Vector<Rational>>& points) {
  std::vector<Segment> sides;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vector<Rational> way = points[k + 1] - points[k];
    sides.emplace_back(PhSegment(
        std::get<Curve>(identify({Polynomial{way[0]}, Polynomial{way[1]}, {}}, points[k]))));
  }
  return *joined(sides).ph();
}

using Point = std::complex<double>;

double cross(Point a, Point b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// How often the polygon through points of the offset crosses itself.
long sampled_crossings(const Offset& offset, long samples) {
  std::vector<std::pair<Point, Point>> edges;
  for (const OffsetPiece& piece : offset.pieces) {
    const auto at = [&](long k) {
      const Vector<Rational> r = point(piece.curve, Rational(k, samples));
      return Point(static_cast<double>(r[0]), static_cast<double>(r[1]));
    };
    Point last = at(0);
    for (long k = 1; k <= samples; ++k) {
      const Point next = at(k);
      edges.emplace_back(last, next);
      last = next;
    }
  }
  long count = 0;
  const auto sides = [](const auto& e, const auto& f) {
    return cross(e.second - e.first, f.first - e.first) *
               cross(e.second - e.first, f.second - e.first) <
           0;
  };
  const auto left = [&](std::size_t i) {
    return std::min(edges[i].first.real(), edges[i].second.real());
  };
  std::vector<std::size_t> from_left(edges.size());
  std::iota(from_left.begin(), from_left.end(), 0);
  std::ranges::sort(from_left, {}, left);
  for (auto i = from_left.begin(); i != from_left.end(); ++i) {
    const auto& e = edges[*i];
    const double right = std::max(e.first.real(), e.second.real());
    for (auto j = i + 1; j != from_left.end() && left(*j) <= right; ++j) {
      const bool are_neighbours = *i + 1 == *j || *j + 1 == *i;
      if (!are_neighbours && sides(e, edges[*j]) && sides(edges[*j], e)) ++count;
    }
  }
  return count;
}

const Curve parabolic({{1}, {}, {}, {0, 1}});  // w = 1 + it

}  // namespace

TEST_CASE("offset: law: (r_d - r)^2 = d^2, and r_d - r is d times the normal to the right of e1") {
  for_samples(60, [](Random& random) {
    const Curve curve = plane_curve(random, random.integer(0, 4));
    const Rational d = distance(random);
    const RationalCurve found = offset(curve, d);
    const Vector<Polynomial> r = position(curve);
    const Polynomial& w = found.weight();
    const Polynomial x = found.numerator()[0] - r[0] * w;
    const Polynomial y = found.numerator()[1] - r[1] * w;
    CHECK(x * x + y * y == d * d * w * w);
    CHECK(found.numerator()[2] == r[2] * w);
    const Polynomial s = sigma(curve.preimage());
    const auto e1 = rotated_i(curve.preimage());
    CHECK(x * s == d * w * e1[1]);
    CHECK(y * s == -(d * w * e1[0]));
    CHECK(degree(found) <= 2 * degree(curve) - 1);
  });
}

TEST_CASE("offset: law: r_d' = (1 + d kappa) r' as rational functions, with H along e1") {
  for_samples(60, [](Random& random) {
    const Curve curve = plane_curve(random, random.integer(1, 4));
    const Rational d = distance(random);
    const RationalCurve found = offset(curve, d);
    const Vector<Polynomial> r = hodograph(curve);
    // kappa to the left, where e1 is r'/|r'|.
    const Polynomial bend = r[0] * differentiate(r[1]) - r[1] * differentiate(r[0]);
    const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
    const RationalFunction kappa(bend, speed * speed * speed);
    const RationalFunction factor =
        RationalFunction(Polynomial{1}) + RationalFunction(Polynomial{d}) * kappa;
    for (std::size_t k = 0; k < 2; ++k)
      CHECK(differentiate(RationalFunction(found.numerator()[k], found.weight())) ==
            factor * RationalFunction(r[k]));
    CHECK(found.direction()[0](0) * rotated_i(curve.preimage())[0](0) >= 0);
    CHECK(found.direction()[1](0) * rotated_i(curve.preimage())[1](0) >= 0);
  });
}

TEST_CASE("offset: law: that of the reversed path by -d is the same set, and after a cusp by d") {
  for_samples(30, [](Random& random) {
    const Curve curve = plane_curve(random, 3);
    const Rational d = distance(random);
    const auto [positive, negative] = multiplier_signs(curve);
    const RationalCurve there = offset(PhPath(curve), d).pieces[0].curve;
    const RationalCurve back =
        offset(PhPath(segment(curve, 1, 0)), positive && negative ? d : -d).pieces[0].curve;
    for (std::size_t k = 0; k < 3; ++k)
      CHECK((compose(there.numerator()[k], Polynomial{1, -1}) * back.weight() ==
             back.numerator()[k] * compose(there.weight(), Polynomial{1, -1})));
  });
}

TEST_CASE("offset: w = 1 + it, d = -1: the cusp is at sqrt(sqrt 2 - 1), and the two lengths") {
  const Offset found = offset(PhPath(parabolic), -1);
  const auto all = cusps(found);
  REQUIRE(all.size() == 1);
  CHECK(all[0].turns_back);
  CHECK((all[0].t == real_root(Polynomial{-1, 0, 2, 0, 1}, open_interval(0, 1))));
  const OffsetLength lengths = length(found);
  REQUIRE(lengths.stretches.size() == 2);
  CHECK(round_to_decimal(lengths.stretches[0].length.value, 15).value == "0.411261664757214");
  CHECK(round_to_decimal(lengths.stretches[1].length.value, 15).value == "0.173798671295651");
  CHECK(round_to_decimal(lengths.total.value, 15).value == "0.585060336052864");
  CHECK(cusps(offset(PhPath(parabolic), 1)).empty());
  CHECK(paths(found).size() == 1);
}

TEST_CASE("offset: a closed loop of which each part turns by a quarter has cusps at its joints") {
  // kappa = 2/(1 + t^2)^2 on each: from 2 down to 1/2, and up again with a jump at the joint.
  const PhPath loop = test::closed_loop();
  const Offset found = offset(loop, -1);
  const auto all = cusps(found);
  CHECK(all.size() == 8);
  long at_joints = 0;
  for (const OffsetCusp& cusp : all) {
    CHECK(cusp.turns_back);
    if (cusp.t.rational() == Rational(0)) ++at_joints;
  }
  CHECK(at_joints == 4);
  CHECK(paths(found).size() == 4);
  CHECK(paths(offset(loop, 1)).size() == 1);
  CHECK(paths(offset(loop, 1)).front().is_closed());
}

TEST_CASE("offset: law: of a closed loop it is longer by 2 pi d, its area by d L + pi d^2") {
  const PhPath loop = test::closed_loop();
  const DefiniteIntegral area = *signed_area(offset(loop, 1));
  for (const Rational& d : {Rational(1), Rational(1, 3), Rational(5), Rational(-1, 10)}) {
    const Offset found = offset(loop, d);
    CHECK(found.meets.back());
    const Rational length_of_loop(16, 3);
    const DefiniteIntegral total = length(found).total;
    REQUIRE(total.exact);
    CHECK(total.exact->rational == length_of_loop);
    CHECK(total.exact->pi == 2 * d);
    const auto a = signed_area(found);
    REQUIRE(a);
    REQUIRE(a->exact);
    CHECK(a->exact->pi == d * d);
    CHECK(a->exact->rational - area.exact->rational == length_of_loop * (d - 1));
  }
}

TEST_CASE("offset: corners are joined on the outer side, and arcs keep the distance") {
  const Rational d(1, 3);
  const PhPath square =
      *Path(joined({Segment(PhSegment(Curve({{1}, {}, {}, {}}))),
                    Segment(PhSegment(
                        Curve({{1}, {}, {}, {1}}, Polynomial{Rational(1, 2)}, {1, 0, 0})))}))
           .ph();
  REQUIRE(square.corners() == std::vector<std::size_t>{1});
  const Offset round = offset(square, d);
  REQUIRE(round.pieces.size() == 3);
  CHECK(round.pieces[1].is_join);
  const RationalCurve& arc = round.pieces[1].curve;
  const Polynomial x = arc.numerator()[0] - arc.weight();
  CHECK(x * x + arc.numerator()[1] * arc.numerator()[1] == d * d * arc.weight() * arc.weight());
  CHECK(paths(round).size() == 1);
  CHECK(round.inner_corners.empty());
  CHECK(length(round).total.exact->pi == d / 2);

  const Offset mitre = offset(square, d, OffsetJoin::mitre);
  REQUIRE(mitre.pieces.size() == 4);
  CHECK((point(mitre.pieces[1].curve, 1) == Vector<Rational>{1 + d, -d, 0}));
  CHECK(paths(mitre).front().corners() == std::vector<std::size_t>{2});
  CHECK(paths(mitre).front().is_ph());
  CHECK(paths(offset(square, d, OffsetJoin::open)).size() == 2);

  const Offset inner = offset(square, -d);
  CHECK(inner.inner_corners == std::vector<std::size_t>{1});
  CHECK(inner.pieces.size() == 2);
  CHECK(paths(inner).size() == 2);
  const SelfIntersections meeting = self_intersections(inner);
  REQUIRE(meeting.found.size() == 1);
  CHECK(meeting.is_complete());
  CHECK(meeting.found[0].first_t.contains(Rational(2, 3)));
  CHECK(meeting.found[0].second_t.contains(Rational(1, 3)));
}

TEST_CASE("offset: an arc by nearly half a turn is cut, and its parts keep the distance") {
  for (const Rational& h : {Rational(1), Rational(2), Rational(30)}) {
    const Rational c = (1 - h * h) / (1 + h * h);
    const PlaneCorner corner{{0, 0, 0}, {1, 0}, {c, 2 * h / (1 + h * h)}, 1};
    REQUIRE(is_outside(corner, 2));
    CHECK_FALSE(is_outside(corner, -2));
    PlaneCorner back = corner;  // behind a cusp
    back.sign = -1;
    CHECK(is_outside(back, -2));
    CHECK_FALSE(is_outside(back, 2));
    for (const RationalCurve& arc : corner_join(back, -2, OffsetJoin::round)) {
      CHECK(sign_after_zero(arc.multiplier()) < 0);
      CHECK(arc.direction()[1](1) > 0);
    }
    const auto arcs = corner_join(corner, 2, OffsetJoin::round);
    CHECK(arcs.size() == (h == 1 ? 1 : 2));
    for (const RationalCurve& arc : arcs)
      CHECK(arc.numerator()[0] * arc.numerator()[0] + arc.numerator()[1] * arc.numerator()[1] ==
            Rational(4) * arc.weight() * arc.weight());
    CHECK((point(arcs.front(), 0) == Vector<Rational>{0, -2, 0}));
    CHECK((point(arcs.back(), 1) == Vector<Rational>{4 * h / (1 + h * h), -2 * c, 0}));
    if (arcs.size() == 2) CHECK((point(arcs[0], 1) == point(arcs[1], 0)));
  }
}

TEST_CASE("offset: self-intersections are as many as a polygon through 1500 points has") {
  long all = 0;
  for_samples(20, [&](Random& random) {
    const Curve curve = tame_curve(random);
    const Rational length_of_curve = *arc_length(curve, 0, 1);
    const Rational d = length_of_curve * Rational(2 * random.integer(-6, 5) + 1, 24);
    const Offset found = offset(PhPath(curve), d);
    const SelfIntersections meeting = self_intersections(found);
    CHECK(meeting.is_complete());
    CHECK(static_cast<long>(meeting.found.size()) == sampled_crossings(found, 1500));
    all += static_cast<long>(meeting.found.size());
    for (const Crossing& at : meeting.found) {
      const auto r = [&](const RealBall& t, std::size_t k) {
        const RationalCurve& c = found.pieces[0].curve;
        return divide(evaluate(c.numerator()[k], t, 128), evaluate(c.weight(), t, 128), 128);
      };
      for (std::size_t k = 0; k < 2; ++k) CHECK(r(at.first_t, k).overlaps(r(at.second_t, k)));
      CHECK(is_less(at.first_t, at.second_t));
    }
  });
  CHECK(all >= 5);
}

TEST_CASE("offset: a swallowtail, two cusps within one half-plane, meets itself once") {
  // w = 1 + 7/10 i(2t - 1): 1/kappa is least in the middle, where it is 1/2.
  const Rational half(7, 10);
  const Curve bow({{1}, {}, {}, {-half, 2 * half}}, Polynomial{2 * half});
  const Offset found = offset(PhPath(bow), Rational(-3, 5));
  CHECK(cusps(found).size() == 2);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  REQUIRE(meeting.found.size() == 1);
  CHECK(add(meeting.found[0].first_t, meeting.found[0].second_t, 128).contains(1));
  CHECK(self_intersections(offset(PhPath(bow), Rational(-2, 5))).found.empty());
  // Of 200 digits, so that H has integers beyond doubles.
  const Rational other = half + power_of_ten(-200);
  const Curve long_bow({{1}, {}, {}, {-other, 2 * half}}, Polynomial{2 * half});
  const SelfIntersections again = self_intersections(offset(PhPath(long_bow), Rational(-3, 5)));
  CHECK(again.is_complete());
  CHECK(again.found.size() == 1);
}

// Next to its second cusp the curvature is nearly 0, so that both branches nearly coincide there,
// and of 64 bits the powers of t cancel most. A polygon through 6000 points of this offset, cut by
// itself in NumPy, meets itself twice.
TEST_CASE("offset: one of degree 33 that nearly coincides next to a cusp is decided") {
  const Curve curve({from_bernstein({-37, -618, -375, 528, -981, -45, 260, 157, 462}),
                     {},
                     {},
                     from_bernstein({270, -812, -415, 952, -430, 735, 248, -477, -70})});
  const Offset found = offset(PhPath(curve), 1'000'000);
  CHECK(cusps(found).size() == 2);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  CHECK(meeting.found.size() == 2);
}

// w = s + i(1/100 + s^2), s = t - 1/2: the cusps are less than 10^-6 from inflections, and both
// branches turn by little. By mpmath, with 50 digits, the one is on one side of the other at 400
// places along the tangent at a cusp, and findroot() finds no common point.
TEST_CASE("offset: next to an inflection the branches at a cusp part") {
  const Curve curve({{Rational(-1, 2), 1}, {}, {}, {Rational(26, 100), -1, 1}});
  const Offset found = offset(PhPath(curve), 1000);
  CHECK(cusps(found).size() == 2);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  CHECK(meeting.found.empty());
}

// Where the path turns back, its offset goes from one side of a circle to the other one: here with
// one cusp, and all tangents in a half-plane.
TEST_CASE("offset: one cusp, and a crossing, as the path turns back in between") {
  const Curve curve({from_bernstein({-3, 4, -3}), {}, {}, from_bernstein({-2, 0, -3})}, {-5, 9});
  const Offset found = offset(PhPath(curve), 5);
  CHECK(cusps(found).size() == 1);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  CHECK(meeting.found.size() == 1);
  CHECK(sampled_crossings(found, 1500) == 1);
}

bool is_near(const RealBall& t, const char* known) {
  const Rational at = parse_rational(known);
  const Rational width = power_of_ten(-20);
  return t.lower() > at - width && t.upper() < at + width;
}

// w = (s + i/10^11)(2 - 3i + (2 + 7i)s), s = t - 29/50, turns by nearly a half within 10^-10, so
// that the offset goes round a circle there. The place is that of findroot() of mpmath.
TEST_CASE("offset: a near-cusp, at which arcs of doubles are too long") {
  const Rational e = power_of_ten(-11);
  const Polynomial s{Rational(-29, 50), 1};
  const Polynomial a = Polynomial{2} + Rational(2) * s;
  const Polynomial b = Polynomial{-3} + Rational(7) * s;
  const Curve curve({s * a - e * b, {}, {}, s * b + e * a});
  const SelfIntersections meeting = self_intersections(offset(PhPath(curve), Rational(-1, 4)), 96);
  CHECK(meeting.is_complete());
  REQUIRE(meeting.found.size() == 1);
  CHECK(is_near(meeting.found[0].first_t, "0.3868910095489472404"));
  CHECK(is_near(meeting.found[0].second_t, "0.57999999992969932245"));
}

// w = (s + i/10^9)(3 + 6i + (6 - 5i)t), s = t - 3/8, turns by a whole turn, and its branches nearly
// coincide with the circle that it goes round. The places are those of findroot() of mpmath; at
// 10^-6 a polygon through 60 000 points meets itself next to these and nowhere else.
TEST_CASE("offset: branches that are told from the circle they go round by its curvature") {
  const Rational e = power_of_ten(-9);
  const Polynomial s{Rational(-3, 8), 1};
  const Polynomial a{3, 6};
  const Polynomial b{6, -5};
  const Curve curve({s * a - e * b, {}, {}, s * b + e * a});
  const SelfIntersections meeting = self_intersections(offset(PhPath(curve), 1), 96);
  CHECK(meeting.is_complete());
  REQUIRE(meeting.found.size() == 3);
  CHECK(is_near(meeting.found[0].first_t, "0.08681642047001018955951151434"));
  CHECK(is_near(meeting.found[0].second_t, "0.37500000581546694727514293037"));
  CHECK(is_near(meeting.found[1].first_t, "0.37497043509836033427203904"));
  CHECK(is_near(meeting.found[1].second_t, "0.37502956481634554860550306"));
  CHECK(is_near(meeting.found[2].first_t, "0.37499999277566638998482305567"));
  CHECK(is_near(meeting.found[2].second_t, "0.61484797240356188839800157418"));
}

// w = s + ie, s = t - 1/2, turns by a whole turn: the offset goes round a circle that begins and
// ends along its branches. It is symmetric about s = 0, with X(s) = s^3/3 - e^2 s + 2des/(s^2 +
// e^2), and crosses itself where X = 0; its halves have a monotone curvature, so that each does not
// meet itself.
TEST_CASE("offset: a near-cusp of a whole turn") {
  for (const long digits : {6, 15, 100}) {
    CAPTURE(digits);
    const Rational e = power_of_ten(-digits);
    const Rational d(-1, 10);
    const Curve curve({Polynomial{Rational(-1, 2), 1}, {}, {}, Polynomial{e}});
    const SelfIntersections meeting = self_intersections(offset(PhPath(curve), d), 96 + 4 * digits);
    CHECK(meeting.is_complete());
    REQUIRE(meeting.found.size() == 1);
    const Rational middle(1, 2);
    const auto x = [&](const Rational& s) -> Rational {
      return (s * s / 3 - e * e) * (s * s + e * e) + 2 * d * e;
    };
    const RealBall& t = meeting.found[0].second_t;
    CHECK(x(t.lower() - middle).sign() == -1);
    CHECK(x(t.upper() - middle).sign() == 1);
    const RealBall& other = meeting.found[0].first_t;
    CHECK(x(middle - other.upper()).sign() == -1);
    CHECK(x(middle - other.lower()).sign() == 1);
  }
}

// The numbers are those of a picture of Farouki's slides; a polygon through 6000 points of this
// offset, cut by itself in NumPy, has as many.
TEST_CASE("offset: one with four cusps that meets itself six times") {
  const Curve curve({from_bernstein({2, -6, 8, -7}), {}, {}, from_bernstein({9, -9, -3, 7})});
  const Offset found = offset(PhPath(curve), -15);
  CHECK(cusps(found).size() == 4);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  CHECK(meeting.found.size() == 6);
}

TEST_CASE("offset: an arc and what turns back into it part at their joint") {
  // It turns right, at the end with kappa = -4, and behind the corner left.
  PhPath path(Curve({{1}, {}, {}, {2, -2}}));
  path.append(Curve({{1}, {}, {}, {1}}, Polynomial{2}, end_point(path.segments().front())));
  const Offset found = offset(path, Rational(1, 2));
  REQUIRE(found.pieces.size() == 3);
  const auto all = cusps(found);
  REQUIRE(all.size() == 2);
  CHECK(all[1].piece == 1);
  CHECK(all[1].turns_back);
  CHECK(paths(found).size() == 2);
  const SelfIntersections meeting = self_intersections(found);
  CHECK(meeting.is_complete());
  CHECK(static_cast<long>(meeting.found.size()) == sampled_crossings(found, 1500));
}

TEST_CASE("offset: self-intersections of paths with joins are those of polygons, too") {
  long all = 0;
  for_samples(8, [&](Random& random) {
    PhPath path(tame_curve(random));
    try {
      const Curve next = tame_curve(random);
      path.append(Curve(next.preimage(), next.multiplier(), end_point(path.segments().front())));
    } catch (const DomainError&) {
      return;  // the tangent turns back
    }
    const Offset found = offset(path, Rational(2 * random.integer(-8, 7) + 1, 4));
    const SelfIntersections meeting = self_intersections(found);
    CHECK(meeting.is_complete());
    CHECK(static_cast<long>(meeting.found.size()) == sampled_crossings(found, 1000));
    all += static_cast<long>(meeting.found.size());
  });
  CHECK(all >= 5);
}

TEST_CASE("offset: what coincides, and what touches, is told with its place") {
  // The line is traced there and back: its offset, too.
  const Curve back({{1}, {}, {}, {}}, Polynomial{1, -2});
  const SelfIntersections meeting = self_intersections(offset(PhPath(back), 1));
  CHECK(meeting.is_complete());
  CHECK(meeting.found.empty());
  CHECK(meeting.touching.empty());
  REQUIRE(meeting.coincident.size() == 1);
  CHECK(meeting.coincident[0].first_from == Rational(0));
  CHECK(meeting.coincident[0].first_to == Rational(1, 2));
  CHECK(meeting.coincident[0].second_from == Rational(1));
  CHECK(meeting.coincident[0].second_to == Rational(1, 2));
  // The offset by -2 ends where it begins, in the opposite direction.
  const Curve curve({from_bernstein({1, -5, 6}), {}, {}, from_bernstein({3, 5, -2})});
  const SelfIntersections ends = self_intersections(offset(PhPath(curve), -2));
  CHECK(ends.is_complete());
  CHECK(ends.found.empty());
  REQUIRE(ends.touching.size() == 1);
  CHECK(ends.touching[0].first_t.rational() == Rational(0));
  CHECK(ends.touching[0].second_t.rational() == Rational(1));
}

TEST_CASE("offset: what ends on itself, and passes there, is found by algebra") {
  // The offset of the last line ends on that of the one before, in (2, 2).
  const SelfIntersections touching = self_intersections(
      offset(lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {1, 3, 0}, {1, 2, 0}}), -1));
  CHECK(touching.is_complete());
  REQUIRE(touching.found.size() == 3);
  CHECK(touching.found[2].first_segment == 2);
  CHECK(touching.found[2].first_t.contains(Rational(2, 3)));
  CHECK(touching.found[2].second_segment == 3);
  CHECK(touching.found[2].second_t.contains(1));
}

// Of the sides 4 and 3 with a right angle between them, and the third one, those of tan 3/4 meet at
// 3|d| from the corner, those of a right angle at |d|, the others at 2|d|.
TEST_CASE(
    "offset: joins that are shorter than what doubles tell, and crossings as near to corners") {
  const PhPath triangle = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 0, 0}});
  for (const long digits : {8, 20, 100}) {
    CAPTURE(digits);
    const Rational d = power_of_ten(-digits);
    const SelfIntersections outside = self_intersections(offset(triangle, d));
    CHECK(outside.is_complete());
    CHECK(outside.found.empty());
    const SelfIntersections inside = self_intersections(offset(triangle, -d));
    CHECK(inside.is_complete());
    REQUIRE(inside.found.size() == 3);
    const auto is_near = [](const RealBall& t, const Rational& exact) {
      return t.contains(exact) && (exact > Rational(1, 2) || t.accuracy_bits() >= 40);
    };
    CHECK(is_near(inside.found[0].first_t, 3 * d / 4));
    CHECK(is_near(inside.found[0].second_t, 1 - 3 * d / 5));
    CHECK(is_near(inside.found[1].first_t, 1 - d / 4));
    CHECK(is_near(inside.found[1].second_t, d / 3));
    CHECK(is_near(inside.found[2].first_t, 1 - 2 * d / 3));
    CHECK(is_near(inside.found[2].second_t, 2 * d / 5));
  }
}

// Of a path that turns left three times the offsets to the right do not meet, and those to the left
// once at each corner.
TEST_CASE("offset: runs of many tiny pieces that turn by more than a half-plane") {
  const PhPath path = lines({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, Rational(1, 2), 0}});
  for (const long sign : {1, -1}) {
    const SelfIntersections found = self_intersections(offset(path, sign * power_of_ten(-40)));
    CHECK(found.is_complete());
    CHECK(found.found.size() == (sign > 0 ? 0 : 3));
  }
}

/// How many crossings and touching places there are, if that is all.
std::pair<std::size_t, std::size_t> counts(const Curve& curve, const Rational& d) {
  const SelfIntersections found = self_intersections(offset(PhPath(curve), d));
  CHECK(found.is_complete());
  return {found.found.size(), found.touching.size()};
}

// With w = 1/2 + iu, u = 2t - 1 and v = u^2 the offset has x - x(1/2) = u (1/4 - v/3 + 8d/(1 + 4v))
// / 2, which at d = -1/24 has a double root in v = 1/4.
TEST_CASE("offset: halves of a mirrored curve that touch each other on the axis, or nearly") {
  const Curve curve({{Rational(1, 2)}, {}, {}, {-1, 2}});
  const Rational d(-1, 24);
  const SelfIntersections exact = self_intersections(offset(PhPath(curve), d));
  CHECK(exact.is_complete());
  CHECK(exact.found.empty());
  REQUIRE(exact.touching.size() == 1);
  CHECK(exact.touching[0].first_t.rational() == Rational(1, 4));
  CHECK(exact.touching[0].second_t.rational() == Rational(3, 4));
  CHECK(counts(curve, d - power_of_ten(-60)) == std::pair(0UL, 0UL));
  CHECK(counts(curve, d + power_of_ten(-30)) == std::pair(2UL, 0UL));
  // As two parts of one curve, which coincide where neither is: the resultant without that.
  const PhPath parts =
      test::chain({segment(curve, 0, Rational(3, 5)), segment(curve, Rational(3, 5), 1)});
  const SelfIntersections split = self_intersections(offset(parts, d));
  CHECK(split.is_complete());
  REQUIRE(split.touching.size() == 1);
  CHECK(split.touching[0].first_t.rational() == Rational(5, 12));
  CHECK(split.touching[0].second_t.rational() == Rational(3, 8));
}

// With dr/du = (1 - 20/19 v)(1 + iu)^2 it is u (I + 2d/(1 + v)) with I = 1 - 13/19 v + 4/19 v^2.
// Then (I (1 + v))' = 0 at v = 1/2, where I (1 + v) = 81/76: at d = -81/152 two cusps meet at u =
// +-sqrt(1/2).
TEST_CASE("offset: two cusps that meet on the axis of a mirrored curve") {
  const Polynomial u{Rational(-9, 10), Rational(9, 5)};
  const Curve curve({{1}, {}, {}, u}, Rational(9, 5) * (Polynomial{1} - Rational(20, 19) * u * u));
  const Rational d(-81, 152);
  const SelfIntersections exact = self_intersections(offset(PhPath(curve), d));
  CHECK(exact.is_complete());
  CHECK(exact.found.size() == 2);
  REQUIRE(exact.touching.size() == 1);
  const RealAlgebraic& s = exact.touching[0].first_t;
  const RealAlgebraic& t = exact.touching[0].second_t;
  CHECK(approximate(enclose(s, 64)) == doctest::Approx(0.5 - 5 * std::sqrt(0.5) / 9));
  CHECK(approximate(enclose(t, 64)) == doctest::Approx(0.5 + 5 * std::sqrt(0.5) / 9));
  CHECK(counts(curve, d - power_of_ten(-60)) == std::pair(2UL, 0UL));
}

// The tip of the notch is 2 above the lowest side, or 10^-30 more or less: the arc about it, and
// the offset of that side, touch in (5, 1).
TEST_CASE("offset: an arc that touches the offset of a side, or nearly") {
  const auto meetings = [](const Rational& floor) {
    return self_intersections(offset(lines({{0, floor, 0},
                                            {10, floor, 0},
                                            {10, 8, 0},
                                            {Rational(19, 2), 8, 0},
                                            {5, 2, 0},
                                            {Rational(1, 2), 8, 0},
                                            {0, 8, 0},
                                            {0, floor, 0}}),
                                     -1));
  };
  const SelfIntersections exact = meetings(0);
  CHECK(exact.is_complete());
  REQUIRE(exact.touching.size() == 1);
  CHECK(exact.touching[0].first_segment == 0);
  CHECK(exact.touching[0].first_t.rational() == Rational(1, 2));
  const SelfIntersections apart = meetings(-power_of_ten(-30));
  const SelfIntersections crossing = meetings(power_of_ten(-30));
  for (const SelfIntersections& found : {apart, crossing}) {
    CHECK(found.is_complete());
    CHECK(found.touching.empty());
  }
  CHECK(apart.found.size() == exact.found.size());
  CHECK(crossing.found.size() == exact.found.size() + 2);
}

// (1 + t)/2 + s, and 2s/(1 + s) with poles outside of [0, 1], for the parameter of one curve.
TEST_CASE("offset: parts of one curve coincide, whatever their parameters") {
  const Curve curve({{1}, {}, {}, {-1, 2}});
  const RationalCurve whole = offset(curve, 1);
  // t = 2s/(1 + s) in X, Y, W, times (1 + s)^n.
  const auto reparametrized = [&](const Polynomial& p) {
    Polynomial sum;
    const long n = degree(whole);
    for (long k = 0; k <= n; ++k)
      sum += p.coefficient(k) * pow(Polynomial{0, 2}, k) * pow(Polynomial{1, 1}, n - k);
    return sum;
  };
  const auto x = whole.numerator();
  const RationalCurve moebius({reparametrized(x[0]), reparametrized(x[1]), reparametrized(x[2])},
                              reparametrized(whole.weight()));
  const OffsetBranches branches{{whole, offset(segment(curve, Rational(1, 4), Rational(3, 4)), 1),
                                 moebius, offset(segment(curve, Rational(3, 4), 1), 1)},
                                {no_segment, no_segment, no_segment, no_segment}};
  const CurveSeries series = plane_series(branches.curves, branches.behind);
  const SelfIntersections found = self_intersections(branches, series, {});
  CHECK(found.is_complete());
  CHECK(found.found.empty());
  CHECK(found.touching.empty());
  std::vector<std::string> parts;
  for (const CoincidentParts& c : found.coincident)
    parts.push_back(fmt::format(
        "{}: {} to {}, {}: {} to {}", c.first_segment, to_string(*c.first_from.rational()),
        to_string(*c.first_to.rational()), c.second_segment, to_string(*c.second_from.rational()),
        to_string(*c.second_to.rational())));
  // s = t/(2 - t).
  CHECK(parts == std::vector<std::string>{"0: 0 to 1, 2: 0 to 1", "0: 1/4 to 3/4, 1: 0 to 1",
                                          "0: 3/4 to 1, 3: 0 to 1", "1: 0 to 1, 2: 1/7 to 3/5",
                                          "2: 3/5 to 1, 3: 0 to 1"});
}

// From (0, 0) to (5, 0) with x = 5t, round a rectangle, and again with x = 2t + 3t^2; then with x =
// 3t + 2t^3, and from (-3, 0) with x = 6t + 2t^2 - 3, where x = 0 has no rational root.
TEST_CASE("offset: lines coincide that are gone along in different manners") {
  const auto line = [](const Vector<Rational>& from, const Polynomial& rate) {
    return Curve({{1}, {}, {}, {}}, rate, from);
  };
  const auto round = [&](const Polynomial& first, const Rational& side, const Polynomial& last) {
    PhPath path(line({0, 0, 0}, first));
    const PhPath way = lines({{5, 0, 0}, {5, 4, 0}, {side, 4, 0}, {side, 0, 0}});
    for (const Curve& edge : way.segments()) path.append(edge);
    path.append(line({side, 0, 0}, last));
    return path;
  };
  const SelfIntersections found = self_intersections(offset(round({5}, 0, {2, 6}), Rational(1, 2)));
  CHECK(found.is_complete());
  CHECK(found.found.empty());
  REQUIRE(found.coincident.size() == 1);
  CHECK(found.coincident[0].first_from == Rational(0));
  CHECK(found.coincident[0].first_to == Rational(1));
  CHECK(found.coincident[0].second_from == Rational(0));
  CHECK(found.coincident[0].second_to == Rational(1));
  // 2t^2 + 6t - 3 = 0 where x = 0.
  const SelfIntersections irrational =
      self_intersections(offset(round({3, 0, 6}, -3, {6, 4}), Rational(1, 2)));
  CHECK(irrational.is_complete());
  CHECK(irrational.found.empty());
  CHECK(irrational.touching.empty());
  REQUIRE(irrational.coincident.size() == 1);
  const CoincidentParts& part = irrational.coincident[0];
  CHECK(part.first_from == Rational(0));
  CHECK(part.first_to == Rational(1));
  CHECK(part.second_from.polynomial() == Polynomial{-3, 6, 2});
  CHECK(std::abs(approximate(enclose(part.second_from, 64)) - (std::sqrt(15.0) - 3) / 2) < 1e-15);
  CHECK(part.second_to == Rational(1));
  // The other way, from (7, 0) to (-2, 0) with x = 7 - 6t - 3t^2: 3t^2 + 6t = 2 and 7.
  const PhPath back = round({3, 0, 6}, 7, {-6, -6});
  const OffsetBranches both{
      {branches_of(offset(back, 1)).curves.front(), branches_of(offset(back, -1)).curves.back()},
      {no_segment, no_segment}};
  const SelfIntersections opposite =
      self_intersections(both, plane_series(both.curves, both.behind), {});
  CHECK(opposite.is_complete());
  REQUIRE(opposite.coincident.size() == 1);
  CHECK(opposite.coincident[0].first_from == Rational(0));
  CHECK(opposite.coincident[0].second_from.polynomial() == Polynomial{-7, 6, 3});
  CHECK(opposite.coincident[0].second_to.polynomial() == Polynomial{-2, 6, 3});
}

// x' = 6t^2 - 6t + 1 is 0 at (3 -+ sqrt 3)/6, and x = 0 at 0, 1/2 and 1.
TEST_CASE("offset: a line that turns back at irrational places coincides with itself leg by leg") {
  const Curve line({{2}, {}, {}, {1}}, {1, -6, 6});
  const SelfIntersections meeting = self_intersections(offset(PhPath(line), Rational(1, 3)));
  CHECK(meeting.is_complete());
  CHECK(meeting.found.empty());
  CHECK(meeting.touching.empty());
  REQUIRE(meeting.coincident.size() == 2);
  const CoincidentParts& first = meeting.coincident[0];
  const CoincidentParts& second = meeting.coincident[1];
  CHECK(first.first_from == Rational(0));
  CHECK(first.second_from == Rational(1, 2));
  CHECK(first.first_to == first.second_to);
  CHECK(first.first_to.polynomial() == Polynomial{1, -6, 6});
  CHECK(second.first_from == Rational(1, 2));
  CHECK(second.second_from == Rational(1));
  CHECK(second.second_to == second.first_to);
  for (const CoincidentParts& x : meeting.coincident) CHECK(x.is_alike);
}

// From x = 0 to 1/3, back to 0 and to 1/3 again with x' = 3 - 16t + 16t^2, round a triangle, and
// from there on: the last line has one point in common with the first one, at t = 1/4 and 1.
TEST_CASE("offset: a line touches the end of one that turns back there") {
  PhPath path(Curve({{1}, {}, {}, {}}, {3, -16, 16}));
  const Rational x(1, 3);
  const PhPath way =
      lines({{x, 0, 0}, {x, 1, 0}, {x - Rational(3, 4), 1, 0}, {x, 0, 0}, {1, 0, 0}});
  for (const Curve& edge : way.segments()) path.append(edge);
  const SelfIntersections meeting = self_intersections(offset(path, Rational(1, 8)));
  CHECK(meeting.is_complete());
  CHECK(meeting.coincident.size() == 3);
  REQUIRE(meeting.touching.size() == 2);
  CHECK(meeting.touching[0].first_t == Rational(1, 4));
  for (const KnownMeeting& place : meeting.touching) CHECK_FALSE(place.crosses);
}

/// From there along the Tschirnhausen cubic by v = h(t), r' = (1 - v^2, 2v)h'.
Curve along_cubic(const Polynomial& h, const Vector<Rational>& from = {0, 0, 0}) {
  return Curve({{1}, {}, {}, h}, differentiate(h), from);
}

/// By v = h(t), round far below and back, and by v = k(t) along the same cubic.
PhPath twice_along_cubic(const Polynomial& h, const Polynomial& k) {
  const auto at = [](const Rational& v) -> Vector<Rational> {
    return {v - v * v * v / 3, v * v, 0};
  };
  PhPath path(along_cubic(h, at(h(0))));
  const Vector<Rational> end = at(h(1));
  const Vector<Rational> start = at(k(0));
  const PhPath way =
      lines({end, {end[0], 9, 0}, {-9, 9, 0}, {-9, -5, 0}, {start[0], -5, 0}, start});
  for (const Curve& edge : way.segments()) path.append(edge);
  path.append(along_cubic(k, start));
  return path;
}

// v = (t^2 + t)/2 and t^3 - 1/2 are both from 0 to 1/2: up to t = (sqrt 5 - 1)/2 and from 2^(-1/3).
// At d = -1 the offset of the cubic has a cusp at v = sqrt(sqrt 2 - 1).
TEST_CASE("offset: curves coincide that go through their points more than once") {
  const PhPath path =
      twice_along_cubic({0, Rational(1, 2), Rational(1, 2)}, {Rational(-1, 2), 0, 0, 1});
  for (const Rational& d : {Rational(1, 5), Rational(-1)}) {
    const SelfIntersections found = self_intersections(offset(path, d));
    CHECK(found.is_complete());
    REQUIRE(found.coincident.size() == 1);
    const CoincidentParts& part = found.coincident[0];
    CHECK(part.first_from == Rational(0));
    CHECK(part.first_to.polynomial() == Polynomial{-1, 1, 1});
    CHECK(part.second_from.polynomial() == Polynomial{-1, 0, 0, 2});
    CHECK(part.second_to == Rational(1));
    CHECK(part.is_alike);
  }
  // t^3 and t^5 through the cusp.
  const SelfIntersections whole =
      self_intersections(offset(twice_along_cubic({0, 0, 0, 1}, {0, 0, 0, 0, 0, 1}), -1));
  CHECK(whole.is_complete());
  REQUIRE(whole.coincident.size() == 1);
  CHECK(whole.coincident[0].first_to == Rational(1));
  CHECK(whole.coincident[0].second_to == Rational(1));
}

// v = 15t/2 - 18t^2 + 12t^3 goes from 0 on to 0.98, back to 0.52 and on to 3/2. Both ways are
// legs of one curve, and with v = (1 + 2t)/4 there and back on the first of them.
TEST_CASE("offset: a curve that goes to and fro coincides with itself leg by leg") {
  const Polynomial h{0, Rational(15, 2), -18, 12};
  const SelfIntersections alone =
      self_intersections(offset(PhPath(along_cubic(h)), Rational(1, 5)));
  CHECK(alone.is_complete());
  CHECK(alone.found.empty());
  REQUIRE(alone.coincident.size() == 3);
  const auto turn = [](const RealAlgebraic& t) { return t.polynomial() == Polynomial{5, -24, 24}; };
  for (const CoincidentParts& x : alone.coincident) CHECK((turn(x.first_to) && x.is_alike));
  CHECK(turn(alone.coincident[2].first_from));
  // The first leg is where the third one goes by v = h at the second place where it turns.
  const auto approximately = [](const RealAlgebraic& t) { return approximate(enclose(t, 64)); };
  const double root = 1 / std::sqrt(24.0);
  CHECK(std::abs(approximately(alone.coincident[1].first_from) - (0.5 - 2 * root)) < 1e-15);
  CHECK(std::abs(approximately(alone.coincident[1].second_to) - (0.5 + 2 * root)) < 1e-15);
  const SelfIntersections both = self_intersections(
      offset(twice_along_cubic(h, {Rational(1, 4), Rational(1, 2)}), Rational(1, 5)));
  CHECK(both.is_complete());
  CHECK(both.coincident.size() == 6);
}

// v = -3 + 16t - 16t^2 up to 1 and back, and v = 3 - 10t + 10t^2 down to 1/2 and back: both are on
// what is between 1/2 and 1, on which none ends. The right of one is the left of the other one.
TEST_CASE("offset: curves coincide between places where they turn back") {
  const Curve first = along_cubic({-3, 16, -16}, {6, 9, 0});
  const Curve second = along_cubic({3, -10, 10}, {-6, 9, 0});
  const OffsetBranches both{{offset(first, Rational(1, 5)), offset(second, Rational(-1, 5))},
                            {no_segment, no_segment}};
  const SelfIntersections found =
      self_intersections(both, plane_series(both.curves, both.behind), {});
  CHECK(found.is_complete());
  long count = 0;
  for (const CoincidentParts& x : found.coincident) {
    if (x.first_segment == x.second_segment) continue;
    ++count;
    const RealAlgebraic half(Rational(1, 2));
    CHECK((x.first_from == half ? x.first_to : x.first_from).polynomial() ==
          Polynomial{7, -32, 32});
    CHECK((x.second_from == half ? x.second_to : x.second_from).polynomial() ==
          Polynomial{1, -5, 5});
  }
  CHECK(count == 4);
}

// The weight of the offset, 1 - 6t + 18t^2, has a negative Bernstein coefficient, and there is a
// cusp in both parts that coincide.
TEST_CASE("offset: parts that coincide where no box is known, and through a cusp") {
  const Curve curve({{1, -3}, {}, {}, {0, 3}});
  const OffsetBranches branches{{offset(curve, Rational(-3, 4)),
                                 offset(segment(curve, 0, Rational(11, 14)), Rational(-3, 4))},
                                {no_segment, no_segment}};
  const CurveSeries series = plane_series(branches.curves, branches.behind);
  CHECK_FALSE(series.boxes[0][0].is_finite());
  const SelfIntersections found = self_intersections(branches, series, {});
  CHECK(found.is_complete());
  REQUIRE(found.coincident.size() == 1);
  CHECK(found.coincident[0].first_to == Rational(11, 14));
  CHECK(found.coincident[0].second_to == Rational(1));
  CHECK(found.touching.empty());
}

// Where two of a smooth spline's quintics join, the offset turns back: 1 + dk is 0 at the end of
// one, so that both branches leave the joint along one ray. As for two of three such quintics, the
// second of which, w = (-3 - i)((1 - t)^2 + it^2), is (8 + 6i)i/15 long from end to end, 2/3 across
// its tangents, which are opposite: the offset by -1/3 touches itself where it begins and ends.
TEST_CASE("offset: joints at which it turns back, and joints at which it touches itself") {
  const auto spline = [](const std::vector<std::array<std::vector<Rational>, 2>>& w) {
    PhPath path{Curve({from_bernstein(w[0][0]), {}, {}, from_bernstein(w[0][1])})};
    for (std::size_t k = 1; k < w.size(); ++k)
      path.append(Curve({from_bernstein(w[k][0]), {}, {}, from_bernstein(w[k][1])}, {1},
                        evaluate(position(path.segments().back()), 1)));
    return path;
  };
  for (const auto& [path, d] :
       {std::pair(spline({{{{-4, -2, 1}, {-2, -1, 1}}}, {{{1, -5, 5}, {1, -4, 1}}}}), Rational(1)),
        std::pair(spline({{{{-1, 0, -2}, {-4, 6, 0}}}, {{{-2, 2, 4}, {0, 4, -4}}}}),
                  Rational(-1, 3))}) {
    const Offset turning = offset(path, d);
    const SelfIntersections found = self_intersections(turning);
    CHECK(found.is_complete());
    CHECK(found.touching.empty());
    CHECK(static_cast<long>(found.found.size()) == sampled_crossings(turning, 4000));
  }
  const SelfIntersections ends = self_intersections(offset(
      spline(
          {{{{-5, -4, -3}, {1, 6, -1}}}, {{{-3, 0, 1}, {-1, 0, -3}}}, {{{1, 2, 5}, {-3, 2, 1}}}}),
      Rational(-1, 3)));
  CHECK(ends.is_complete());
  CHECK(ends.found.empty());
  REQUIRE(ends.touching.size() == 1);
  CHECK(ends.touching[0].first_segment == 1);
  CHECK(ends.touching[0].first_t.rational() == Rational(0));
  CHECK(ends.touching[0].second_segment == 2);
  CHECK(ends.touching[0].second_t.rational() == Rational(0));
}

// (u^2 - 1, u^3 - u) goes through (0, 0) at u = 1 and u = -1. For y = x + cx^2 there the difference
// y - x - cx^2 is (u - 1)^2 (u + 1)(1 - c(u + 1)), of order 3 at u = 1 for c = 1/2.
TEST_CASE("offset: of three branches through one point two touch, or osculate, and two cross") {
  const Polynomial u{-2, 4};
  const Polynomial x = u * u - Polynomial{1};
  const Polynomial v{-1, 2};
  for (const bool crosses : {false, true}) {
    const Rational c(crosses ? 1 : -1, 2);
    const OffsetBranches both{
        {RationalCurve({x, u * x, {}}), RationalCurve({v, v + c * v * v, {}})},
        {no_segment, no_segment}};
    const CurveSeries series = plane_series(both.curves, both.behind);
    ExactMeetings exact(both, series);
    const auto touching = exact.between({{0, 0.6875, 0.8125}, {1, 0.4375, 0.5625}});
    REQUIRE(touching);
    CHECK(touching->crossings.empty());
    REQUIRE(touching->touching.size() == 1);
    CHECK(touching->touching[0].first_t.rational() == Rational(3, 4));
    CHECK(touching->touching[0].second_t.rational() == Rational(1, 2));
    CHECK(touching->touching[0].crosses == crosses);
    const auto crossing = exact.between({{0, 0.1875, 0.3125}, {1, 0.4375, 0.5625}});
    REQUIRE(crossing);
    CHECK(crossing->touching.empty());
    REQUIRE(crossing->crossings.size() == 1);
    CHECK(crossing->crossings[0].first_t.contains(Rational(1, 4)));
  }
}

// Where A = t^2 + t - 1 has its root, the curves with w = A + iB and w = (A - 5iB)/7, B = 2t + 1,
// have y = A^2 and y = -5/49 A^2, and one point: with x0 = 0 and -144/245 their x there are equal,
// as the integrals of A^2 and B^2 from 0 to it are (-41 + 25 sqrt 5)/60 and (-1 + 5 sqrt 5)/6.
TEST_CASE("offset: curves that touch at irrational parameters, miss each other, or cross twice") {
  const Polynomial a{-1, 1, 1};
  const Polynomial b{1, 2};
  const Curve upper({a, {}, {}, b}, {1}, {0, 1, 0});
  const auto meetings = [&](const Rational& gap) {
    const Rational low = Rational(-5, 49) - gap;
    const Vector<Rational> start{Rational(-144, 245), low, 0};
    const Vector<Rational> end = evaluate(position(upper), 1);
    PhPath path(upper);
    const PhPath way = lines({end, {-10, 1, 0}, {-10, -10, 0}, {10, -10, 0}, {10, low, 0}, start});
    for (const Curve& line : way.segments()) path.append(line);
    path.append(Curve({Rational(1, 7) * a, {}, {}, Rational(-5, 7) * b}, {1}, start));
    return self_intersections(offset(path, Rational(1, 2)));
  };
  const SelfIntersections exact = meetings(0);
  CHECK(exact.is_complete());
  REQUIRE(exact.touching.size() == 1);
  CHECK(exact.touching[0].first_segment == 0);
  CHECK(exact.touching[0].first_t == real_root(a, open_interval(0, 1)));
  CHECK(exact.touching[0].second_t == real_root(a, open_interval(0, 1)));
  const SelfIntersections apart = meetings(power_of_ten(-60));
  const SelfIntersections crossing = meetings(-power_of_ten(-60));
  for (const SelfIntersections& found : {apart, crossing}) {
    CHECK(found.is_complete());
    CHECK(found.touching.empty());
  }
  CHECK(apart.found.size() == exact.found.size());
  CHECK(crossing.found.size() == exact.found.size() + 2);
}

// y = A^4 and y = A^3 touch y = 0 as above, with the same curvature; the second one crosses it
// there.
TEST_CASE("offset: a curve that osculates a line at an irrational parameter") {
  const Polynomial a{-1, 1, 1};
  const Polynomial b{1, 2};
  const auto meetings = [&](const Polynomial& u, const Polynomial& q, const Rational& y) {
    const Curve curve({u, {}, {}, q}, {1}, {0, y, 0});
    PhPath path(curve);
    const PhPath way = lines({evaluate(position(curve), 1),
                              {-10, 1, 0},
                              {-10, -10, 0},
                              {10, -10, 0},
                              {10, 0, 0},
                              {-10, 0, 0}});
    for (const Curve& line : way.segments()) path.append(line);
    return self_intersections(offset(path, Rational(1, 2)));
  };
  const SelfIntersections touching = meetings(Rational(2) * pow(a, 3), b, 1);
  CHECK(touching.is_complete());
  REQUIRE(touching.touching.size() == 1);
  CHECK(touching.touching[0].first_t == real_root(a, open_interval(0, 1)));
  CHECK_FALSE(touching.touching[0].crosses);
  const SelfIntersections crossing = meetings(pow(a, 2), Rational(3, 2) * b, -1);
  CHECK(crossing.is_complete());
  REQUIRE(crossing.touching.size() == 1);
  CHECK(crossing.touching[0].crosses);
  CHECK(crossing.touching[0].first_t == real_root(a, open_interval(0, 1)));
}

TEST_CASE("offset: no distance, and no plane z = const") {
  CHECK_THROWS_WITH_AS(offset(parabolic, 0), "offset: the distance is 0", DomainError);
  const Curve space({{1}, {0, 1}, {0, 0, 1}, {}});
  CHECK_THROWS_WITH_AS(offset(PhPath(space), 1), "offset: the path is in no plane z = const",
                       DomainError);
  CHECK_THROWS_WITH_AS(offset(test::chain({parabolic, Curve({{1}, {0, 1}, {}, {1}}, {1})}), 1),
                       "offset: the path is in no plane z = const, as segment 2 is in none",
                       DomainError);
}

}  // namespace offset_test
