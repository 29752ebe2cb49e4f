#pragma once
#include <string>

#include "phrame/answer/offset_drawing.hpp"

namespace phrame::inline v0 {

/// An SVG file with a <path> for each path, called offset-1, offset-2, …. The decimals are exact, y
/// is as it is, and so downwards on a screen.
std::string write_svg(const OffsetDrawing& drawing);

}  // namespace phrame
