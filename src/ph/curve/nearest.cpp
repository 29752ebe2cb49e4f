#include "phrame/ph/curve/nearest.hpp"

#include <fmt/format.h>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/increasing.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Is a < b? Not where 4096 bits do not tell.
bool is_less(const Real& a, const Real& b) {
  if (a.exact() && b.exact()) return *a.exact() < *b.exact();
  for (long bits = 64; bits <= 4096; bits *= 4)
    if (const int found = sign(subtract(a.enclose(bits), b.enclose(bits), bits)); found != 0)
      return found < 0;
  return false;
}

/// A function of the point r, in the three forms that it is wanted in.
struct OfPoint {
  std::function<RationalFunction(const RationalCurve& curve)> along;
  std::function<BallPolynomial(const Vector<BallPolynomial>& r, long length, long bits)> series;
  std::function<Real(const Vector<Real>& r)> at;
};

OfPoint coordinate(std::size_t axis) {
  return {
      [axis](const RationalCurve& c) { return RationalFunction(c.numerator()[axis], c.weight()); },
      [axis](const Vector<BallPolynomial>& r, long, long) { return r[axis]; },
      [axis](const Vector<Real>& r) { return r[axis]; }};
}

OfPoint squared_distance(const Vector<Rational>& p) {
  const auto along = [p](const RationalCurve& curve) {
    const Polynomial& W = curve.weight();
    const Vector<Polynomial>& X = curve.numerator();
    const Vector<Polynomial> way{X[0] - p[0] * W, X[1] - p[1] * W, X[2] - p[2] * W};
    return RationalFunction(dot(way, way), W * W);
  };
  const auto series = [p](const Vector<BallPolynomial>& r, long length, long bits) {
    BallPolynomial sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const BallPolynomial way = subtract(r[k], BallPolynomial({RealBall(p[k], bits)}), bits);
      sum = add(sum, multiply_series(way, way, length, bits), bits);
    }
    return sum;
  };
  const auto at = [p](const Vector<Real>& r) {
    const Vector<Real> way = r + as_reals(Rational(-1) * p);
    return dot(way, way);
  };
  return {along, series, at};
}

/// f along a curve by formulas: its Taylor series around all points of the ball t.
using SeriesAround = std::function<BallPolynomial(const RealBall& t, long length, long bits)>;

/// The sign of f′(t), 0 where 4096 bits do not tell it from 0.
int slope_sign(const SeriesAround& f, const Rational& t) {
  for (long bits = 64; bits <= 4096; bits *= 4)
    if (const int found = sign(f(RealBall(t, bits), 2, bits).coefficient(1)); found != 0)
      return found;
  return 0;
}

/// The t of [a, b] with f′(t) = 0, where f″ > 0 there and f′(a) < 0 < f′(b).
Real zero_of_slope(const SeriesAround& f, const Rational& a, const Rational& b) {
  const Rational length = b - a;
  const auto t_of = [=](const RealBall& x, long bits) {
    return add(RealBall(a, bits), multiply(RealBall(length, bits), x, bits), bits);
  };
  auto slope = std::make_shared<IncreasingFunction>();
  slope->value = [=](const RealBall& x, long bits) {
    return f(t_of(x, bits), 2, bits).coefficient(1);
  };
  slope->slope = [=](const RealBall& x, long bits) {
    return multiply(RealBall(2 * length, bits), f(t_of(x, bits), 3, bits).coefficient(2), bits);
  };
  return a + length * preimage(slope, 0, guess_preimage(*slope, 0));
}

/// Every t ∈ (0, 1) where f is least on [0, 1], and others: by parts on which f′ ≠ 0, f″ ≠ 0, or f
/// is greater than elsewhere. Throws Undecided, with the segment, where such parts are not found.
std::vector<Real> least_along(const SeriesAround& f, std::size_t segment) {
  constexpr long bits = 128;
  constexpr int most_parts = 20'000;
  struct Part {
    Rational from;
    Rational to;
  };
  std::vector<Real> found;
  std::vector<Part> parts{{0, 1}};
  Rational best = f(RealBall(Rational(0), bits), 1, bits).coefficient(0).upper();
  for (int count = 0; !parts.empty(); ++count) {
    const Part part = parts.back();
    parts.pop_back();
    const Rational middle = (part.from + part.to) / 2;
    const Rational half = (part.to - part.from) / 2;
    if (count == most_parts || half < power_of_two(-40))
      throw Undecided(
          fmt::format("segment {}, by formulas: next to t = {:.6g} it is not told where the "
                      "extreme is, as where "
                      "it is the same along an arc",
                      segment + 1, approximate(RealBall(middle, bits))));
    best = std::min(best, f(RealBall(middle, bits), 1, bits).coefficient(0).upper());
    const BallPolynomial around = f(hull(part.from, part.to, bits), 3, bits);
    if (around.coefficient(0).is_finite() && around.coefficient(0).lower() > best) continue;
    const RealBall slope = around.coefficient(1);
    if (sign(slope) != 0 || slope.is_zero()) continue;
    const int bend = sign(around.coefficient(2));
    if (bend < 0) continue;
    if (bend == 0) {
      parts.push_back({middle, part.to});
      parts.push_back({part.from, middle});
      continue;
    }
    const int from = slope_sign(f, part.from);
    const int to = slope_sign(f, part.to);
    if (from < 0 && to > 0) found.push_back(zero_of_slope(f, part.from, part.to));
    if (from == 0) found.emplace_back(part.from);
    if (to == 0) found.emplace_back(part.to);
  }
  return found;
}

/// Where along the segment f may be least, and, if that is asked for, where it may be greatest: the
/// ends, and zeros of its derivative; with its values, in the order of t.
std::vector<PathExtreme> extremes(const Path& path, std::size_t k, const OfPoint& f,
                                  bool greatest_too) {
  std::vector<Place> places{Place(k, Rational(0))};
  if (const RationalCurve* curve = rational_curve(path.segments()[k])) {
    const RationalFunction g = f.along(*curve);
    const Polynomial slope = differentiate(g).numerator();
    if (!slope.is_constant())
      for (const RealRoot& zero : real_roots(slope, closed_interval(0, 1)))
        places.emplace_back(k, zero.at);
    places.emplace_back(k, Rational(1));
    std::vector<PathExtreme> found;
    for (Place& at : places) {
      Real of = value(g, at);
      found.push_back({std::move(at), std::move(of)});
    }
    return found;
  }
  const auto curve =
      std::make_shared<const ExpressionCurve>(std::get<ExpressionCurve>(path.segments()[k]));
  const SeriesAround upward = [curve, f](const RealBall& t, long length, long bits) {
    return f.series(curve->series(t, 1, length, bits), length, bits);
  };
  const SeriesAround downward = [upward](const RealBall& t, long length, long bits) {
    return -upward(t, length, bits);
  };
  std::vector<Real> inside = least_along(upward, k);
  if (greatest_too) {
    const std::vector<Real> more = least_along(downward, k);
    inside.insert(inside.end(), more.begin(), more.end());
  }
  for (const Real& t : inside) places.emplace_back(k, t);
  places.emplace_back(k, Rational(1));
  std::vector<PathExtreme> found;
  for (const Place& at : places) found.push_back({at, f.at(position(path, at))});
  return found;
}

}  // namespace

std::array<PathRange, 3> bounding_box(const Path& path) {
  const auto range = [&](std::size_t axis) {
    std::optional<PathRange> found;
    const OfPoint f = coordinate(axis);
    for (std::size_t k = 0; k < path.segments().size(); ++k)
      for (const PathExtreme& next : extremes(path, k, f, true)) {
        if (!found) found = PathRange{next, next};
        if (is_less(next.value, found->least.value)) found->least = next;
        if (is_less(found->greatest.value, next.value)) found->greatest = next;
      }
    return *found;
  };
  return {range(0), range(1), range(2)};
}

PathExtreme nearest_point(const Path& path, const Vector<Rational>& p) {
  std::optional<PathExtreme> found;
  const OfPoint f = squared_distance(p);
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    for (const PathExtreme& next : extremes(path, k, f, false))
      if (!found || is_less(next.value, found->value)) found = next;
  const auto& algebraic = found->at.algebraic;
  found->value =
      algebraic
          ? algebraic->square_root(f.along(*rational_curve(path.segments()[found->at.segment])))
          : square_root_of(found->value);
  return *found;
}

}  // namespace phrame
