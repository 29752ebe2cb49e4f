#include "phrame/ph/frame/erf_turning.hpp"

#include <algorithm>

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/frame/rmf_angle.hpp"

namespace phrame {

ErfTurning erf_turning(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  ErfTurning turning{{}, {}, true};
  const Polynomial h = twist_numerator(a);
  if (h.is_zero()) return turning;
  turning.zeros = real_roots(erf_rate(a).numerator(), closed(0, 1));
  turning.is_monotone = odd_inside(turning.zeros).empty();
  const RationalFunction slope =
      differentiate(RationalFunction(h, curve.multiplier() * pow(sigma(a), 2)));
  if (slope.is_zero()) return turning;
  for (const RealRoot& root : real_roots(slope.numerator(), closed(0, 1)))
    if (root.order % 2 == 1) turning.extrema.push_back(root);
  return turning;
}

std::vector<RealRoot> odd_inside(const std::vector<RealRoot>& points) {
  std::vector<RealRoot> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found), [](const RealRoot& point) {
    return point.order % 2 == 1 && compare(point.at, 0) > 0 && compare(point.at, 1) < 0;
  });
  return found;
}

}  // namespace phrame
