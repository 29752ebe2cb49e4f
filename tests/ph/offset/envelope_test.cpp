#include "phrame/ph/offset/domain_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/offset_trim.hpp"
#include "support/random.hpp"

namespace envelope_test {
namespace {

using namespace phrame;
using test::for_samples;
using test::Random;

/// f·(½(ac + bd), ½(ad − bc), ½(ac − bd)).
Vector<Polynomial> hodograph_of(const Polynomial& f, const std::vector<Polynomial>& abcd) {
  const Rational half(1, 2);
  const Polynomial ac = abcd[0] * abcd[2];
  const Polynomial bd = abcd[1] * abcd[3];
  return {half * f * (ac + bd), half * f * (abcd[0] * abcd[3] - abcd[1] * abcd[2]),
          half * f * (ac - bd)};
}

MinkowskiCurve curve_of(const Vector<Polynomial>& hodograph, const Vector<Rational>& start) {
  return std::get<MinkowskiCurve>(identify_minkowski(hodograph, start));
}

MinkowskiCurve line(const Vector<Rational>& from, const Vector<Rational>& to) {
  return curve_of(as_polynomials(to - from), from);
}

/// One whose σ is not 0.
MinkowskiCurve random_curve(Random& random, long m) {
  for (;;) {
    const std::vector<Polynomial> abcd{random.polynomial(m), random.polynomial(m),
                                       random.polynomial(m), random.polynomial(m)};
    const Polynomial f = random.chance(3) ? random.nonzero_polynomial(2) : Polynomial{1};
    const auto found = hodograph_of(f, abcd);
    if (found == Vector<Polynomial>{}) continue;
    const auto curve =
        identify_minkowski(found, {random.rational(), random.rational(), random.rational()});
    if (const auto* is_one = std::get_if<MinkowskiCurve>(&curve)) return *is_one;
  }
}

/// Of degree 5 at most, small, with radii > 0, that does not turn back. About half are lightlike
/// somewhere.
MinkowskiCurve tame_curve(Random& random) {
  for (;;) {
    std::vector<Polynomial> abcd;
    for (int k = 0; k < 4; ++k)
      abcd.push_back(
          from_bernstein({random.integer(-4, 6), random.integer(-4, 6), random.integer(-4, 6)}));
    const auto found = hodograph_of({1}, abcd);
    if (found == Vector<Polynomial>{}) continue;
    auto curve = identify_minkowski(found, {0, 0, random.integer(1, 8)});
    auto* is_one = std::get_if<MinkowskiCurve>(&curve);
    if (is_one == nullptr) continue;
    const Polynomial radius = position(*is_one)[2];
    if (count_real_roots(radius, closed_interval(0, 1)) == 0 &&
        count_real_roots(is_one->multiplier, closed_interval(0, 1)) == 0)
      return *is_one;
  }
}

double to_double(const Rational& x) { return static_cast<double>(x); }

/// The least of |center − at| − radius, by 500 discs of each segment.
double room(const MedialAxis& axis, const Vector<Rational>& at) {
  double least = 1e300;
  for (const MinkowskiCurve& curve : axis) {
    std::array<std::vector<double>, 3> r;
    const Vector<Polynomial> exact = position(curve);
    for (std::size_t k = 0; k < 3; ++k)
      for (const Rational& c : exact[k].coefficients()) r[k].push_back(to_double(c));
    for (int j = 0; j <= 500; ++j) {
      const auto value = [&](std::size_t k) {
        double x = 0;
        for (std::size_t i = r[k].size(); i-- > 0;) x = x * j / 500 + r[k][i];
        return x;
      };
      least = std::min(
          least, std::hypot(value(0) - to_double(at[0]), value(1) - to_double(at[1])) - value(2));
    }
  }
  return least;
}

double place(const Real& t) { return approximate(t.enclose(64)); }

bool is_left(const DomainBoundary& boundary, std::size_t piece, double t) {
  return std::ranges::any_of(boundary.branches, [&](const TrimmedBranch& branch) {
    return std::ranges::any_of(branch.parts, [&](const OffsetPart& part) {
      const auto [low, high] = std::minmax({place(part.from), place(part.to)});
      return part.piece == piece && low <= t && t <= high;
    });
  });
}

/// ½ ∮ (x dy − y dx) of the polygon through points of a branch.
double area(const DomainBoundary& boundary, const TrimmedBranch& branch) {
  std::vector<std::array<double, 2>> points;
  for (const OffsetPart& part : branch.parts)
    for (long k = 0; k < 60; ++k) {
      const double t = place(part.from) + (place(part.to) - place(part.from)) * double(k) / 60;
      const Vector<Rational> at =
          point(boundary.envelope.pieces[part.piece].curve, exact_rational(t));
      points.push_back({to_double(at[0]), to_double(at[1])});
    }
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& a = points[k];
    const auto& b = points[(k + 1) % points.size()];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("minkowski: law: every f, a, b, c, d is found again, up to what is common to a and b") {
  for_samples(60, [](Random& random) {
    const long m = random.integer(0, 10);
    std::vector<Polynomial> abcd;
    for (int k = 0; k < 4; ++k) abcd.push_back(random.polynomial(m));
    const Polynomial f = random.nonzero_polynomial(3);
    const auto found = hodograph_of(f, abcd);
    if (found == Vector<Polynomial>{} || (abcd[0] * abcd[3] + abcd[1] * abcd[2]).is_zero()) return;
    const MinkowskiCurve curve = curve_of(found, {1, 2, 3});
    const auto again = null_factors(curve);
    CHECK(hodograph_of(curve.multiplier, again) == found);
    CHECK(primitive_part(curve.multiplier) ==
          primitive_part(f * gcd(abcd[0], abcd[1]) * gcd(abcd[2], abcd[3])));
    const auto [x, y, r] = found;
    const Polynomial sigma = curve.multiplier * spacelike_root(curve);
    CHECK(x * x + y * y - r * r == sigma * sigma);
    CHECK(evaluate(position(curve), 0) == Vector<Rational>{1, 2, 3});
    CHECK(differentiate(position(curve)) == found);
  });
}

TEST_CASE("minkowski: what is no square is told") {
  const auto reason = [](const Vector<Polynomial>& hodograph) {
    return to_string(std::get<NotMinkowski>(identify_minkowski(hodograph, {})));
  };
  CHECK(reason({Polynomial{1}, {}, {0, 1}}) ==
        "x'^2 + y'^2 - r'^2 is no square: it is -1*(t^2 - 1) times a square");
  CHECK(reason({Polynomial{0, 3}, {0, 3}, {}}) ==
        "x'^2 + y'^2 - r'^2 is no square: it is 2 times a square");
  CHECK(reason({Polynomial{3}, {4}, {5}}) ==
        "x'^2 + y'^2 - r'^2 is 0: each disc touches the next ones from inside, and there is no "
        "envelope");
  CHECK_THROWS_AS(identify_minkowski({}, {}), DomainError);
}

TEST_CASE("envelope: law: each point is on its disc and touches it") {
  for_samples(40, [](Random& random) {
    const MinkowskiCurve curve = random_curve(random, random.integer(0, 10));
    const Vector<Polynomial> r = position(curve);
    long n = 0;
    for (const Polynomial& x : r) n = std::max(n, x.degree());
    for (const Side side : {Side::right, Side::left}) {
      const auto found = envelope_side(curve, side);
      if (!found) continue;
      const Polynomial& w = found->weight();
      const Polynomial x = found->numerator()[0] - r[0] * w;
      const Polynomial y = found->numerator()[1] - r[1] * w;
      CHECK(x * x + y * y == r[2] * r[2] * w * w);
      CHECK((x * found->direction()[0] + y * found->direction()[1]).is_zero());
      const auto abcd = null_factors(curve);
      const std::size_t first = side == Side::right ? 2 : 0;
      CHECK(degree(*found) <= n + 2 * std::max(abcd[first].degree(), abcd[first + 1].degree()));
      const PlaneDirection normal = envelope_normal(curve, side, Rational(1, 3));
      CHECK(r[2](Rational(1, 3)) * normal.x * w(Rational(1, 3)) == x(Rational(1, 3)));
      const Vector<Rational> h = evaluate(found->direction(), Rational(1, 3));
      CHECK(h[1] * normal.x - h[0] * normal.y > 0);
    }
    // To the right of travel, where that is spacelike.
    const PlaneDirection normal = envelope_normal(curve, Side::right, power_of_ten(-60));
    const Vector<Rational> way = evaluate(direction(curve), power_of_ten(-60));
    CHECK(way[0] * normal.y - way[1] * normal.x < 0);
  });
}

TEST_CASE("envelope: with one radius it is the offsets of a PH curve, trimmed as they are") {
  for_samples(2, [](Random& random) {
    const auto p = [&] {
      return from_bernstein({random.integer(-6, 6), random.integer(-6, 6), random.integer(-6, 6)});
    };
    const Curve ph({p(), {}, {}, p() + Polynomial{0, Rational(1, 7)}});
    const Rational d(random.integer(1, 9), 2);
    const MinkowskiCurve curve = curve_of(hodograph(ph), {0, 0, d});
    CHECK(*envelope_side(curve, Side::right) == offset(ph, d));
    CHECK(envelope_side(curve, Side::left)->numerator() == offset(ph, -d).numerator());
    const DomainBoundary boundary = domain_boundary({curve});
    CHECK(boundary.undecided.empty());
    const TrimmedOffset trimmed = trimmed_offset(ph, d);
    std::vector<double> places;
    std::vector<double> expected;
    for (const TrimmedBranch& branch : trimmed.branches)
      for (const OffsetPart& part : branch.parts)
        expected.insert(expected.end(), {place(part.from), place(part.to)});
    for (const TrimmedBranch& branch : boundary.branches) {
      CHECK(branch.is_closed);
      for (const OffsetPart& part : branch.parts)
        if (boundary.envelope.pieces[part.piece].kind == EnvelopePiece::Kind::right)
          places.insert(places.end(), {place(part.from), place(part.to)});
    }
    std::ranges::sort(places);
    std::ranges::sort(expected);
    REQUIRE(places.size() == expected.size());
    for (std::size_t k = 0; k < places.size(); ++k)
      CHECK(places[k] == doctest::Approx(expected[k]));
  });
}

TEST_CASE("envelope: the medial axis of a rectangle, with branches, bounds the rectangle") {
  const Vector<Rational> a{1, 1, 1};
  const Vector<Rational> b{3, 1, 1};
  const DomainBoundary boundary = domain_boundary(
      {line({0, 0, 0}, a), line({0, 2, 0}, a), line(a, b), line(b, {4, 0, 0}), line(b, {4, 2, 0})});
  CHECK(boundary.undecided.empty());
  REQUIRE(boundary.branches.size() == 1);
  CHECK(boundary.branches[0].is_closed);
  CHECK(area(boundary, boundary.branches[0]) == doctest::Approx(8));
  for (const OffsetPart& part : boundary.branches[0].parts)
    CHECK(degree(boundary.envelope.pieces[part.piece].curve) == 1);
}

TEST_CASE("envelope: discs about a parabola that touch its directrix touch in its focus") {
  // x = 2t − 1, y = x²/2, r = y + 1/2: the focus is (0, 1/2), the directrix y = −1/2.
  const MinkowskiCurve curve = curve_of({Polynomial{2}, {-2, 4}, {-2, 4}}, {-1, Rational(1, 2), 1});
  CHECK(!envelope_side(curve, Side::left));
  const RationalCurve right = *envelope_side(curve, Side::right);
  CHECK(degree(right) == 1);
  CHECK(point(right, 0) == Vector<Rational>{-1, Rational(-1, 2), 0});
  const DomainBoundary boundary = domain_boundary({curve});
  REQUIRE(boundary.branches.size() == 1);
  // Both discs at the ends touch there; below them the line closes 2·1 − ½π.
  const double pi = std::acos(-1.0);
  CHECK(area(boundary, boundary.branches[0]) == doctest::Approx(2 * pi + 2 - pi / 2).epsilon(1e-3));
}

TEST_CASE("envelope: about a corner, and about discs that touch their tips, it is closed") {
  // An L of two strips of the width 2, 15, with a quarter and two halves of the disc.
  const DomainBoundary bent =
      domain_boundary({line({0, 0, 1}, {4, 0, 1}), line({4, 0, 1}, {4, 4, 1})});
  REQUIRE(bent.branches.size() == 1);
  CHECK(area(bent, bent.branches[0]) ==
        doctest::Approx(15 + 5 * std::acos(-1.0) / 4).epsilon(1e-3));
  // On the arc about a corner between curves it is cut where these begin, exactly.
  const MinkowskiCurve leaf = curve_of({Polynomial{3}, {0, 2}, {0, 2}}, {0, 0, 1});
  const Vector<Rational> end = evaluate(position(leaf), 1);
  const DomainBoundary curved = domain_boundary(
      {leaf,
       curve_of(
           {Polynomial{Rational(9, 5), Rational(-8, 5)}, {Rational(12, 5), Rational(6, 5)}, {0, 2}},
           end)});
  CHECK(curved.undecided.empty());
  for (const TrimmedBranch& branch : curved.branches)
    for (const OffsetPart& part : branch.parts)
      if (curved.envelope.pieces[part.piece].kind == EnvelopePiece::Kind::end_cap) {
        CHECK(part.from.exact());
        CHECK(part.to.exact());
      }
  // x′ = (1 + b²)/2, r′ = (1 − b²)/2, b = t − 1: the left tip of the last disc stands still, and
  // all of its circle is the cap.
  const Polynomial b{-1, 1};
  const Rational half(1, 2);
  const DomainBoundary tip = domain_boundary(
      {curve_of({half * (Polynomial{1} + b * b), {}, half * (Polynomial{1} - b * b)}, {0, 0, 1})});
  REQUIRE(tip.branches.size() == 1);
  CHECK(tip.branches[0].is_closed);
  CHECK(area(tip, tip.branches[0]) > std::acos(-1.0) * 16 / 9);  // that of the last disc
}

TEST_CASE("envelope: law: the boundary is what is inside of no disc, with the domain on its left") {
  for_samples(3, [](Random& random) {
    const MedialAxis axis{tame_curve(random)};
    const DomainBoundary boundary = domain_boundary(axis);
    CHECK(boundary.undecided.empty());
    double whole = 0;
    for (const TrimmedBranch& branch : boundary.branches) {
      CHECK(branch.is_closed);
      whole += area(boundary, branch);
    }
    CHECK(whole > 0);
    for (std::size_t k = 0; k < boundary.envelope.pieces.size(); ++k)
      for (long j = 1; j < 12; ++j) {
        const Rational t(2 * j, 25);
        const double gap = room(axis, point(boundary.envelope.pieces[k].curve, t));
        CAPTURE(k);
        CAPTURE(to_double(t));
        if (gap < -1e-3) CHECK(!is_left(boundary, k, to_double(t)));
        if (gap > -1e-12) CHECK(is_left(boundary, k, to_double(t)));
      }
  });
}

TEST_CASE("envelope: what has none is refused") {
  CHECK_THROWS_WITH_AS(envelope({line({0, 0, 2}, {5, 0, -1})}),
                       "envelope: the radius is -1 at t = 1 in segment 1", DomainError);
  CHECK_THROWS_WITH_AS(envelope({line({0, 0, 1}, {3, 0, 1}), line({0, 0, 0}, {3, 0, 0})}),
                       "envelope: the radius is 0 everywhere in segment 2", DomainError);
  CHECK_THROWS_WITH_AS(domain_boundary({curve_of({Polynomial{1, -2}, {}, {}}, {0, 0, 1})}),
                       "domain_boundary: the axis turns back at a cusp, in segment 1 at t = 1/2",
                       DomainError);
}

}  // namespace envelope_test
