#include "phrame/ph/offset/gauge_offset.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/offset_measure.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "support/gauges.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace gauge_offset_test {

using namespace phrame;
using namespace phrame::test;

namespace {

Rational nonzero(Random& random) {
  for (;;)
    if (const Rational d = random.rational(); d != 0) return d;
}

/// c(p, q) for the form of the degree n.
Polynomial form(const Polynomial& c, long n, const Polynomial& p, const Polynomial& q) {
  Polynomial sum;
  for (long k = 0; k <= n; ++k) sum += c.coefficient(k) * pow(p, k) * pow(q, n - k);
  return sum;
}

Path random_gauge(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return oval(Rational(random.integer(-32, 32), 100));
    case 1:
      return oval(Rational(random.integer(-6, 6), 100), 2);
    case 2:
      return unit_circle();
    default:
      return ellipse(random.integer(1, 4), random.integer(-3, 3), 0, random.integer(1, 4));
  }
}

/// r′ = f·H(p, q), of which the offset under the gauge is that by U(p, q).
struct Made {
  RationalCurve curve;
  Polynomial p;
  Polynomial q;
};
Made made_curve(Random& random, const Gauge& gauge) {
  const auto& [hx, hy] = gauge.direction();
  const long e = std::max(hx.degree(), hy.degree());
  for (;;) {
    const Polynomial p = random.polynomial(2);
    const Polynomial q = random.nonzero_polynomial(2);
    const Polynomial f = random.chance(3) ? Polynomial{1, -3} : random.nonzero_polynomial(1);
    const auto across = gcd(p, q);
    if (p.is_zero() || !across.is_constant()) continue;
    return {RationalCurve({antiderivative(f * form(hx, e, p, q)),
                           antiderivative(f * form(hy, e, p, q)),
                           {random.rational()}}),
            p, q};
  }
}

/// Points of both, which are the same.
void check_equal(const Offset& a, const Offset& b) {
  CHECK(a.meets == b.meets);
  CHECK(a.inner_corners == b.inner_corners);
  REQUIRE(a.pieces.size() == b.pieces.size());
  for (std::size_t k = 0; k < a.pieces.size(); ++k) {
    CHECK(a.pieces[k].segment == b.pieces[k].segment);
    CHECK(a.pieces[k].is_join == b.pieces[k].is_join);
    if (a.pieces[k].is_join) {
      for (const long t : {0, 1}) CHECK(point(a.pieces[k].curve, t) == point(b.pieces[k].curve, t));
    } else {
      CHECK(a.pieces[k].curve == b.pieces[k].curve);
    }
  }
}

PhPath random_ph_path(Random& random, long count) {
  const auto next = [&](const Vector<Rational>& start) {
    const auto p = [&] { return from_bernstein({random.integer(-6, 6), random.integer(-6, 6)}); };
    return Curve({p() + Polynomial{Rational(1, 7)}, {}, {}, p()},
                 random.chance(4) ? Polynomial{1, -3} : Polynomial{1}, start);
  };
  PhPath path(next({0, 0, 1}));
  while (static_cast<long>(path.segments().size()) < count) {
    try {
      path.append(next(point(PhSegment(path.segments().back()).by_positions(), 1)));
    } catch (const DomainError&) {  // the tangent turns back
    }
  }
  return path;
}

}  // namespace

TEST_CASE(
    "gauge offset: under the unit circle it is the Euclidean one, with cusps, corners and joins") {
  const Gauge circle(unit_circle());
  long with_corners = 0;
  for_samples(20, [&](Random& random) {
    const PhPath path = random_ph_path(random, random.integer(1, 3));
    const Rational d = nonzero(random);
    const OffsetJoin join = random.chance(2) ? OffsetJoin::round : OffsetJoin::mitre;
    const GaugeOffsets offsets(path, circle);
    CHECK(offsets.none().empty());
    const Offset found = offsets.at(d, join);
    const Offset euclidean = offset(path, d, join);
    if (!path.corners().empty()) ++with_corners;
    if (found.pieces.size() == euclidean.pieces.size()) {  // arcs of 2π/3 or more are cut there
      check_equal(found, euclidean);
      CHECK(paths(found).size() == paths(euclidean).size());
      const auto a = cusps(found);
      const auto b = cusps(euclidean);
      REQUIRE(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k)
        CHECK((a[k].piece == b[k].piece && a[k].t == b[k].t && a[k].turns_back == b[k].turns_back));
    }
    for (const OffsetPiece& piece : found.pieces) {
      if (!piece.is_join || join != OffsetJoin::round) continue;
      const Vector<Rational> at = path.segments()[piece.segment].start();
      const Polynomial& w = piece.curve.weight();
      const Polynomial x = piece.curve.numerator()[0] - at[0] * w;
      const Polynomial y = piece.curve.numerator()[1] - at[1] * w;
      CHECK(x * x + y * y == d * d * w * w);
    }
  });
  CHECK(with_corners > 5);
}

TEST_CASE(
    "gauge offset: law: under a linear image of the circle it is the image of the offset of the "
    "preimage") {
  for_samples(12, [](Random& random) {
    const Rational a = random.integer(1, 4), b = random.integer(-3, 3), c = random.integer(-3, 3);
    const Rational e = random.integer(1, 5);
    const Rational determinant = a * e - b * c;
    if (determinant == 0) return;
    const auto image = [&](const RationalCurve& curve) {
      const Vector<Polynomial> r = curve.numerator();
      return RationalCurve({a * r[0] + b * r[1], c * r[0] + e * r[1], r[2]}, curve.weight());
    };
    const PhPath path = random_ph_path(random, 2);
    std::vector<Segment> segments;
    for (const Curve& curve : path.segments())
      segments.emplace_back(image(PhSegment(curve).by_positions()));
    const Rational d = nonzero(random);
    const GaugeOffsets offsets(joined(segments), Gauge(ellipse(a, b, c, e)));
    CHECK(offsets.none().empty());
    const Offset found = offsets.at(d, OffsetJoin::mitre);
    const Offset flat = offset(path, determinant > 0 ? d : -d, OffsetJoin::mitre);
    REQUIRE(found.pieces.size() == flat.pieces.size());
    CHECK(found.meets == flat.meets);
    for (std::size_t k = 0; k < found.pieces.size(); ++k) {
      const RationalCurve of_flat = image(flat.pieces[k].curve);
      CHECK(found.pieces[k].curve.numerator() == of_flat.numerator());
      CHECK(found.pieces[k].curve.weight() == of_flat.weight());
    }
    CHECK(cusps(found).size() == cusps(flat).size());
  });
}

TEST_CASE(
    "gauge offset: law: r_d - r = d U(phi) with U' along r', to the right for d > 0, and r_d' is "
    "along r'") {
  for_samples(24, [](Random& random) {
    const Gauge gauge(random_gauge(random));
    const Made made = made_curve(random, gauge);
    const RationalCurve& curve = made.curve;
    const Polynomial& p = made.p;
    const Polynomial& q = made.q;
    const Path path{Segment(curve)};
    const GaugeOffsets offsets(path, gauge);
    REQUIRE(offsets.none().empty());
    const Rational d = nonzero(random);
    const Offset found = offsets.at(d);
    if (found.pieces.empty()) return;  // an arc of −d·U
    const RationalCurve& off = found.pieces.front().curve;
    const long n = gauge.degree();
    const Polynomial w = form(gauge.weight(), n, p, q) * off.weight();
    // U(p, q) or −U(p, q), whichever is to the right.
    const auto step = [&](std::size_t k) {
      return off.numerator()[k] * curve.weight() - curve.numerator()[k] * off.weight();
    };
    const auto& [hx, hy, hz] = curve.direction();
    const Rational side = hx(0) * step(1)(0) - hy(0) * step(0)(0);
    CHECK(side * d < 0);
    const Polynomial ux = form(gauge.x(), n, p, q);
    const Polynomial uy = form(gauge.y(), n, p, q);
    const Polynomial uw = form(gauge.weight(), n, p, q);
    const Rational sign = (hx(0) * uy(0) - hy(0) * ux(0)) * uw(0) < 0 ? 1 : -1;
    CHECK(step(0) * uw == sign * d * ux * off.weight() * curve.weight());
    CHECK(step(1) * uw == sign * d * uy * off.weight() * curve.weight());
    CHECK(step(2).is_zero());
    CHECK(off.direction()[0] * hy == off.direction()[1] * hx);
    CHECK(off.direction()[0](0) * hx(0) + off.direction()[1](0) * hy(0) > 0);
    // The speed along H changes its sign where a cusp turns back.
    for (const OffsetCusp& cusp : cusps(found)) CHECK(sign_at(off.multiplier(), cusp.t) == 0);
  });
}

TEST_CASE("gauge offset: of a closed polygon it has the mixed area, A + d L + d^2 a") {
  // A rectangle 4 × 2 under (3cos, 2sin): L = 2·(4·2 + 2·3), the area of the ellipse is 6π.
  const auto line = [](long a, long b, long c, long e) {
    return Segment(bezier_curve({{a, b, 0}, {c, e, 0}}));
  };
  const Path rectangle =
      joined({line(0, 0, 4, 0), line(4, 0, 4, 2), line(4, 2, 0, 2), line(0, 2, 0, 0)});
  const GaugeOffsets offsets(rectangle, Gauge(ellipse(3, 0, 0, 2)));
  const Offset round = offsets.at(Rational(1, 2));
  CHECK(round.pieces.size() == 8);
  CHECK(paths(round).size() == 1);
  const auto area = signed_area(round);
  REQUIRE(area);
  REQUIRE(area->exact);
  CHECK(area->exact->rational == 8 + 14);
  CHECK(area->exact->pi == Rational(6, 4));
  CHECK(signed_area(offsets.at(Rational(1, 2), OffsetJoin::mitre))->exact->rational ==
        (4 + 3) * (2 + 2));
  const Offset inside = offsets.at(Rational(-1, 4));
  CHECK(inside.inner_corners.size() == 4);
  CHECK(self_intersections(inside).found.size() == 4);
  CHECK(offsets.at(1, OffsetJoin::open).pieces.size() == 4);
}

TEST_CASE(
    "gauge offset: a segment without a rational one is left out, with the degrees of the factors") {
  Path path = joined({Segment(bezier_curve({{0, 0, 0}, {4, 0, 0}})),
                      Segment(bezier_curve({{4, 0, 0}, {5, 1, 0}})),
                      Segment(bezier_curve({{5, 1, 0}, {5, 4, 0}}))});
  const GaugeOffsets offsets(path, Gauge(ellipse(3, 0, 0, 2)));
  REQUIRE(offsets.none().size() == 1);
  CHECK(offsets.none()[0].segment == 1);
  CHECK(offsets.none()[0].degrees == std::vector<long>{2});
  const Offset found = offsets.at(1);
  CHECK(found.pieces.size() == 2);
  CHECK(found.meets == std::vector<bool>{false, false});
  CHECK(paths(found).size() == 2);
  const GaugeOffsets none(Path(Segment(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}))),
                          Gauge(oval(Rational(1, 4))));
  REQUIRE(none.none().size() == 1);
  CHECK(none.at(1).pieces.empty());
}

TEST_CASE("gauge offset: what is a point is left out, and what has none is refused") {
  const Path arc = plane_path({1, 0, -1}, {0, 2}, {1, 0, 1});
  const GaugeOffsets offsets(arc, Gauge(unit_circle()));
  CHECK(offsets.at(-1).pieces.empty());
  CHECK(offsets.at(1).pieces.size() == 1);
  CHECK(contains(refusal_of<DomainError>([&] { offsets.at(0); }), "the distance is 0"));
  const auto refused = [](const Path& path) {
    return refusal_of<DomainError>([&] { GaugeOffsets(path, Gauge(unit_circle())); });
  };
  CHECK(
      contains(refused(Path(Segment(bezier_curve({{0, 0, 0}, {1, 0, 1}})))), "no plane z = const"));
}

}  // namespace gauge_offset_test
