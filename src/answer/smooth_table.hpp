#pragma once
#include "phrame/answer/frame_table.hpp"
#include "phrame/ph/twist/smooth_twist.hpp"

namespace phrame {

/// The table of a path of any kind: all frames but mtf, erf where a segment is a PH curve, and all
/// scalars; the angle is that to the frame of v. Where the rotation-minimizing frame starts at an
/// angle, it is that to e₂ = v × e₁/|v × e₁|. What is not continuous at a joint is that of the
/// later segment. Throws as the frame_table() of PH curves, and DomainError for a frame that only
/// these have.
FrameTable frame_table(const PathAngle& angle, const TableColumns& columns,
                       const std::vector<Place>& at, const std::optional<SmoothTwist>& twist = {});

}  // namespace phrame
