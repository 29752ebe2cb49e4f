#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0 {

/// A curve/1 object of any kind: by its preimage, its control points with or without weights, or
/// its position.
GivenSegment read_curve_segment(const JsonNode& node, const CurveLimits& limits);

}  // namespace phrame
