#pragma once
#include <algorithm>
#include <limits>

namespace phrame::inline v0 {

/// The nearest float, but not beyond the greatest one.
inline float as_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

}  // namespace phrame
