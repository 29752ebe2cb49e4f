#include "phrame/ph/offset/touching.hpp"

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// A part of a boundary curve.
struct PlanePart {
  const RationalCurve& curve;
  CurvePart part;
};

bool is_in(const RealAlgebraic& t, const CurvePart& part) {
  const Interval where = interval_of(part);
  return compare(t, *where.lower) >= 0 && compare(t, *where.upper) <= 0;
}

/// `shift` + `factor`·s is the parameter of the image of P(s).
std::optional<std::vector<KnownMeeting>> touching_at_axis(const PlanePart& a, const PlanePart& b,
                                                          const Rational& shift,
                                                          const Rational& factor) {
  // The axis from the images of a point at either end.
  Vector<Rational> from;
  Vector<Rational> across;
  for (const Rational& s : {Rational(0), Rational(1)}) {
    from = point(a.curve, s);
    across = point(b.curve, shift + factor * s) - from;
    if (across != Vector<Rational>{}) break;
  }
  const Rational square = dot(across, across);
  if (square == 0) return std::nullopt;
  // g = (P − the middle)·across, times W.
  const Polynomial& weight = a.curve.weight();
  const auto& x = a.curve.numerator();
  const Polynomial gap =
      across[0] * x[0] + across[1] * x[1] - (dot(across, from) + square / 2) * weight;
  const Polynomial image{shift, factor};
  const Polynomial other_weight = compose(b.curve.weight(), image);
  for (std::size_t k = 0; k < 2; ++k)
    if ((x[k] - (2 * across[k] / square) * gap) * other_weight !=
        compose(b.curve.numerator()[k], image) * weight)
      return std::nullopt;
  // Both parts, as parameters of P.
  const Interval one = interval_of(a.part);
  const Interval other = interval_of(b.part);
  const Rational p = (*other.lower - shift) / factor;
  const Rational q = (*other.upper - shift) / factor;
  const auto roots =
      real_roots(gap, closed_interval(std::min({*one.lower, p, q}), std::max({*one.upper, p, q})));
  std::vector<KnownMeeting> found;
  for (const RealRoot& root : roots) {
    if (roots.size() > 1 || root.order % 2 != 0) return std::nullopt;
    const RealAlgebraic t = affine(root.at, factor, shift);
    if (is_in(root.at, a.part) && is_in(t, b.part))
      found.push_back({a.part.segment, root.at, b.part.segment, t});
  }
  return found;
}

}  // namespace

std::optional<std::vector<KnownMeeting>> touching(const OffsetBranches& offset,
                                                  const CurveSeries& series,
                                                  const UndecidedCrossing& place) {
  if (are_joined(series, place.first, place.second)) return std::nullopt;
  const PlanePart a{offset.curves[place.first.segment], place.first};
  const PlanePart b{offset.curves[place.second.segment], place.second};
  if (auto found = touching_at_axis(a, b, 1, -1)) return found;
  return touching_at_axis(a, b, 0, 1);
}

}  // namespace phrame
