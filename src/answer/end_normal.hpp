#pragma once
#include <optional>

#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

/// Throws DomainError where there is an end normal of a closed path.
void require_open(const std::optional<Vector<Rational>>& end_normal, bool is_closed);

/// As minimal_twist() has it: none of a closed path.
std::optional<FrameStart> end_of_frame(const std::optional<Vector<Rational>>& end_normal);

}  // namespace phrame
