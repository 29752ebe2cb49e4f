#include "phrame/ph/offset/mitre_kites.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/boundary.hpp"

namespace phrame::inline v0 {
namespace {

/// 1 where c is to the left of the line from a to b.
int side(const Vector<Rational>& a, const Vector<Rational>& b, const Vector<Rational>& c) {
  return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

}  // namespace

MitreKites::MitreKites(const Offset& offset,
                       const std::function<Vector<Rational>(std::size_t segment)>& start) {
  const auto& pieces = offset.pieces;
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    if (!pieces[k].is_join || !is_line(pieces[k].curve)) continue;
    const Vector<Rational> corner = start(pieces[k].segment);
    Kite kite{{corner, point(pieces[k].curve, 0), point(pieces[k].curve, 1),
               point(pieces[k + 1].curve, 1)}};
    if (side(kite.points[0], kite.points[1], kite.points[2]) < 0)
      std::swap(kite.points[1], kite.points[3]);
    Rational most = 0;
    for (const Vector<Rational>& at : kite.points) {
      const Vector<Rational> reach = at - corner;
      most = std::max(most, Rational(abs(reach[0]) + abs(reach[1])));
    }
    kite.center = {round_to_double(corner[0]), round_to_double(corner[1])};
    kite.reach = 1.001 * round_to_double(most) +
                 1e-12 * (std::abs(kite.center[0]) + std::abs(kite.center[1]));
    kites_.push_back(std::move(kite));
    ++k;
  }
}

bool MitreKites::contain(const Vector<Rational>& at) const {
  const double x = round_to_double(at[0]);
  const double y = round_to_double(at[1]);
  return std::ranges::any_of(kites_, [&](const Kite& kite) {
    if (std::abs(x - kite.center[0]) > kite.reach || std::abs(y - kite.center[1]) > kite.reach)
      return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (side(kite.points[k], kite.points[(k + 1) % 4], at) <= 0) return false;
    return true;
  });
}

}  // namespace phrame
