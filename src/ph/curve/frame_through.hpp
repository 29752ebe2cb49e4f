#pragma once
#include <vector>

#include "phrame/ph/curve/rotation.hpp"

namespace phrame::inline v0 {

/// Orientations that a frame along a path is to have at joints of it, the ends among them.
struct FrameThrough {
  /// At a joint.
  struct Joint {
    std::size_t joint;    ///< its number: t there
    Vector<Rational> f2;  ///< f₂, once it is projected to the normal plane; of any length
    long turns = 0;       ///< so many revolutions more since the one before
    friend bool operator==(const Joint&, const Joint&) = default;
  };
  std::vector<Joint> joints;  ///< ascending, from 0 to the number of segments
  /// Is the angle by which the frame turns about the tangent a C² cubic spline of the arc length?
  /// Else it turns evenly from joint to joint, which is the least twist.
  bool is_smooth = false;
  TangentAxis axis = {};  ///< of the body that the frame is of
  friend bool operator==(const FrameThrough&, const FrameThrough&) = default;
};

}  // namespace phrame
