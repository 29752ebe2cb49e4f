#pragma once
#include <string_view>

#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// The one path or shape that an SVG file draws, or the one that is picked by its id or Inkscape's
/// label: of a <path> element its "d", of others as read_svg_shape(), mapped by the "transform" of
/// the element and of all around it; "viewBox" is not applied. What is in defs, symbol, clipPath,
/// mask, marker and pattern, and what has no display, is not drawn; <use> is not followed.
/// Rotations by other angles than multiples of 90° are as rotation_by_degrees() says, and so are
/// skewX and skewY. Throws InputError, its place line:column, for what is no such file, and where
/// it draws nothing or several.
PointCurve read_svg(std::string_view text, const FileReading& reading = {});
/// The same of all subpaths of all that it draws.
std::vector<std::vector<GivenSegment>> read_svg_subpaths(std::string_view text);

}  // namespace phrame
