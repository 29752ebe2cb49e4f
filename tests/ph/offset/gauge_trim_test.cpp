#include "phrame/ph/offset/gauge_trim.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/gauge_offset.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "support/gauges.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace gauge_trim_test {

using namespace phrame;
using namespace phrame::test;

namespace {

/// A multiplier that changes its sign once or twice, mostly at irrational places, or 1.
Polynomial random_multiplier(Random& random) {
  if (random.chance(3)) return {1};
  return random.chance(2) ? Polynomial{random.integer(1, 5), -random.integer(6, 9)}
                          : Polynomial{1, -random.integer(6, 7), random.integer(6, 7)};
}

PhPath random_ph_path(Random& random, long count) {
  const auto next = [&](const Vector<Rational>& start) {
    const auto p = [&] { return from_bernstein({random.integer(-6, 6), random.integer(-6, 6)}); };
    const Polynomial u = p() + Polynomial{Rational(1, 7)};
    return Curve({u, {}, {}, p()}, random_multiplier(random), start);
  };
  PhPath path(next({0, 0, 0}));
  while (static_cast<long>(path.segments().size()) < count) {
    try {
      path.append(next(point(PhSegment(path.segments().back()).by_positions(), 1)));
    } catch (const DomainError&) {  // the tangent turns back
    }
  }
  return path;
}

bool turns_back(const PhPath& path) {
  return std::ranges::any_of(path.segments(), [](const Curve& curve) {
    return !sign_changes(curve.multiplier()).empty();
  });
}

Path image(const PhPath& path, const Rational& a, const Rational& b, const Rational& c,
           const Rational& e) {
  std::vector<Segment> segments;
  for (const Curve& curve : path.segments()) {
    const RationalCurve r = PhSegment(curve).by_positions();
    const auto& [x, y, z] = r.numerator();
    segments.emplace_back(RationalCurve({a * x + b * y, c * x + e * y, z}, r.weight()));
  }
  return joined(segments);
}

double value(const Real& x) { return round_to_double(x.enclose(200).midpoint()); }

/// |v| in the norm of oval(a), which is |v| = 1/(1 + a cos 2θ) from 0.
double norm(double a, double x, double y) {
  const double square = x * x + y * y;
  return square == 0 ? 0 : (square + a * (x * x - y * y)) / std::sqrt(square);
}

/// That of a point from a path of polynomial curves: the least of some places, and next to it.
double distance(double a, const Path& path, const Vector<Rational>& at) {
  const double x = round_to_double(at[0]);
  const double y = round_to_double(at[1]);
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& segment : path.segments()) {
    const auto& [X, Y, Z] = rational_curve(segment)->numerator();
    const auto from = [&, &X = X, &Y = Y](double t) {
      const auto value = [&](const Polynomial& p) {
        double sum = 0;
        for (long k = p.degree(); k >= 0; --k) sum = sum * t + round_to_double(p.coefficient(k));
        return sum;
      };
      return norm(a, x - value(X), y - value(Y));
    };
    constexpr double step = 0.005;
    double best = 0;
    for (long k = 0; k <= 200; ++k)
      if (from(step * static_cast<double>(k)) < from(best)) best = step * static_cast<double>(k);
    double lower = std::max(0.0, best - step);
    double upper = std::min(1.0, best + step);
    for (long k = 0; k < 60; ++k) {
      const double third = (upper - lower) / 3;
      if (from(lower + third) < from(upper - third))
        upper -= third;
      else
        lower += third;
    }
    least = std::min(least, from(lower));
  }
  return least;
}

}  // namespace

TEST_CASE(
    "gauge trim: law: under a linear image of the circle it is cut where the offset of the "
    "preimage is") {
  long cut = 0;
  long turning = 0;
  for_samples(12, [&](Random& random) {
    const Rational a = random.integer(1, 4), b = random.integer(-3, 3), c = random.integer(-3, 3);
    const Rational e = random.integer(1, 5);
    const Rational determinant = a * e - b * c;
    if (determinant == 0) return;
    const PhPath path = random_ph_path(random, random.integer(1, 2));
    const Rational d(random.integer(1, 20) * (random.chance(2) ? 1 : -1), 4);
    const OffsetJoin join = random.chance(2) ? OffsetJoin::mitre : OffsetJoin::round;
    const TrimmedOffset found =
        trimmed_offset(image(path, a, b, c, e), Gauge(ellipse(a, b, c, e)), d, join);
    const TrimmedOffset flat = trimmed_offset(path, determinant > 0 ? d : Rational(-d), join);
    REQUIRE(found.undecided.empty());
    REQUIRE(found.branches.size() == flat.branches.size());
    if (turns_back(path) && !found.branches.empty()) ++turning;
    for (std::size_t k = 0; k < found.branches.size(); ++k) {
      const TrimmedBranch& one = found.branches[k];
      const TrimmedBranch& other = flat.branches[k];
      CHECK(one.is_closed == other.is_closed);
      const auto ends = [](const TrimmedOffset& of, const TrimmedBranch& branch) {
        std::vector<double> list;
        for (const OffsetPart& part : branch.parts)
          if (!of.offset.pieces[part.piece].is_join) {
            list.push_back(value(part.from));
            list.push_back(value(part.to));
          }
        return list;
      };
      const auto s = ends(found, one);
      const auto t = ends(flat, other);
      REQUIRE(s.size() == t.size());
      for (std::size_t j = 0; j < s.size(); ++j) {
        CHECK(std::abs(s[j] - t[j]) < 1e-14);
        if (s[j] > 0 && s[j] < 1) ++cut;
      }
      // Areas grow by the determinant.
      const auto area = measure(found, one).area;
      if (area)
        CHECK(value(*area) ==
              doctest::Approx(round_to_double(abs(determinant)) * (determinant > 0 ? 1 : -1) *
                              value(*measure(path, flat, other).area)));
    }
  });
  CHECK(cut > 3);
  CHECK(turning > 3);
}

TEST_CASE("gauge trim: law: under the circle all is as without a gauge") {
  long turning = 0;
  for_samples(10, [&](Random& random) {
    const PhPath path = random_ph_path(random, random.integer(1, 2));
    const Rational d(random.integer(1, 20) * (random.chance(2) ? 1 : -1), 4);
    const Gauge circle(unit_circle());
    const SelfIntersections meetings =
        self_intersections(GaugeOffsets(Path(path), circle).at(d, OffsetJoin::round));
    const SelfIntersections expected = self_intersections(offset(path, d));
    CHECK(meetings.is_complete());
    CHECK(meetings.found.size() == expected.found.size());
    const TrimmedOffset found = trimmed_offset(Path(path), circle, d);
    const TrimmedOffset flat = trimmed_offset(path, d);
    CHECK(found.undecided.empty());
    REQUIRE(found.branches.size() == flat.branches.size());
    for (std::size_t k = 0; k < found.branches.size(); ++k) {
      const BranchMeasure one = measure(found, found.branches[k]);
      const BranchMeasure other = measure(path, flat, flat.branches[k]);
      CHECK(std::abs(value(one.length) - value(other.length)) < 1e-12 * value(other.length));
      REQUIRE(one.area.has_value() == other.area.has_value());
      if (one.area) CHECK(std::abs(value(*one.area) - value(*other.area)) < 1e-9);
      if (turns_back(path)) ++turning;
    }
  });
  CHECK(turning > 3);
}

TEST_CASE(
    "gauge trim: under an oval what is left is at the distance |d| of the gauge, and what is cut "
    "away is nearer") {
  long left = 0;
  for_samples(8, [&](Random& random) {
    const Rational a(random.integer(-32, 32), 100);
    const Gauge gauge{oval(a)};
    // r′ = f·H(p), and lines along which U′ is at rational φ.
    const Polynomial p{Rational(random.integer(-2, 2), 4), Rational(random.integer(1, 3), 4)};
    const auto& [hx, hy] = gauge.direction();
    const Polynomial f = random_multiplier(random);
    const bool is_smooth = random.chance(2);
    const auto along_gauge = [&](const Polynomial& h) { return antiderivative(f * compose(h, p)); };
    const Path path =
        is_smooth ? Path(Segment(RationalCurve({along_gauge(hx), along_gauge(hy), {}})))
                  : joined({Segment(bezier_curve({{0, 0, 0}, {4, 0, 0}})),
                            Segment(bezier_curve({{4, 0, 0}, {4, 3, 0}})),
                            Segment(bezier_curve({{4, 3, 0}, {random.integer(-2, 1), 3, 0}}))});
    const Rational d(random.integer(2, 6) * (random.chance(2) ? 1 : -1), 5);
    const TrimmedOffset found = trimmed_offset(path, gauge, d);
    REQUIRE(found.undecided.empty());
    const double reach = round_to_double(abs(d));
    const auto is_left = [&](std::size_t piece, double t) {
      for (const TrimmedBranch& branch : found.branches)
        for (const OffsetPart& part : branch.parts)
          if (part.piece == piece && (value(part.from) <= t) == (t <= value(part.to))) return true;
      return false;
    };
    const auto& pieces = found.offset.pieces;
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (long j = 1; j < 8; ++j) {
        if (is_smooth && abs(f(Rational(j, 8))) < Rational(1, 20)) continue;  // next to a cusp
        const double away =
            distance(round_to_double(a), path, point(pieces[k].curve, Rational(j, 8)));
        CAPTURE(away);
        CHECK((is_left(k, static_cast<double>(j) / 8) ? std::abs(away - reach) < 1e-10
                                                      : away < reach - 1e-10));
      }
    left += static_cast<long>(found.branches.size());
  });
  CHECK(left > 3);
}

TEST_CASE("gauge trim: what is nearer to the end of an open path is cut by half of d U about it") {
  // A hook under the circle, stretched by 2 and 3 with it. Its end is at (2, 1), and the offset of
  // its first line, y = 3/4, is at that distance from it where x = 2 - sqrt(1/2).
  const auto line = [](long x, long y, long to_x, long to_y) {
    return Segment(bezier_curve({{2 * x, 3 * y, 0}, {2 * to_x, 3 * to_y, 0}}));
  };
  const Path hook = joined({line(0, 0, 4, 0), line(4, 0, 4, 1), line(4, 1, 2, 1)});
  const Gauge gauge(ellipse(2, 0, 0, 3));
  const TrimmedOffset found = trimmed_offset(hook, gauge, Rational(-3, 4));
  REQUIRE(found.undecided.empty());
  REQUIRE(found.branches.size() == 1);
  const std::vector<OffsetPart>& parts = found.branches[0].parts;
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].from.exact() == Rational(0));
  CHECK(std::abs(value(parts[0].to) - (2 - std::sqrt(0.5)) / 4) < 1e-15);
}

TEST_CASE("gauge trim: branches are by the places where they start, closed ones, too") {
  const Polynomial u = from_bernstein({-4, -3, 5});
  const Polynomial q = from_bernstein({4, 2, Rational(8, 7)});
  const PhPath path(Curve({u, {}, {}, q}, from_bernstein({3, -4, -2})));
  const TrimmedOffset found = trimmed_offset(Path(path), Gauge(unit_circle()), Rational(-1, 2));
  REQUIRE(found.branches.size() == 3);
  CHECK(found.branches[1].is_closed);
  const auto start = [&](std::size_t k) { return value(found.branches[k].parts.front().from); };
  CHECK(start(0) < start(1));
  CHECK(start(1) < start(2));
}

// What is left of the offset of a line that goes to and fro is as long as all of the line, whatever
// the gauge: x = 2t - 6t^2 + 4t^3 is 0 at both ends, and +-sqrt(3)/9 where it turns back.
TEST_CASE("gauge trim: of a line that turns back what is left is that of all its points") {
  const Path line = plane_path({0, 2, -6, 4}, {}, {1});
  for (const Path& unit : {oval(Rational(1, 4)), oval(Rational(1, 20), 2), ellipse(2, 0, 0, 3)})
    for (const Rational& d : {Rational(1, 3), Rational(-20)}) {
      const TrimmedOffset found = trimmed_offset(line, Gauge(unit), d);
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == 1);
      const double length = value(measure(found, found.branches[0]).length);
      CHECK(std::abs(length - 2 * std::sqrt(3.0) / 9) < 1e-14);
    }
}

// A room of 4 by 3 with a wall from (4, 3) to (0, 3) that turns back at x = 2 -+ 4.66, under the
// circle stretched by 2 and 3: at 1/3 the walls are 2/3 and 1 away, and left of the wall beyond
// the corners is all that is 2/3 away from them.
TEST_CASE("gauge trim: a room with a wall that goes to and fro") {
  const auto wall = [](const Polynomial& x) {
    return Segment(RationalCurve({x, Polynomial{3}, {}}));
  };
  const Path room = joined(
      {Segment(bezier_curve({{0, 0, 0}, {4, 0, 0}})), Segment(bezier_curve({{4, 0, 0}, {4, 3, 0}})),
       wall({4, -64, 180, -120}), Segment(bezier_curve({{0, 3, 0}, {0, 0, 0}}))});
  const TrimmedOffset found = trimmed_offset(room, Gauge(ellipse(2, 0, 0, 3)), Rational(-1, 3));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 3);
  const double t = (360 - std::sqrt(37440)) / 720;  // where x' = -64 + 360t - 360t^2 is 0
  const double beyond = -(4 - 64 * t + 180 * t * t - 120 * t * t * t) - 2.0 / 3;
  for (const TrimmedBranch& branch : found.branches) {
    const BranchMeasure size = measure(found, branch);
    const double length = branch.is_closed ? 2 * (8.0 / 3 + 1) : beyond;
    CHECK(std::abs(value(size.length) - length) < 1e-12);
    if (branch.is_closed) CHECK(std::abs(value(*size.area) - 8.0 / 3) < 1e-12);
  }
}

TEST_CASE("gauge trim: what is refused is named") {
  const Gauge gauge(ellipse(1, 0, 0, 2));
  const auto refusal = [&](const std::vector<Segment>& segments) {
    return refusal_of<DomainError>([&] { trimmed_offset(joined(segments), gauge, 1); });
  };
  const Segment line = bezier_curve({{0, 0, 0}, {1, 0, 0}});
  CHECK(refusal({line, bezier_curve({{1, 0, 0}, {2, 0, 0}, {3, 1, 0}})}) ==
        "trimmed_offset: segment 2 has no rational offset under this gauge, so that what is left "
        "is not known");
}

}  // namespace gauge_trim_test
