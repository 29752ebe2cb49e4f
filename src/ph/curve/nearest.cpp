#include "phrame/ph/curve/nearest.hpp"

#include <fmt/format.h>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
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

/// The least value of a function that is f(curve) along each segment; its square root where that is
/// asked for.
template <class F>
PathExtreme least(const Path& path, const F& f, bool is_square = false) {
  std::optional<PathExtreme> found;
  std::optional<PathExtreme> root;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const RationalFunction g = f(rational_segment(path, k));
    const auto consider = [&](const Place& at) {
      PathExtreme next{at, value(g, at)};
      if (found && !is_less(next.value, found->value)) return;
      if (is_square)
        root = PathExtreme{
            at, at.algebraic ? at.algebraic->square_root(g) : square_root_of(next.value)};
      found = std::move(next);
    };
    consider(Place(k, Rational(0)));
    const Polynomial slope = differentiate(g).numerator();
    if (!slope.is_constant())
      for (const RealRoot& zero : real_roots(slope, closed_interval(0, 1))) consider(Place(k, zero.at));
    consider(Place(k, Rational(1)));
  }
  return is_square ? *root : *found;
}

}  // namespace

std::array<PathRange, 3> bounding_box(const Path& path) {
  const auto range = [&](std::size_t axis) {
    const auto coordinate = [axis](const RationalCurve& curve) {
      return RationalFunction(curve.numerator()[axis], curve.weight());
    };
    const auto negative = [axis](const RationalCurve& curve) {
      return RationalFunction(-curve.numerator()[axis], curve.weight());
    };
    PathExtreme greatest = least(path, negative);
    greatest.value = -greatest.value;
    return PathRange{least(path, coordinate), std::move(greatest)};
  };
  return {range(0), range(1), range(2)};
}

PathExtreme nearest_point(const Path& path, const Vector<Rational>& p) {
  return least(
      path,
      [&](const RationalCurve& curve) {
        const Polynomial& W = curve.weight();
        const Vector<Polynomial>& X = curve.numerator();
        const Vector<Polynomial> way{X[0] - p[0] * W, X[1] - p[1] * W, X[2] - p[2] * W};
        return RationalFunction(dot(way, way), W * W);
      },
      true);
}

}  // namespace phrame
