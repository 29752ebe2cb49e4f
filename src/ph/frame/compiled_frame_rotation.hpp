#pragma once
#include "phrame/algebra/error_free.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

namespace phrame::inline v0 {

/// B at t as sums of two doubles, off by at most the error, in the Euclidean norm.
struct CompiledFrames::Rotation {
  Quaternion<DoubleDouble> b;  ///< B, a unit quaternion
  double error;                ///< of all components together
};

}  // namespace phrame
