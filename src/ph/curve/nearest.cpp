#include "phrame/ph/curve/nearest.hpp"

#include <fmt/format.h>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

const RationalCurve& rational_segment(const Path& path, std::size_t k) {
  const RationalCurve* curve = rational_curve(path.segments()[k]);
  if (curve == nullptr)
    throw DomainError(fmt::format(
        "segment {} is by formulas: extremes are those of polynomial and rational curves", k + 1));
  return *curve;
}

/// Is a < b? Not where 4096 bits do not tell.
bool is_less(const Real& a, const Real& b) {
  if (a.exact() && b.exact()) return *a.exact() < *b.exact();
  for (long bits = 64; bits <= 4096; bits *= 4)
    if (const int found = sign(subtract(a.enclose(bits), b.enclose(bits), bits)); found != 0)
      return found < 0;
  return false;
}

/// Visits the values of a function, f(curve) along each segment, where it may be least or greatest:
/// at joints and at zeros of its derivative, in the order of the path.
template <class F, class Visit>
void visit_extremes(const Path& path, const F& f, const Visit& visit) {
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const RationalFunction g = f(rational_segment(path, k));
    const auto visit_at = [&](const Place& at) { visit(PathExtreme{at, value(g, at)}); };
    visit_at(Place(k, Rational(0)));
    const Polynomial slope = differentiate(g).numerator();
    if (!slope.is_constant())
      for (const RealRoot& zero : real_roots(slope, closed_interval(0, 1)))
        visit_at(Place(k, zero.at));
    visit_at(Place(k, Rational(1)));
  }
}

}  // namespace

std::array<PathRange, 3> bounding_box(const Path& path) {
  const auto range = [&](std::size_t axis) {
    std::optional<PathRange> found;
    const auto coordinate = [axis](const RationalCurve& curve) {
      return RationalFunction(curve.numerator()[axis], curve.weight());
    };
    visit_extremes(path, coordinate, [&](const PathExtreme& next) {
      if (!found) found = PathRange{next, next};
      if (is_less(next.value, found->least.value)) found->least = next;
      if (is_less(found->greatest.value, next.value)) found->greatest = next;
    });
    return *found;
  };
  return {range(0), range(1), range(2)};
}

PathExtreme nearest_point(const Path& path, const Vector<Rational>& p) {
  const auto squared_distance = [&p](const RationalCurve& curve) {
    const Polynomial& W = curve.weight();
    const Vector<Polynomial>& X = curve.numerator();
    const Vector<Polynomial> way{X[0] - p[0] * W, X[1] - p[1] * W, X[2] - p[2] * W};
    return RationalFunction(dot(way, way), W * W);
  };
  std::optional<PathExtreme> found;
  visit_extremes(path, squared_distance, [&](const PathExtreme& next) {
    if (!found || is_less(next.value, found->value)) found = next;
  });
  const auto& algebraic = found->at.algebraic;
  found->value =
      algebraic
          ? algebraic->square_root(squared_distance(rational_segment(path, found->at.segment)))
          : square_root_of(found->value);
  return *found;
}

}  // namespace phrame
