#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A place near the points, from which their coordinates are small numbers, so that floats hold
/// them well: the middle of the box around them, to the multiples of a power of two that is as
/// large as the box, or up to twice that. So it has few digits, and is 0 where the box is around 0
/// or beside it.
Vector<double> local_origin(const std::vector<Vector<double>>& points);

}  // namespace phrame
