#pragma once
#include "phrame/answer/frame_table.hpp"
#include "phrame/ph/smooth/smooth_point.hpp"

namespace phrame {

/// The table of a path of any kind: frames rmf, up and frenet, and all scalars; `up` is v, one is
/// chosen if there is none. An angle at which the rotation-minimizing frame starts is that to e₂ =
/// v × e₁/|v × e₁|. What is not continuous at a joint is that of the later segment. Throws as the
/// frame_table() of PH curves, as SmoothAngle, and DomainError for a frame that only these have.
FrameTable frame_table(const SmoothPath& path, const TableColumns& columns,
                       const std::optional<Vector<Rational>>& up,
                       const std::vector<SmoothParameter>& at);

}  // namespace phrame
