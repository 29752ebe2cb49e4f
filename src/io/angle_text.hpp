#pragma once
#include <string_view>

#include "phrame/ph/frame_angle.hpp"

namespace phrame {

/// Reads an angle: radians ("0.3927", "-3/7") or a multiple of π ("pi/8", "-31pi/40", "0.125pi",
/// "5/8*pi", "π"). Throws InputError (no place) on anything else.
FrameAngle parse_angle(std::string_view text);

}  // namespace phrame
