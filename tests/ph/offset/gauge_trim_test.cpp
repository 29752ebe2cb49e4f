#include "phrame/ph/offset/gauge_trim.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/gauges.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace gauge_trim_test {

using namespace phrame;
using namespace phrame::test;

namespace {

PhPath random_ph_path(Random& random, long count) {
  const auto next = [&](const Vector<Rational>& start) {
    const auto p = [&] { return from_bernstein({random.integer(-6, 6), random.integer(-6, 6)}); };
    return Curve({p() + Polynomial{Rational(1, 7)}, {}, {}, p()}, Polynomial{1}, start);
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

using Points = std::vector<std::array<double, 2>>;

std::array<double, 2> rounded_point(const Vector<Rational>& at) {
  return {round_to_double(at[0]), round_to_double(at[1])};
}

/// Of U, once around.
Points around(const Gauge& gauge) {
  Points points;
  constexpr long count = 120;
  for (long k = 0; k <= count; ++k) {
    // φ = 1/s from s = −1 to 1, and φ from −1 to 1.
    const Rational s(2 * k - count, count);
    const bool is_far = k % 2 == 0 && s != 0;
    const Rational phi = is_far ? Rational(1 / s) : s;
    const Rational w = gauge.weight()(phi);
    points.push_back(rounded_point({gauge.x()(phi) / w, gauge.y()(phi) / w, 0}));
  }
  std::ranges::sort(points, {}, [](const auto& at) { return std::atan2(at[1], at[0]); });
  points.push_back(points.front());
  return points;
}

/// The norm of v, by the two of these points between which it is: a little more than it is.
double norm(const Points& unit, const std::array<double, 2>& v) {
  for (std::size_t k = 0; k + 1 < unit.size(); ++k) {
    const auto& a = unit[k];
    const auto& b = unit[k + 1];
    const double det = a[0] * b[1] - a[1] * b[0];
    const double s = (v[0] * b[1] - v[1] * b[0]) / det;
    const double t = (a[0] * v[1] - a[1] * v[0]) / det;
    if (det > 1e-12 && s >= 0 && t >= 0) return s + t;
  }
  return 0;
}

Points along(const Path& path) {
  Points points;
  for (const Segment& segment : path.segments())
    for (long k = 0; k <= 200; ++k)
      points.push_back(rounded_point(point(*rational_curve(segment), Rational(k, 200))));
  return points;
}

double distance(const Points& unit, const Points& path, const std::array<double, 2>& at) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [x, y] : path) least = std::min(least, norm(unit, {at[0] - x, at[1] - y}));
  return least;
}

}  // namespace

TEST_CASE(
    "gauge trim: law: under a linear image of the circle it is cut where the offset of the "
    "preimage is") {
  long cut = 0;
  for_samples(6, [&](Random& random) {
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
}

TEST_CASE(
    "gauge trim: under an oval what is left is at the distance |d| of the gauge, and what is cut "
    "away is nearer") {
  for_samples(3, [](Random& random) {
    const Gauge gauge(oval(Rational(random.integer(-32, 32), 100)));
    // r′ = H(p), and lines along which U′ is at rational φ.
    const Polynomial p{Rational(random.integer(-2, 2), 4), Rational(random.integer(1, 3), 4)};
    const auto& [hx, hy] = gauge.direction();
    const bool is_smooth = random.chance(2);
    const Path path =
        is_smooth ? Path(Segment(RationalCurve(
                        {antiderivative(compose(hx, p)), antiderivative(compose(hy, p)), {}})))
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
          if (part.piece == piece && value(part.from) <= t && t <= value(part.to)) return true;
      return false;
    };
    const auto& pieces = found.offset.pieces;
    const Points unit = around(gauge);
    const Points line = along(path);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (long j = 1; j < 8; ++j) {
        const double away =
            distance(unit, line, rounded_point(point(pieces[k].curve, Rational(j, 8))));
        CAPTURE(away);
        CHECK((is_left(k, static_cast<double>(j) / 8) ? std::abs(away - reach) < 0.02 * reach
                                                      : away < 1.001 * reach));
      }
    long left = 0;
    for (const TrimmedBranch& branch : found.branches) left += branch.parts.size();
    CHECK(left > 0);
  });
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

TEST_CASE("gauge trim: what is refused is named") {
  const Gauge gauge(ellipse(1, 0, 0, 2));
  const auto refusal = [&](const std::vector<Segment>& segments) {
    return refusal_of<DomainError>([&] { trimmed_offset(joined(segments), gauge, 1); });
  };
  const Segment line = bezier_curve({{0, 0, 0}, {1, 0, 0}});
  CHECK(refusal({line, bezier_curve({{1, 0, 0}, {2, 0, 0}, {3, 1, 0}})}) ==
        "trimmed_offset: segment 2 has no rational offset under this gauge, so that what is left "
        "is not known");
  CHECK(refusal({bezier_curve({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}})}) ==
        "trimmed_offset: the path turns back at a cusp, in segment 1 at t = 1/2");
}

}  // namespace gauge_trim_test
