#include "phrame/ph/curve/special_points.hpp"

#include <algorithm>
#include <iterator>

#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

std::vector<RealRoot> cusps(const Curve& curve, const Interval& interval) {
  return real_roots(curve.multiplier() * pow(real_content(curve.preimage()), 2), interval);
}

std::vector<RealRoot> cusps(const Segment& segment) {
  if (const Curve* curve = ph_curve(segment)) return cusps(*curve);
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr || curve->multiplier().is_constant()) return {};
  return real_roots(curve->multiplier(), closed_interval(0, 1));
}

std::vector<RealRoot> inflections(const QuaternionPolynomial& a, const Interval& interval) {
  const GaussianPolynomial g = bend_numerator(without_real_content(a));
  return is_zero(g) ? std::vector<RealRoot>() : real_roots(gcd(g.re, g.im), interval);
}

std::vector<RealRoot> odd(const std::vector<RealRoot>& points) {
  std::vector<RealRoot> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found),
               [](const RealRoot& point) { return point.order % 2 == 1; });
  return found;
}

std::vector<RealRoot> odd_inside(const std::vector<RealRoot>& points) {
  std::vector<RealRoot> found = odd(points);
  std::erase_if(found, [](const RealRoot& point) {
    return compare(point.at, 0) <= 0 || compare(point.at, 1) >= 0;
  });
  return found;
}

std::vector<RealAlgebraic> sign_changes(const Polynomial& p) {
  std::vector<RealAlgebraic> places;
  for (const RealRoot& root : odd(real_roots(p, open_interval(0, 1)))) places.push_back(root.at);
  return places;
}

int constant_sign(const Polynomial& p) { return sign_changes(p).empty() ? sign_after_zero(p) : 0; }

}  // namespace phrame
