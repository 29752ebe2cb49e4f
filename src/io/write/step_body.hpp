#pragma once
#include "phrame/answer/rational_sweep.hpp"
#include "phrame/io/write/step_patch.hpp"

namespace phrame::inline v0 {

/// The patches, correctly rounded.
StepBody step_body(const RationalSweepAnswer& answer);

}  // namespace phrame
