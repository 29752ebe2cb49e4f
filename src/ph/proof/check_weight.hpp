#pragma once
#include <string>

#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// Empty where W, of r = X/W, has no zero on [0, 1].
std::string objection_to_weight(const Curve& curve);

}  // namespace phrame
