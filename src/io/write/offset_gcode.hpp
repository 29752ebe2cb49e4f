#pragma once
#include <string>

#include "phrame/answer/offset_drawing.hpp"

namespace phrame::inline v0 {

/// A program for machines with the axes X and Y: G1 along each polyline, G0 to where it begins,
/// unless the one before ends there.
std::string write_gcode(const OffsetPolylines& drawing);

}  // namespace phrame
