#pragma once
#include <optional>
#include <string_view>

#include "phrame/ph/sweep/profile_curve.hpp"

namespace phrame::inline v0 {

/// @{ As parse_profile() and read_profile(), exactly: circles in rational quarters, outlines of SVG
/// with the curves they have. The corners of a regular polygon are doubles. That an outline does
/// not meet itself is seen of its polygon, to within 1/1000 of its size; that outlines do not meet
/// each other, exactly, else Undecided is thrown.
std::optional<ProfileCurve> parse_profile_curve(std::string_view text);
ProfileCurve read_profile_curve(std::string_view bytes);
/// @}

}  // namespace phrame
