#include "phrame/ph/smooth/smooth_path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"

// Two vectors u, v ≠ 0 have the same direction iff u × v = 0 and u·v > 0.

namespace phrame {
namespace {

/// Where a segment begins or ends.
struct SmoothEnd {
  Vector<Rational> position;
  Vector<Rational> direction;  ///< e₁, of any length
  int sign;                    ///< of p on the inner side: e₁ times it is the unit tangent
};

SmoothEnd start_of(const RationalCurve& curve) {
  return {point(curve, 0), evaluate(curve.direction(), 0), sign_after_zero(curve.multiplier())};
}

SmoothEnd end_of(const RationalCurve& curve) {
  return {point(curve, 1), evaluate(curve.direction(), 1),
          sign_after_zero(compose(curve.multiplier(), Polynomial{1, -1}))};
}

SmoothEnd start_of(const SmoothSegment& segment) {
  return std::visit([](const auto& curve) { return start_of(curve); }, segment);
}

SmoothEnd end_of(const SmoothSegment& segment) {
  return std::visit([](const auto& curve) { return end_of(curve); }, segment);
}

/// The unit tangent, scaled such that its largest component is ±1.
Vector<Rational> scaled_tangent(const SmoothEnd& end) {
  Vector<Rational> d = end.direction;
  const Rational size = std::max({abs(d[0]), abs(d[1]), abs(d[2])});
  for (Rational& x : d) x *= end.sign / size;
  return d;
}

bool have_same_direction(const Vector<Rational>& u, const Vector<Rational>& v) {
  return cross(u, v) == Vector<Rational>{} && dot(u, v) > 0;
}

SmoothSegment turned_over(const SmoothSegment& segment) {
  return std::visit([](const auto& curve) -> SmoothSegment { return curve.turned_over(); },
                    segment);
}

}  // namespace

void SmoothPath::append(const SmoothSegment& next) {
  const SmoothEnd before = end_of(segments_.back());
  const SmoothEnd after = start_of(next);
  if (after.position != before.position)
    throw DomainError(fmt::format("it starts at {}, but the spline ends at {}",
                                  abbreviated(after.position), abbreviated(before.position)));
  const Vector<Rational> old_tangent = scaled_tangent(before);
  const Vector<Rational> new_tangent = scaled_tangent(after);
  if (!have_same_direction(old_tangent, new_tangent))
    throw DomainError(
        fmt::format("the tangent breaks: it starts in the direction {}, but the spline ends in {}",
                    abbreviated(new_tangent), abbreviated(old_tangent)));
  segments_.push_back(before.sign == after.sign ? next : turned_over(next));
}

bool SmoothPath::ends_meet() const {
  return start_of(segments_.front()).position == end_of(segments_.back()).position;
}

bool SmoothPath::is_closed() const {
  return ends_meet() && have_same_direction(start_of(segments_.front()).direction,
                                            end_of(segments_.back()).direction);
}

SmoothPath joined(const std::vector<SmoothSegment>& segments) {
  SmoothPath path(segments.front());
  for (std::size_t k = 1; k < segments.size(); ++k) path.append(segments[k]);
  return path;
}

SmoothPath by_positions(const Path& path) {
  std::vector<SmoothSegment> segments;
  for (const Curve& curve : path.segments()) segments.emplace_back(RationalCurve(position(curve)));
  return joined(segments);
}

PathParameter locate(const SmoothPath& path, const Rational& t) {
  return locate_inside(path.segments().size(), t);
}

}  // namespace phrame
