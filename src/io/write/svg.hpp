#pragma once
#include <string>

#include "phrame/answer/offset_drawing.hpp"

namespace phrame::inline v0 {

/// An SVG file with a <path> for each path, called offset-1, offset-2, …. The decimals are exact, y
/// is as it is, and so downwards on a screen.
std::string write_svg(const OffsetDrawing& drawing);
/// What the attribute d of a <path> is, exactly: "M0,0 C1,0 2,0.5 2,2". Precondition: all numbers
/// have finitely many decimals.
std::string path_data(const OffsetCubics& path);
/// "5.0e-7", or "5.0e-7 to 1.0e54".
std::string in_words(const ToleranceRange& within);

}  // namespace phrame
