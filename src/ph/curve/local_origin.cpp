#include "phrame/ph/curve/local_origin.hpp"

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {

Vector<double> local_origin(const std::vector<Vector<double>>& points) {
  Vector<double> middle{};
  double extent = 0;
  if (points.empty()) return middle;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto less = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), less);
    middle[k] = (*least)[k] / 2 + (*greatest)[k] / 2;
    extent = std::max(extent, (*greatest)[k] - (*least)[k]);
  }
  if (!(extent < 0x1p1000)) return {};
  if (extent == 0) return middle;
  int exponent = 0;
  std::frexp(extent, &exponent);
  for (double& x : middle) {
    const double units = std::ldexp(x, -exponent);
    if (std::abs(units) < 0x1p52) x = std::ldexp(std::floor(units + 0.5), exponent);
    x += 0.0;  // no −0
  }
  return middle;
}

}  // namespace phrame
