#include "phrame/ph/offset/trim_measure.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/disc_cover.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"
#include "support/trim_proof.hpp"

namespace offset_trim_test {
namespace {

using namespace phrame;
using test::for_samples;
using test::Random;
using Point = std::complex<double>;

using Doubles = std::vector<double>;

Doubles doubles(const Polynomial& p) {
  Doubles list;
  for (const Rational& c : p.coefficients()) list.push_back(static_cast<double>(c));
  return list;
}
double value(const Doubles& p, double t) {
  double x = 0;
  for (std::size_t k = p.size(); k > 0; --k) x = x * t + p[k - 1];
  return x;
}

/// The distance from a path, by 200 points of each segment and a search around the nearest ones.
class Foreign {
 public:
  explicit Foreign(const PhPath& path) {
    for (const Curve& curve : path.segments()) {
      const Vector<Polynomial> r = position(curve);
      curves_.push_back({doubles(r[0]), doubles(r[1])});
      auto& points = points_.emplace_back();
      for (long k = 0; k <= count; ++k) points.push_back(at(curves_.back(), double(k) / count));
    }
  }

  /// The nearest point.
  struct Foot {
    double distance = 1e300;
    std::size_t segment = 0;
    double t = 0;
  };

  double distance(Point from) const { return foot(from).distance; }

  Foot foot(Point from) const {
    Foot least;
    for (std::size_t j = 0; j < curves_.size(); ++j) {
      const auto size = [&](double t) { return std::abs(at(curves_[j], t) - from); };
      for (long k = 0; k <= count; ++k) {
        const auto here = std::abs(points_[j][std::size_t(k)] - from);
        if (k > 0 && std::abs(points_[j][std::size_t(k - 1)] - from) < here) continue;
        if (k < count && std::abs(points_[j][std::size_t(k + 1)] - from) < here) continue;
        double a = std::max(0.0, double(k - 1) / count);
        double b = std::min(1.0, double(k + 1) / count);
        for (int step = 0; step < 40; ++step) {
          const double p = a + (b - a) * 0.4;
          const double q = a + (b - a) * 0.6;
          (size(p) < size(q) ? b : a) = size(p) < size(q) ? q : p;
        }
        for (const double t : {double(k) / count, (a + b) / 2})
          if (size(t) < least.distance) least = {size(t), j, t};
      }
    }
    return least;
  }

  Point point(std::size_t segment, double t) const { return at(curves_[segment], t); }
  /// Of length 1.
  Point right_normal(std::size_t segment, double t) const {
    const double a = std::max(0.0, t - 1e-5);
    const double b = std::min(1.0, t + 1e-5);
    const Point way = point(segment, b) - point(segment, a);
    return Point(0, -1) * way / std::abs(way);
  }

 private:
  static constexpr long count = 200;
  using Plane = std::array<Doubles, 2>;
  static Point at(const Plane& r, double t) { return {value(r[0], t), value(r[1], t)}; }

  std::vector<Plane> curves_;
  std::vector<std::vector<Point>> points_;
};

double approximate(const Real& x) { return phrame::approximate(x.enclose(64)); }

/// The same by fractions: next to a near-cusp doubles have no digit right.
Point at(const RationalCurve& curve, const Rational& t) {
  const Vector<Rational> exact = point(curve, t);
  return {static_cast<double>(exact[0]), static_cast<double>(exact[1])};
}
Point at(const RationalCurve& curve, const Real& t) { return at(curve, t.enclose(256).midpoint()); }

/// Points of a part from `last` on, more of them where it bends: next to near-cusps it turns within
/// parameters that doubles do not tell from each other.
void add_points(std::vector<Point>& points, const RationalCurve& curve, const Rational& from,
                const Rational& to, int depth = 0) {
  const Point end = at(curve, to);
  const Point middle = at(curve, Rational((from + to) / 2));
  const Point start = points.back();
  const double chord = std::abs(end - start);
  const bool is_straight = std::abs(middle - (start + end) / 2.0) < 5e-3 * chord;
  if (depth >= 6 && (is_straight || chord < 1e-9 || depth == 60)) {
    points.push_back(end);
    return;
  }
  add_points(points, curve, from, (from + to) / 2, depth + 1);
  add_points(points, curve, (from + to) / 2, to, depth + 1);
}
std::vector<Point> polygon(const RationalCurve& curve, const Real& from, const Real& to) {
  const Rational start = from.enclose(256).midpoint();
  std::vector<Point> points{at(curve, start)};
  add_points(points, curve, start, to.enclose(256).midpoint());
  return points;
}

/// One that does not turn back. Some nearly do: they turn within 10⁻³ to 10⁻⁷ of their parameter.
Curve tame_curve(Random& random) {
  for (;;) {
    const auto p = [&] {
      return from_bernstein({random.integer(-6, 6), random.integer(-6, 6), random.integer(-6, 6)});
    };
    Polynomial u = p();
    Polynomial q = p() + Polynomial{0, Rational(1, 7)};
    if (random.chance(4)) {
      const Rational cusp(random.integer(1, 9), 10);
      u = u - Polynomial{u(cusp)};
      q = q - Polynomial{q(cusp) + power_of_ten(-random.integer(3, 7))};
    }
    Curve curve({u, {}, {}, q});
    if (odd_inside(cusps(curve)).empty()) return curve;
  }
}

Curve line_between(const Vector<Rational>& from, const Vector<Rational>& to) {
  const Vector<Rational> way = to - from;
  return std::get<Curve>(identify({Polynomial{way[0]}, Polynomial{way[1]}, {}}, from));
}

void append_lines(PhPath& path, const std::vector<Vector<Rational>>& points) {
  for (const Vector<Rational>& to : points)
    path.append(line_between(end_point(path.segments().back()), to));
}

PhPath lines(std::vector<Vector<Rational>> points) {
  PhPath path(line_between(points[0], points[1]));
  append_lines(path, {points.begin() + 2, points.end()});
  return path;
}

/// The curve with another w, that of `last` at its end, so that it goes on there without a corner.
Curve smooth_behind(const Curve& last, const Curve& next) {
  QuaternionPolynomial w = next.preimage();
  const Polynomial start = pow(Polynomial{1, -1}, 2);
  w.u += (last.preimage().u(1) - w.u(0)) * start;
  w.q += (last.preimage().q(1) - w.q(0)) * start;
  return Curve(w);
}

/// Of some curves, closed by a half-turn or quarters where that is asked for; about half of their
/// joints are smooth.
PhPath random_path(Random& random, long turns) {
  for (;;) try {
      std::vector<Curve> curves;
      for (long k = random.integer(1, 3); k > 0; --k) {
        Curve next = tame_curve(random);
        if (!curves.empty() && random.chance(2)) next = smooth_behind(curves.back(), next);
        if (odd_inside(cusps(next)).empty()) curves.push_back(std::move(next));
      }
      const std::size_t count = curves.size();
      const RationalQuaternion turn =
          turns == 4 ? RationalQuaternion{1, 0, 0, 1} : RationalQuaternion{0, 0, 0, 1};
      while (curves.size() < count * static_cast<std::size_t>(turns))
        curves.push_back(scaled(rotated(curves[curves.size() - count], turn),
                                turns == 4 ? Rational(1, 2) : Rational(1)));
      PhPath path = test::chain(curves);
      if (turns == 1 || path.closing_turn()) return path;
    } catch (const DomainError&) {  // the tangent turns back
    }
}

/// Every point of the branches is at the distance |d|, and every other one of the offset nearer.
void check_trimmed(const PhPath& path, const TrimmedOffset& found) {
  const Foreign foreign(path);
  const double d = std::abs(static_cast<double>(found.offset.distance));
  std::vector<std::vector<std::pair<double, double>>> left(found.offset.pieces.size());
  for (const TrimmedBranch& branch : found.branches) {
    for (std::size_t k = 0; k < branch.parts.size(); ++k) {
      const auto& [piece, from, to] = branch.parts[k];
      const RationalCurve& curve = found.offset.pieces[piece].curve;
      left[piece].emplace_back(std::minmax({approximate(from), approximate(to)}));
      CHECK(approximate(to + -from) != 0);
      if (k + 1 == branch.parts.size() && !branch.is_closed) continue;
      const OffsetPart& next = branch.parts[(k + 1) % branch.parts.size()];
      const Point gap = at(curve, to) - at(found.offset.pieces[next.piece].curve, next.from);
      CHECK(std::abs(gap) < 1e-7 * (1 + d));
    }
  }
  constexpr long samples = 12;
  for (std::size_t k = 0; k < left.size(); ++k)
    for (long j = 0; j < samples; ++j) {
      const double t = (double(j) + 0.37) / samples;
      const bool is_left = std::ranges::any_of(
          left[k], [&](const auto& part) { return part.first < t && t < part.second; });
      const bool is_near_cut = std::ranges::any_of(left[k], [&](const auto& part) {
        return std::min(std::abs(part.first - t), std::abs(part.second - t)) < 1e-5;
      });
      const double distance =
          foreign.distance(at(found.offset.pieces[k].curve, Real(exact_rational(t))));
      CAPTURE(k);
      CAPTURE(t);
      CAPTURE(distance);
      if (is_left) CHECK(std::abs(distance - d) < 1e-8 * (1 + d));
      if (!is_left && !is_near_cut) CHECK(distance < d * (1 - 1e-12) + 1e-14);
    }
}

double distance_from_chord(Point from, Point a, Point b) {
  const double t = ((from - a) * std::conj(b - a)).real() / std::norm(b - a);
  return std::abs(from - a - std::clamp(t, 0.0, 1.0) * (b - a));
}

/// Nothing is missing: where a line crosses the places at the distance |d| on that side of the
/// path, there is a branch. How many places were looked at.
long check_nothing_missing(Random& random, const PhPath& path, const TrimmedOffset& found) {
  const Foreign foreign(path);
  const auto signed_d = static_cast<double>(found.offset.distance);
  const double d = std::abs(signed_d);
  const std::size_t count = path.segments().size();
  std::vector<std::vector<Point>> lines;
  for (const TrimmedBranch& branch : found.branches)
    for (const auto& [piece, from, to] : branch.parts)
      lines.push_back(polygon(found.offset.pieces[piece].curve, from, to));
  const auto away = [&] {
    return std::polar(d * double(random.integer(1, 300)) / 100,
                      double(random.integer(0, 628)) / 100);
  };
  long places = 0;
  for (int k = 0; k < 24; ++k) {
    const auto segment = static_cast<std::size_t>(random.integer(0, static_cast<long>(count) - 1));
    Point a = foreign.point(segment, double(random.integer(0, 1000)) / 1000) + away();
    Point b = a + away();
    if (foreign.distance(a) > d) std::swap(a, b);
    if (foreign.distance(a) > d || foreign.distance(b) < d) continue;
    for (int step = 0; step < 45; ++step)
      (foreign.distance((a + b) / 2.0) < d ? a : b) = (a + b) / 2.0;
    const Foreign::Foot foot = foreign.foot(a);
    Point normal = foreign.right_normal(foot.segment, foot.t);
    const bool is_start = foot.t < 1e-5;
    if (is_start || foot.t > 1 - 1e-5) {
      const std::size_t last = count - 1;
      if (!path.closing_turn() && foot.segment == (is_start ? 0 : last)) continue;  // a cap
      normal +=
          foreign.right_normal((foot.segment + (is_start ? last : 1)) % count, is_start ? 1 : 0);
    }
    const double side = ((a - foreign.point(foot.segment, foot.t)) * std::conj(normal)).real();
    if (side * signed_d < 0) continue;
    ++places;
    const bool is_there = std::ranges::any_of(lines, [&](const std::vector<Point>& line) {
      for (std::size_t j = 1; j < line.size(); ++j)
        if (distance_from_chord(a, line[j - 1], line[j]) <
            0.01 * std::abs(line[j] - line[j - 1]) + 1e-7 * (1 + d))
          return true;
      return false;
    });
    CAPTURE(a.real());
    CAPTURE(a.imag());
    CAPTURE(foot.segment);
    CAPTURE(foot.t);
    CHECK(is_there);
  }
  return places;
}

}  // namespace

TEST_CASE("offset_trim: law: what is left is at the distance |d|, and nothing else is") {
  long branches = 0;
  long parts = 0;
  long pairs = 0;
  long open = 0;
  long places = 0;
  long samples = 0;
  long undecided = 0;
  for_samples(2, [&](Random& random) {
    const std::array<long, 3> turns{1, 2, 4};
    const PhPath path = random_path(random, turns[std::size_t(random.integer(0, 2))]);
    const Rational d = Rational(random.integer(0, 1) == 0 ? -1 : 1) *
                       Rational(random.integer(1, 10)) * power_of_ten(random.integer(-2, 1));
    const TrimmedOffset found = trimmed_offset(path, d);
    CAPTURE(d);
    CAPTURE(path.segments().size());
    check_trimmed(path, found);
    places += check_nothing_missing(random, path, found);
    const test::TrimProof proof = test::prove_distance(path, found);
    for (const std::string& what : proof.wrong) FAIL_CHECK(what);
    parts += proof.parts;
    pairs += proof.pairs;
    for (const std::string& what : proof.open) MESSAGE("not proved: ", what);
    open += static_cast<long>(proof.open.size());
    branches += static_cast<long>(found.branches.size());
    ++samples;
    if (!found.undecided.empty()) ++undecided;
  });
  CHECK(branches >= 4);
  // Next to near-cusps a place may stay undecided, which is said.
  CHECK(10 * undecided <= samples);
  // Next to near-cusps 40 000 boxes may not do.
  CHECK(1000 * open <= pairs);
  if (test::multiplier() > 1)
    MESSAGE(samples, " paths, ", branches, " branches, ", parts, " parts, ", pairs, " pairs, ",
            open, " not proved, ", places, " places on lines, ", undecided,
            " paths with undecided places");
}

TEST_CASE("offset_trim: the proof of distances sees what is not cut, and a cut that is late") {
  const PhPath path(
      Curve({from_bernstein({-4, 6, -6}), {}, {}, from_bernstein({1, Rational(15, 14), -6})}));
  TrimmedOffset found = trimmed_offset(path, Rational(33, 25));
  REQUIRE(found.branches.size() == 1);
  CHECK(test::prove_distance(path, found).wrong.empty());
  CHECK(test::prove_distance(path, found).open.empty());
  OffsetPart& part = found.branches.front().parts.front();
  const Real start = part.from;
  part.from = start + Real(Rational(-1, 10'000));
  CHECK(test::prove_distance(path, found).wrong.size() == 1);
  part.from = Rational(0);
  CHECK(test::prove_distance(path, found).wrong.size() == 1);
  part.from = start;
  found.offset.distance = Rational(133, 100);
  CHECK(test::prove_distance(path, found).wrong.size() >= 2);
}

TEST_CASE("offset_trim: a triangle of sides 3, 4, 5: lengths, areas, and nothing at its incircle") {
  const PhPath triangle = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 0, 0}});
  // Similar to it, with the inradius 1 - d.
  for (const Rational& d : {Rational(1, 3), Rational(1, 2), Rational(99, 100)}) {
    const TrimmedOffset found = trimmed_offset(triangle, -d);
    REQUIRE(found.branches.size() == 1);
    CHECK(found.branches[0].is_closed);
    CHECK(found.undecided.empty());
    const BranchMeasure size = measure(triangle, found, found.branches[0]);
    CHECK(size.length.exact() == 12 * (1 - d));
    CHECK(size.area->exact() == 6 * (1 - d) * (1 - d));
    const std::vector<Path> path = paths(found, found.branches[0], 10);
    REQUIRE(path.size() == 1);
    CHECK(path[0].is_closed());
    CHECK(path[0].is_ph());
  }
  CHECK(trimmed_offset(triangle, -1).branches.empty());
  CHECK(trimmed_offset(triangle, -2).branches.empty());
  const TrimmedOffset outside = trimmed_offset(triangle, 2);
  REQUIRE(outside.branches.size() == 1);
  const BranchMeasure size = measure(triangle, outside, outside.branches[0]);
  CHECK(round_to_decimal(size.length, 15).value == "24.5663706143592");  // 12 + 4 pi
  CHECK(round_to_decimal(*size.area, 15).value == "42.5663706143592");   // 6 + 24 + 4 pi
  CHECK(trimmed_offset(triangle, 2, OffsetJoin::open).branches.size() == 3);
}

// Outside the length is 12 + 2 pi d, inside 12 (1 - d), the area 6 (1 - d)^2; a line with caps
// keeps its length, and of w = 1 + it, which turns by pi/2, that is 4/3 + d pi/2.
TEST_CASE("offset_trim: distances that are less than all that doubles tell of the path") {
  const PhPath triangle = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 0, 0}});
  const PhPath corner = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}});
  const PhPath cubic(Curve({{1}, {}, {}, {0, 1}}));
  for (const long digits : {8, 20, 50, 200}) {
    CAPTURE(digits);
    const Rational d = power_of_ten(-digits);
    const auto only = [&](const PhPath& path, const Rational& distance) {
      const TrimmedOffset found = trimmed_offset(path, distance);
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == 1);
      return measure(path, found, found.branches[0]);
    };
    CHECK(only(triangle, -d).length.exact() == 12 * (1 - d));
    CHECK(only(triangle, -d).area->exact() == 6 * (1 - d) * (1 - d));
    CHECK(only(corner, -d).length.exact() == 7 - 2 * d);
    const auto is_longer_by = [&](const BranchMeasure& size, const Rational& length,
                                  const Real& by) {
      const RealBall more = (size.length + Real(Rational(-length))).enclose(4 * digits + 64);
      return more.overlaps((Real(d) * by).enclose(4 * digits + 64)) && more.accuracy_bits() > 30;
    };
    const Real pi(Real::Enclosure([](long bits) { return phrame::pi(bits); }));
    CHECK(is_longer_by(only(triangle, d), 12, Real(2) * pi));
    CHECK(is_longer_by(only(corner, d), 7, Real(Rational(1, 2)) * pi));
    CHECK(is_longer_by(only(cubic, d), Rational(4, 3), Real(Rational(1, 2)) * pi));
    CHECK(is_longer_by(only(cubic, -d), Rational(4, 3), Real(Rational(-1, 2)) * pi));
  }
}

// r' = (t - 1/3)w^2, |w|^2 = 5 + 5t^2, turns back at t = 1/3, from where on it is next to itself:
// its parts are 275/972 and 440/243 long. Where it is 2d wide, it is some d^(2/3) away from there.
TEST_CASE(
    "offset_trim: distances that are less than all that doubles tell of a path that turns back") {
  const PhPath path(
      Curve({Polynomial{1, 2}, {}, {}, Polynomial{2, -1}}, Polynomial{Rational(-1, 3), 1}));
  for (const long digits : {3, 9, 30}) {
    CAPTURE(digits);
    const Rational d = power_of_ten(-digits);
    const TrimmedOffset found = trimmed_offset(path, d);
    CHECK(found.undecided.empty());
    REQUIRE(found.branches.size() == 2);
    std::vector<double> lengths;
    for (const TrimmedBranch& branch : found.branches)
      lengths.push_back(approximate(measure(path, found, branch).length));
    std::ranges::sort(lengths);
    const double nearly = 4 * std::pow(10, -2.0 * static_cast<double>(digits) / 3);
    CHECK(std::abs(lengths[0] - 275.0 / 972) < nearly + 1e-15);
    CHECK(std::abs(lengths[1] - 440.0 / 243) < nearly + 1e-15);
  }
}

// With w = 1/2 + ib, b = u + u^13/4, u = 2t - 1, the offset has x = x(1/2) + (G(u) + d)b/(1/4 +
// b^2), and G is greatest where findroot() of mpmath has a zero of G'. There both halves nearly
// touch on the axis, and their resultant would be too long.
TEST_CASE("offset_trim: of degree 53, halves of a mirrored curve that nearly touch") {
  const Polynomial u{-1, 2};
  const Polynomial square = u * u;
  const Polynomial fourth = square * square;
  const Polynomial b = u * (Polynomial{1} + Rational(1, 4) * fourth * fourth * fourth);
  const PhPath path(Curve({{Rational(1, 2)}, {}, {}, b}));
  const Rational greatest =
      parse_rational("0.0416661582643920533562213145749516090841734378155836");
  for (const bool is_less : {false, true}) {
    const Rational gap = (is_less ? -1 : 1) * power_of_ten(-25);
    const TrimmedOffset found = trimmed_offset(path, -greatest - gap);
    CHECK(found.undecided.empty());
    CHECK(found.branches.size() == (is_less ? 3 : 2));
  }
}

// Mitred outside, a triangle with the inradius 1 becomes a similar one with the inradius 1 + d.
TEST_CASE("offset_trim: mitres: similar triangles, rectangles, and rooms that are shut") {
  const PhPath triangle = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 0, 0}});
  for (const Rational& d : {Rational(1, 3), Rational(2)}) {
    const TrimmedOffset found = trimmed_offset(triangle, d, OffsetJoin::mitre);
    REQUIRE(found.branches.size() == 1);
    CHECK(found.branches[0].is_closed);
    const BranchMeasure size = measure(triangle, found, found.branches[0]);
    CHECK(size.length.exact() == 12 * (1 + d));
    CHECK(size.area->exact() == 6 * (1 + d) * (1 + d));
    CHECK(paths(found, found.branches[0], 10).front().is_closed());
  }
  // Two rooms of 10 by 10 and a neck of 2·half: inside by 1 the mitres are those of two squares.
  for (const Rational& half : {Rational(9, 10), 1 - power_of_ten(-30), Rational(3, 2)}) {
    CAPTURE(half);
    const Rational low = 5 - half;
    const Rational high = 5 + half;
    const PhPath rooms = lines({{0, 0, 0},
                                {10, 0, 0},
                                {10, low, 0},
                                {14, low, 0},
                                {14, 0, 0},
                                {24, 0, 0},
                                {24, 10, 0},
                                {14, 10, 0},
                                {14, high, 0},
                                {10, high, 0},
                                {10, 10, 0},
                                {0, 10, 0},
                                {0, 0, 0}});
    const TrimmedOffset found = trimmed_offset(rooms, -1, OffsetJoin::mitre);
    CHECK(found.undecided.empty());
    CHECK(found.branches.size() == (half < 1 ? 2 : 1));
    for (const TrimmedBranch& branch : found.branches) {
      CHECK(branch.is_closed);
      const BranchMeasure size = measure(rooms, found, branch);
      // 8 by 8, and from room to room 6 by 2·half − 2.
      CHECK(size.area->exact() == (half < 1 ? Rational(64) : 128 + 6 * (2 * half - 2)));
      CHECK(size.length.exact() == (half < 1 ? Rational(32) : 64 + 12 - 2 * (2 * half - 2)));
    }
  }
  // A bar that ends in front of the flank of a mitre, and cuts it: the area between.
  const PhPath bars = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {7, 3, 0}, {7, -24, 0}, {0, 0, 0}});
  for (const Rational& d : {Rational(1, 2), Rational(-1, 2), Rational(-3, 2), Rational(3)}) {
    const TrimmedOffset found = trimmed_offset(bars, d, OffsetJoin::mitre);
    CHECK(found.undecided.empty());
    for (const TrimmedBranch& branch : found.branches) CHECK(branch.is_closed);
  }
}

TEST_CASE("offset_trim: two rooms behind a neck become islands, decided to 10^-30 of its width") {
  // The neck is 2 wide: rooms of 10 by 10 on both sides of 4 of it.
  const auto dumbbell = [](const Rational& half) {
    return lines({{0, 0, 0},
                  {10, 0, 0},
                  {10, 5 - half, 0},
                  {14, 5 - half, 0},
                  {14, 0, 0},
                  {24, 0, 0},
                  {24, 10, 0},
                  {14, 10, 0},
                  {14, 5 + half, 0},
                  {10, 5 + half, 0},
                  {10, 10, 0},
                  {0, 10, 0},
                  {0, 0, 0}});
  };
  const Rational little = power_of_ten(-30);
  CHECK(trimmed_offset(dumbbell(1 + little), -1).branches.size() == 1);
  const PhPath narrow = dumbbell(1 - little);
  const TrimmedOffset islands = trimmed_offset(narrow, -1);
  REQUIRE(islands.branches.size() == 2);
  CHECK(islands.undecided.empty());
  for (const TrimmedBranch& island : islands.branches) {
    CHECK(island.is_closed);
    // 8 by 8, and a bay up to the neck: within 1 of it the corners keep it off.
    const BranchMeasure size = measure(narrow, islands, island);
    CHECK(approximate(*size.area) > 64);
    CHECK(approximate(*size.area) < 65);
  }
  // Of that width it coincides with itself there, and both branches are left.
  const TrimmedOffset exact = trimmed_offset(dumbbell(1), -1);
  CHECK(exact.undecided.empty());
  Real area = Rational(0);
  for (const TrimmedBranch& branch : exact.branches)
    area = area + *measure(dumbbell(1), exact, branch).area;
  CHECK(approximate(area) > 128);
}

// From (0, 0) to (5, 0) with x = 3t + 2t^3, round a rectangle to (-3, 0), on to (7, 0) with x =
// 8t + 2t^2 - 3, round a greater one to (-5, 0), and on to (3, 0) with x = 5t + 3t^3 - 5: lines go
// along each other up to irrational parameters.
TEST_CASE("offset_trim: of lines that are gone along twice in different manners one is left") {
  const auto line = [](const Rational& from, const Polynomial& rate) {
    return Curve({{1}, {}, {}, {}}, rate, {from, 0, 0});
  };
  PhPath path(line(0, {3, 0, 6}));
  append_lines(path, {{5, 4, 0}, {-3, 4, 0}, {-3, 0, 0}});
  path.append(line(-3, {8, 4}));
  append_lines(path, {{7, 6, 0}, {-5, 6, 0}, {-5, 0, 0}});
  path.append(line(-5, {5, 0, 9}));
  const Rational d(1, 2);
  const auto check = [&](const Rational& distance, const std::vector<double>& lengths,
                         double area) {
    const TrimmedOffset found = trimmed_offset(path, distance);
    CHECK(found.undecided.empty());
    REQUIRE(found.branches.size() == lengths.size());
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const BranchMeasure size = measure(path, found, found.branches[k]);
      CHECK(std::abs(approximate(size.length) - lengths[k]) < 1e-12);
      CHECK(found.branches[k].is_closed == (k == 0));
      if (k == 0) CHECK(std::abs(approximate(*size.area) - area) < 1e-12);
    }
  };
  // Around all, 12 by 6 with round corners; and around the lesser one, above the line.
  check(d, {36 + std::numbers::pi, 15 + std::numbers::pi / 2}, 90 + std::numbers::pi / 4);
  // Inside of the lesser one, and between both.
  check(-d, {20, 23}, 21);
}

// As above, and then across: the way to (-1/2, 3) has its offset on x = 0, so that it meets the
// end of what coincides, at t = (sqrt 15 - 3)/2 of the fifth piece, and of the first one at t = 0.
TEST_CASE("offset_trim: a crossing at the irrational end of what coincides") {
  const auto line = [](const Rational& from, const Polynomial& rate) {
    return Curve({{1}, {}, {}, {}}, rate, {from, 0, 0});
  };
  PhPath path(line(0, {3, 0, 6}));
  append_lines(path, {{5, 4, 0}, {-3, 4, 0}, {-3, 0, 0}});
  path.append(line(-3, {6, 4}));
  append_lines(path, {{5, -3, 0}, {Rational(-1, 2), -3, 0}, {Rational(-1, 2), 3, 0}});
  const TrimmedOffset found = trimmed_offset(path, Rational(1, 2));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 3);
  CHECK(found.branches[0].is_closed);
  const BranchMeasure room = measure(path, found, found.branches[0]);
  CHECK(std::abs(approximate(room.length) - 13) < 1e-12);
  CHECK(std::abs(approximate(*room.area) + 9) < 1e-12);
}

// A slot of the width 1/2 along a curve, closed by lines at both ends: in its middle both sides
// coincide, and each line crosses both of them in one point, which is irrational.
TEST_CASE("offset_trim: both sides of a slot coincide and are crossed in one point") {
  const Curve side({{1}, {}, {}, {0, 1}});
  const Curve other = reversed(std::get<Curve>(identify(offset(side, Rational(-1, 2)))));
  PhPath path(side);
  append_lines(path, {other.start()});
  path.append(other);
  append_lines(path, {side.start()});
  const TrimmedOffset found = trimmed_offset(path, Rational(-1, 4));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 1);
  CHECK(found.branches[0].is_closed);
  const BranchMeasure both = measure(path, found, found.branches[0]);
  CHECK(std::abs(approximate(*both.area)) < 1e-15);
  // From x = t - t^3/3 - t/(2 + 2t^2) = 1/4 to y = t^2 + (1 - t^2)/(4 + 4t^2) = 3/4, where t^4 =
  // 1/2, there and back; s = t + t^3/3, and the tangent turns by 2 arctan t.
  double from = 0;
  for (double to = 1; to - from > 1e-16;) {
    const double t = (from + to) / 2;
    if (t == from || t == to) break;
    (t - t * t * t / 3 - t / (2 + 2 * t * t) < 0.25 ? from : to) = t;
  }
  const auto length = [](double t) { return t + t * t * t / 3 - std::atan(t) / 2; };
  CHECK(std::abs(approximate(both.length) - 2 * (length(std::pow(0.5, 0.25)) - length(from))) <
        1e-14);
}

// Gone along to (5, 0), and back from (7, 0) to (-2, 0).
TEST_CASE("offset_trim: of a line that is gone along there and back both sides are left") {
  PhPath path(Curve({{1}, {}, {}, {}}, {3, 0, 6}));
  append_lines(path, {{5, 3, 0}, {7, 3, 0}, {7, 0, 0}});
  path.append(Curve({{1}, {}, {}, {}}, {-6, -6}, {7, 0, 0}));
  const TrimmedOffset found = trimmed_offset(path, Rational(1, 2));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 3);
  // Below the first one, in the rectangle of 1 by 2, and above the last one up to x = 5 - 1/2.
  for (const auto& [k, length] : {std::pair(0, 5.0), {1, 6.0}, {2, 6.5}})
    CHECK(std::abs(approximate(
                       measure(path, found, found.branches[static_cast<std::size_t>(k)]).length) -
                   length) < 1e-12);
  CHECK(trimmed_offset(path, Rational(-1, 2)).branches.size() == 1);
}

TEST_CASE(
    "offset_trim: curved branches that touch, miss each other by 10^-30, or cross by as much") {
  // A bow that is lowest in its middle, and a line below it, one after the other on a path that
  // goes round; at half the distance of both they touch.
  const Curve bow({{1}, {}, {}, {-1, 2}}, Polynomial{6});
  const Vector<Rational> end = end_point(bow);
  const Rational lowest = position(bow)[1](Rational(1, 2));
  const Rational d(1, 4);
  for (const Rational& gap : {Rational(-1), Rational(0), Rational(1)}) {
    const Rational floor = lowest - 2 * d - gap * power_of_ten(-30);
    PhPath path(bow);
    append_lines(path, {{end[0] + 9, end[1], 0}, {end[0] + 9, floor, 0}, {-9, floor, 0}});
    const TrimmedOffset found = trimmed_offset(path, d);
    // To the right of the bow, below it, and inside of the rest: two branches where it is shut.
    CAPTURE(gap);
    CHECK(found.branches.size() == (gap < 0 ? 2 : 1));
    CHECK(found.undecided.empty());
  }
}

TEST_CASE("offset_trim: law: areas and lengths are those of polygons through points") {
  long samples = 0;
  long undecided = 0;
  for_samples(3, [&](Random& random) {
    const PhPath path = random_path(random, 2);
    const TrimmedOffset found =
        trimmed_offset(path, Rational(random.integer(0, 1) == 0 ? -5 : 5, random.integer(1, 4)));
    ++samples;
    if (!found.undecided.empty()) ++undecided;
    for (const TrimmedBranch& branch : found.branches) {
      double length = 0;
      double area = 0;
      for (const auto& [piece, from, to] : branch.parts) {
        const std::vector<Point> points = polygon(found.offset.pieces[piece].curve, from, to);
        for (std::size_t k = 1; k < points.size(); ++k) {
          length += std::abs(points[k] - points[k - 1]);
          area += (std::conj(points[k - 1]) * points[k]).imag() / 2;
        }
      }
      const BranchMeasure size = measure(path, found, branch);
      CHECK(approximate(size.length) == doctest::Approx(length).epsilon(1e-3));
      if (size.area) CHECK(std::abs(approximate(*size.area) - area) < 1e-3 * (length * length));
    }
  });
  CHECK(100 * undecided <= samples);
}

TEST_CASE(
    "offset_trim: next to a near-cusp, where branches are 10^-6 apart over all their length") {
  // w = (t - 3/10)(2 + t) + e(t + 3)i turns by half a turn within e of its parameter. To the right
  // of the bend both offsets go past each other, and to the left both are cut where they meet.
  for (const long digits : {6L, 12L}) {
    const Rational e = power_of_ten(-digits);
    const PhPath path(Curve({{Rational(-3, 5), Rational(17, 10), 1}, {}, {}, {3 * e, e}}));
    for (const long d : {1L, -1L}) {
      const TrimmedOffset found = trimmed_offset(path, Rational(d, 10));
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == 2);
      check_trimmed(path, found);
      // Where it is whole, a part is a whole segment again.
      for (const TrimmedBranch& branch : found.branches) CHECK(branch.parts.size() <= 2);
      if (d > 0 || digits < 12) continue;
      // By mpmath, as below, an arc about 3/10 from -6482.516·e² to 6482.163·e².
      const OffsetPart& arc = found.branches[1].parts.front();
      const Real width = arc.to + -arc.from;
      CHECK(round_to_decimal(width, 5).value == "1.2965e-20");
      CHECK(paths(found, found.branches[1], 10).size() == 1);
    }
  }
}

// Both branches of the path end within 10^-3 of the parameter of the near-cusp, at different
// speeds: about it an arc is left that their offsets cross at angles of 10^-8. The ends and the
// length by mpmath, from |r_d(t) - r(s)| = d, (r_d(t) - r(s))·r'(s) = 0 and a quadrature with 50
// digits.
TEST_CASE("offset_trim: next to a near-cusp, where a short arc is crossed at angles of 10^-8") {
  const Curve curve(
      {{Rational(108, 25), -12, 8}, {}, {}, {Rational(-594007, 700000), Rational(-69, 7), 12}});
  const PhPath path(curve);
  const TrimmedOffset found = trimmed_offset(path, Rational(5, 3));
  CHECK(found.undecided.empty());
  const auto arc = std::ranges::find_if(found.branches, [](const TrimmedBranch& branch) {
    return approximate(branch.parts.front().from) > 0.9;
  });
  REQUIRE(arc != found.branches.end());
  REQUIRE(arc->parts.size() == 1);
  const auto& [piece, from, to] = arc->parts.front();
  CHECK(round_to_decimal(from, 30).value == "0.900000817338024181915180431161");
  CHECK(round_to_decimal(to, 30).value == "0.900000817533120729602173691383");
  CHECK(round_to_decimal(measure(path, found, *arc).length, 20).value ==
        "0.0038925738733156909345");
}

// Both offsets of it, next to each other all along, cross at angles that balls do not tell from 0:
// one root of their resultant does. No point of the path is nearer than |d| to what is left.
TEST_CASE("offset_trim: next to a near-cusp, where both sides cross and nearly coincide") {
  Random random(303);
  random.integer(0, 2);
  const PhPath path = random_path(random, 1);
  const TrimmedOffset found = trimmed_offset(path, Rational(-80));
  CHECK(found.undecided.empty());
  CHECK(found.branches.size() == 2);
  CHECK(test::prove_distance(path, found).wrong.empty());
}

// The path is closed by a half-turn, which takes one branch to the other.
TEST_CASE("offset_trim: a cusp within 10^-10 of an inflection is decided by the sign of 1 + dk") {
  const Curve curve({{-8, 18, -10}, {}, {}, {Rational(57439993, 7000000), Rational(-55, 7), -3}});
  const PhPath path = test::chain({curve, rotated(curve, {0, 0, 0, 1})});
  const TrimmedOffset found = trimmed_offset(path, Rational(-5, 2));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 2);
  const auto length = [&](std::size_t k) {
    return round_to_decimal(measure(path, found, found.branches[k]).length, 20).value;
  };
  CHECK(length(0) == length(1));
}

// A loop is gone through twice, with other joints and other parameters the second time: one of both
// is left. And a path comes back along a part of its own, in the opposite direction.
TEST_CASE("offset_trim: paths that run along themselves") {
  const Curve curve({{1}, {}, {}, {Rational(-1, 2), Rational(3, 2)}});
  const auto at = [&](const Rational& t) { return evaluate(position(curve), t); };
  const Vector<Rational> end = at(1);
  const Vector<Rational> start = at(0);
  const std::vector<Vector<Rational>> way{{end[0], 4, 0}, {start[0], 4, 0}, start};
  PhPath once(curve);
  append_lines(once, way);
  PhPath twice = once;
  twice.append(segment(curve, 0, Rational(1, 3)));
  twice.append(segment(curve, Rational(1, 3), 1));
  append_lines(twice, way);
  for (const Rational& d : {Rational(1, 5), Rational(-1, 5)}) {
    const auto area = [&](const PhPath& path) {
      const TrimmedOffset found = trimmed_offset(path, d);
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == 1);
      return round_to_decimal(*measure(path, found, found.branches[0]).area, 15).value;
    };
    CHECK(area(twice) == area(once));
  }
  const Vector<Rational> one = at(Rational(1, 3));
  const Vector<Rational> other = at(Rational(2, 3));
  PhPath back(curve);
  append_lines(back, {{end[0], 2, 0}, {other[0], 2, 0}, other});
  back.append(reversed(segment(curve, Rational(1, 3), Rational(2, 3))));
  append_lines(back, {{one[0], -3, 0}});
  for (const Rational& d : {Rational(1, 5), Rational(-1, 5)}) {
    const TrimmedOffset found = trimmed_offset(back, d);
    CHECK(found.undecided.empty());
    check_trimmed(back, found);
  }
}

/// The range of x of a line with that x′, by 20 000 points.
double hull_of(const Polynomial& rate) {
  const Doubles x = doubles(antiderivative(rate));
  double lower = 0;
  double upper = 0;
  for (long k = 0; k <= 20'000; ++k) {
    lower = std::min(lower, value(x, double(k) / 20'000));
    upper = std::max(upper, value(x, double(k) / 20'000));
  }
  return upper - lower;
}

Polynomial turning_rate(Random& random, long degree) {
  std::vector<Rational> rate;
  for (long k = 0; k <= degree; ++k) rate.emplace_back(random.integer(-9, 9));
  Polynomial f = from_bernstein(rate);
  return f(0) == 0 || odd_inside(real_roots(f, open_interval(0, 1))).empty()
             ? turning_rate(random, degree)
             : f;
}

// The offset of a line that goes to and fro is that of all its points; so are those of rectangles
// with such a side, however far it goes beyond the corners.
TEST_CASE("offset_trim: law: of a line that turns back what is left is that of its hull") {
  for_samples(12, [](Random& random) {
    const Polynomial f = turning_rate(random, random.integer(1, 6));
    CAPTURE(f);
    const PhPath line(Curve({{2}, {}, {}, {1}}, f));
    for (const Rational& d : {Rational(1, 3), Rational(-20)}) {
      const TrimmedOffset found = trimmed_offset(line, d);
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == 1);
      const double length = approximate(measure(line, found, found.branches[0]).length);
      CHECK(std::abs(length - 5 * hull_of(f)) < 1e-5 * length);
    }
  });
}

// The same points, however they are gone through, have the same offset. v goes from 0 to
// h(1) = 3/2 in three legs, which for a = 24 are all as long as that.
TEST_CASE("offset_trim: law: of a curve that goes to and fro what is left is that of its points") {
  const auto along_cubic = [](const Polynomial& v) {
    return PhPath(Curve({{1}, {}, {}, v}, differentiate(v)));
  };
  const PhPath plain = along_cubic({0, Rational(3, 2)});
  for (const Rational& a : {Rational(20), Rational(24)})
    for (const Rational& d : {Rational(1, 5), Rational(-1, 3), Rational(-3, 2)}) {
      CAPTURE(a);
      CAPTURE(d);
      const PhPath path = along_cubic({0, Rational(3, 2) + a / 2, -a * Rational(3, 2), a});
      const TrimmedOffset found = trimmed_offset(path, d);
      const TrimmedOffset expected = trimmed_offset(plain, d);
      CHECK(found.undecided.empty());
      REQUIRE(found.branches.size() == expected.branches.size());
      for (std::size_t k = 0; k < found.branches.size(); ++k) {
        const double length = approximate(measure(path, found, found.branches[k]).length);
        const double other = approximate(measure(plain, expected, expected.branches[k]).length);
        CHECK(std::abs(length - other) < 1e-12);
      }
    }
}

// The offset of the line x = -1/5 is x = 0, which those of a cubic and of its mirror image cross in
// one point, where x = v - v^3/3 - 1/3 + 2v/(5 + 5v^2) is 0. The cubic's is nowhere left there.
TEST_CASE("offset_trim: three branches through one irrational point") {
  const Rational third(1, 3);
  const Curve cubic({{1}, {}, {}, {0, 1}}, {1}, {-third, 2, 0});
  const Curve mirrored({{1}, {}, {}, {-1, 1}}, {1}, {-third, 3, 0});
  PhPath path =
      lines({{Rational(-1, 5), -5, 0}, {Rational(-1, 5), Rational(197, 100), 0}, cubic.start()});
  path.append(cubic);
  append_lines(path, {{third, 6, 0}, {-third, 6, 0}, mirrored.start()});
  path.append(mirrored);
  const TrimmedOffset found = trimmed_offset(path, Rational(1, 5));
  CHECK(found.undecided.empty());
  REQUIRE(found.branches.size() == 2);
  const std::vector<OffsetPart>& parts = found.branches[0].parts;
  REQUIRE(parts.size() == 2);
  double v = 0;
  for (long k = 0; k < 200; ++k) v -= 0.5 * (v - v * v * v / 3 - 1.0 / 3 + 0.4 * v / (1 + v * v));
  const double y = 2 + v * v - 0.2 * (1 - v * v) / (1 + v * v);
  CHECK(std::abs(approximate(parts[0].to) - (y + 5) / 6.97) < 1e-14);
  CHECK(std::abs(approximate(parts[1].from) - (1 - v)) < 1e-14);
}

TEST_CASE("offset_trim: rooms with walls that go to and fro") {
  // From (4, 3) to (0, 3), turning back at x = 2 -+ 0.54, or at 2 -+ 4.66, beyond the corners,
  // where the offset below the wall is left, too, at more than 1/2 from the other walls.
  const auto check = [](const Polynomial& x, double beyond) {
    PhPath path = lines({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}});
    path.append(Curve({{1}, {}, {}, {}}, differentiate(x), {4, 3, 0}));
    append_lines(path, {{0, 0, 0}});
    const TrimmedOffset found = trimmed_offset(path, Rational(-1, 2));
    CHECK(found.undecided.empty());
    REQUIRE(found.branches.size() == (beyond > 0 ? 3 : 1));
    for (const TrimmedBranch& branch : found.branches) {
      const BranchMeasure size = measure(path, found, branch);
      const double length = approximate(size.length);
      CHECK(std::abs(length - (branch.is_closed ? 10 : beyond)) < 1e-12);
      if (branch.is_closed) CHECK(std::abs(approximate(*size.area) - 6) < 1e-12);
    }
  };
  check({4, -20, 48, -32}, 0);
  check(Polynomial{4, -2} - Polynomial::monomial(2, 61), 0);  // in one way, of degree 61
  // x' = -64 + 360t - 360t^2.
  const double t = (360 - std::sqrt(37440)) / 720;
  check({4, -64, 180, -120}, -4 + 64 * t - 180 * t * t + 120 * t * t * t - 0.5);
}

// From (0, 0) to (1, 0) and back, up, and along y = 2, whose offset on y = 1/2 comes out of the
// circle of the radius 3/2 about (1, 0) at x = 1 + sqrt 2. And where x' = 3 - 6t^2, the line turns
// back at the irrational x = sqrt 2, where that circle is met at x = 2 sqrt 2.
TEST_CASE("offset_trim: an offset ends on the circle about a place where the path turns back") {
  for (const auto& [rate, tip] :
       {std::pair(Polynomial{4, -8}, 1.0), {Polynomial{3, 0, -6}, std::sqrt(2.0)}}) {
    PhPath path(Curve({{1}, {}, {}, {}}, rate));
    const Rational end = end_point(path.segments()[0])[0];
    append_lines(path, {{end, 2, 0}, {5, 2, 0}});
    const TrimmedOffset found = trimmed_offset(path, Rational(-3, 2));
    CHECK(found.undecided.empty());
    REQUIRE(found.branches.size() == 1);
    const double length = approximate(measure(path, found, found.branches[0]).length);
    CHECK(std::abs(length - (5 - tip - std::sqrt(2.0))) < 1e-14);
  }
}

// Where it would be cut for its turning, at 3/8, it turns back; both ends are left.
TEST_CASE("offset_trim: a path that turns back at a short fraction") {
  const PhPath path(Curve({{-6, 4, -2}, {}, {}, {4, Rational(-55, 7), 2}}, {3, -8}));
  const TrimmedOffset found = trimmed_offset(path, Rational(21, 10));
  CHECK(found.undecided.empty());
  CHECK(found.branches.size() == 2);
  check_trimmed(path, found);
}

// Cusps at which a path turns back, with an event on the half-circle about each.
TEST_CASE("offset_trim: law: paths that turn back at cusps") {
  long branches = 0;
  for_samples(6, [&](Random& random) {
    const Curve curve = tame_curve(random);
    const Polynomial f = turning_rate(random, random.integer(1, 2));
    PhPath path(Curve(curve.preimage(), f));
    if (random.chance(2)) try {
        path.append(Curve(tame_curve(random).preimage(), {1}, end_point(path.segments().back())));
      } catch (const DomainError&) {  // the tangent turns back
      }
    const Rational d =
        Rational(random.integer(0, 1) == 0 ? -1 : 1) * Rational(random.integer(1, 30), 10);
    CAPTURE(d);
    CAPTURE(f);
    const TrimmedOffset found = trimmed_offset(path, d);
    CHECK(found.undecided.empty());
    check_trimmed(path, found);
    for (const TrimmedBranch& branch : found.branches)
      CHECK(approximate(measure(path, found, branch).length) > 0);
    branches += static_cast<long>(found.branches.size());
  });
  CHECK(branches >= 3);
}

TEST_CASE("offset_trim: a part shorter than 2^-64 has a length") {
  const PhPath line = lines({{0, 0, 0}, {3, 0, 0}});
  const Rational width = power_of_two(-200);
  const Rational third(1, 3);
  const TrimmedOffset found{offset(line, 1), {{{{0, third, third + width}}, false}}, {}};
  const Real length = measure(line, found, found.branches[0]).length;
  CHECK(length.exact() == Rational(3 * width));
}

// 1 + dκ = 1 - 1/(1 + v^2)^2 with v = t - 1/2: Δs + d·Δφ = 13/12 - 2 atan(1/2).
TEST_CASE("offset_trim: the length of a part in the middle of which the offset stands still") {
  const PhPath path(Curve({{1}, {}, {}, {Rational(-1, 2), 1}}));
  const TrimmedOffset found = trimmed_offset(path, Rational(-1, 2));
  REQUIRE(found.branches.size() == 1);
  CHECK(found.branches[0].parts.size() == 1);
  const double length = approximate(measure(path, found, found.branches[0]).length);
  CHECK(std::abs(length - (13.0 / 12 - 2 * std::atan(0.5))) < 1e-14);
}

// Bernstein coefficients of 1 and -1 in turns: powers of t up to 3^100 cancel.
TEST_CASE(
    "offset_trim: discs along a curve of high degree are where its Bernstein coefficients are") {
  std::vector<Rational> coefficients;
  for (long k = 0; k <= 100; ++k) coefficients.emplace_back(k % 2 == 0 ? 1 : -1);
  const DiscCover discs({{from_bernstein(coefficients), Polynomial{0, 1}, {1}, {1}}});
  const auto any_near = [&](const Vector<Rational>& at) {
    return discs.any_near(at, [](std::size_t) { return true; });
  };
  CHECK(any_near({0, Rational(1, 2), 0}));
  CHECK_FALSE(any_near({3, Rational(1, 2), 0}));
}

TEST_CASE("offset_trim: law: a disc that is around a point has it inside, and is there if any is") {
  long inside = 0;
  for_samples(6, [&](Random& random) {
    const PhPath path = random_path(random, 2);
    const Foreign foreign(path);
    const Rational d = random.integer(1, 40);
    const DiscCover discs(path, d);
    for (int k = 0; k < 20; ++k) {
      const auto segment = static_cast<std::size_t>(
          random.integer(0, static_cast<long>(path.segments().size()) - 1));
      const double t = double(random.integer(0, 100)) / 100;
      const Point from = foreign.point(segment, t) + static_cast<double>(d) *
                                                         double(random.integer(90, 110)) / 100 *
                                                         foreign.right_normal(segment, t);
      const Vector<Rational> at{exact_rational(from.real()), exact_rational(from.imag()), 0};
      const double distance = foreign.distance(from);
      const auto disc = discs.disc_around(at);
      if (std::abs(distance - static_cast<double>(d)) > 1e-6)
        CHECK(disc.has_value() == (distance < static_cast<double>(d)));
      if (!disc) continue;
      ++inside;
      const Vector<Rational> gap = disc->center - at;
      CHECK(disc->radius == d);
      CHECK(dot(gap, gap) < d * d);
    }
  });
  CHECK(inside > 20);
}

TEST_CASE("offset_trim: what cannot be is refused") {
  const PhPath line = lines({{0, 0, 0}, {1, 0, 0}});
  CHECK_THROWS_WITH_AS(trimmed_offset(line, 0), "offset: the distance is 0", DomainError);
}

}  // namespace offset_trim_test
