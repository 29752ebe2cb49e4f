#include "phrame/ph/construct/c2_start.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

namespace phrame::inline v0 {

std::vector<Vector<double>> calm_derivatives(const C2Data& data, double haste) {
  const std::size_t n = data.steps.size();
  std::vector<Vector<double>> result = data.derivatives;
  const auto size = [&](std::size_t k) { return std::sqrt(dot(data.chords[k], data.chords[k])); };
  for (std::size_t k = 0; k <= n; ++k) {
    const bool is_end = k == 0 || k == n;
    if (is_end && !data.is_closed) continue;
    const std::size_t before = k > 0 ? k - 1 : n - 1;
    const std::size_t after = k < n ? k : 0;
    const double a = size(before);
    const double b = size(after);
    if (a == 0 || b == 0) continue;
    const Vector<double> along = (b / a) * data.chords[before] + (a / b) * data.chords[after];
    const double length = std::sqrt(dot(along, along));
    const double speed_before = a / data.steps[before];
    const double speed_after = b / data.steps[after];
    const double slow = std::min(speed_before, speed_after);
    const double fast = std::max(speed_before, speed_after);
    if (length > 0) result[k] = (slow * std::pow(fast / slow, haste) / length) * along;
  }
  return result;
}

std::vector<Quaternion<double>> first_joints(const C2Data& data,
                                             const std::vector<Vector<double>>& derivatives,
                                             double& closing_sign) {
  std::vector<Quaternion<double>> q;
  for (const Vector<double>& d : derivatives) {
    const Quaternion<double> a = preimage(d);
    if (q.empty()) {
      q.push_back(a);
      continue;
    }
    const double least = antiparallel * std::sqrt(norm(q.back()) * norm(a));
    q.push_back(turned(a, conjugate(direction_of(hermitian_product(q.back(), a), least))));
  }
  closing_sign = 1;
  if (!data.is_closed) return q;
  const ComplexOf<double> back = hermitian_product(q.front(), q.back());
  if (back.re < 0) closing_sign = -1;
  const double angle = std::atan2(closing_sign * back.im, closing_sign * back.re);
  const double part = -angle / static_cast<double>(data.steps.size());
  // Without the last digits, which depend on the library of functions.
  constexpr double places = 0x1p30;
  const ComplexOf<double> turn{std::round(std::cos(part) * places) / places,
                               std::round(std::sin(part) * places) / places};
  ComplexOf<double> sum{1, 0};
  for (Quaternion<double>& a : q) {
    a = turned(a, sum);
    sum = sum * turn;
  }
  return q;
}

}  // namespace phrame
