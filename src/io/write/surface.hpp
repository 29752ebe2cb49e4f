#pragma once
#include <string>

#include "phrame/answer/rational_sweep.hpp"

namespace phrame::inline v0 {

/// surface/1: all patches with exact fractions (docs/sweep.md).
std::string to_json(const RationalSweepAnswer& answer);
/// The patches as free-form surfaces of Wavefront OBJ, rational Bézier ones: coordinates and
/// weights are correctly rounded doubles.
std::string to_obj(const RationalSweepAnswer& answer);

}  // namespace phrame
