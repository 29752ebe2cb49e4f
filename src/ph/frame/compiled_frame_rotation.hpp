#pragma once
#include "phrame/algebra/error_free.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

namespace phrame::inline v0 {

/// B at t as sums of two doubles, off by at most the error, in the Euclidean norm.
struct CompiledFrames::Rotation {
  Quaternion<DoubleDouble> b;  ///< B, a unit quaternion
  double error;                ///< of all components together
};

/// The frame of B, every component correctly rounded, but for those that are known to be 0; no
/// value where the error leaves a rounding open.
std::optional<Frame<double>> rounded_frame(const CompiledFrames::Rotation& at,
                                           const CompiledFrames::Zeros& zeros = {});

}  // namespace phrame
