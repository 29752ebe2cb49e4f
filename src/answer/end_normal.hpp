#pragma once
#include <optional>

#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// Throws DomainError where the path is closed and has an end normal nevertheless.
void require_open(const std::optional<Vector<Rational>>& end_normal, bool is_closed);

/// The end as minimal_twist() takes it: no value for a closed path, which has no end normal.
std::optional<FrameStart> end_of_frame(const std::optional<Vector<Rational>>& end_normal);

}  // namespace phrame
