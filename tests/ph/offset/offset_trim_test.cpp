#include "phrame/ph/offset/offset_trim.hpp"

#include <cmath>
#include <complex>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

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

  double distance(Point from) const {
    double least = 1e300;
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
        least = std::min({least, here, size((a + b) / 2)});
      }
    }
    return least;
  }

 private:
  static constexpr long count = 200;
  using Plane = std::array<Doubles, 2>;
  static Point at(const Plane& r, double t) { return {value(r[0], t), value(r[1], t)}; }

  std::vector<Plane> curves_;
  std::vector<std::vector<Point>> points_;
};

Point at(const RationalCurve& curve, double t) {
  const double w = value(doubles(curve.weight()), t);
  const auto& [x, y, z] = curve.numerator();
  return {value(doubles(x), t) / w, value(doubles(y), t) / w};
}

double approximate(const Real& x) { return phrame::approximate(x.enclose(64)); }

Curve tame_curve(Random& random) {
  for (;;) {
    const auto p = [&] {
      return from_bernstein({random.integer(-6, 6), random.integer(-6, 6), random.integer(-6, 6)});
    };
    Curve curve({p(), {}, {}, p() + Polynomial{0, Rational(1, 7)}});
    if (odd_inside(cusps(curve)).empty()) return curve;
  }
}

/// Of some curves with corners, closed by a half-turn or quarters where that is asked for.
PhPath random_path(Random& random, long turns) {
  for (;;) try {
      std::vector<Curve> curves;
      for (long k = random.integer(1, 3); k > 0; --k) curves.push_back(tame_curve(random));
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
      left[piece].emplace_back(approximate(from), approximate(to));
      CHECK(approximate(from) < approximate(to));
      if (k + 1 == branch.parts.size() && !branch.is_closed) continue;
      const OffsetPart& next = branch.parts[(k + 1) % branch.parts.size()];
      const Point gap = at(curve, approximate(to)) -
                        at(found.offset.pieces[next.piece].curve, approximate(next.from));
      CHECK(std::abs(gap) < 1e-7 * (1 + d));
    }
  }
  constexpr long samples = 20;
  for (std::size_t k = 0; k < left.size(); ++k)
    for (long j = 0; j < samples; ++j) {
      const double t = (double(j) + 0.37) / samples;
      const bool is_left = std::ranges::any_of(
          left[k], [&](const auto& part) { return part.first < t && t < part.second; });
      const bool is_near_cut = std::ranges::any_of(left[k], [&](const auto& part) {
        return std::min(std::abs(part.first - t), std::abs(part.second - t)) < 1e-5;
      });
      const double distance = foreign.distance(at(found.offset.pieces[k].curve, t));
      CAPTURE(k);
      CAPTURE(t);
      CAPTURE(distance);
      if (is_left) CHECK(std::abs(distance - d) < 1e-8 * (1 + d));
      if (!is_left && !is_near_cut) CHECK(distance < d * (1 - 1e-12));
    }
}

}  // namespace

TEST_CASE("offset_trim: law: what is left is at the distance |d|, and nothing else is") {
  long branches = 0;
  long undecided = 0;
  for_samples(12, [&](Random& random) {
    const std::array<long, 3> turns{1, 2, 4};
    const PhPath path = random_path(random, turns[std::size_t(random.integer(0, 2))]);
    const Rational d(random.integer(0, 1) == 0 ? random.integer(-40, -1) : random.integer(1, 40),
                     random.integer(1, 9));
    const TrimmedOffset found = trimmed_offset(path, d);
    CAPTURE(d);
    CAPTURE(path.segments().size());
    check_trimmed(path, found);
    branches += static_cast<long>(found.branches.size());
    undecided += static_cast<long>(found.undecided.size());
  });
  CHECK(branches >= 20);
  CHECK(undecided == 0);
}

}  // namespace offset_trim_test
