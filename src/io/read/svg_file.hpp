#pragma once
#include <string_view>

#include "phrame/io/read/given_segment.hpp"

namespace phrame {

/// The one path that an SVG file draws: of a <path> element its "d", mapped by the "transform" of
/// the element and of all around it; "viewBox" is not applied. What is in defs, symbol, clipPath,
/// mask, marker and pattern is not drawn. Rotations by other angles than multiples of 90° are as
/// rotation_by_degrees() says; skewX and skewY are refused. Throws InputError, its place
/// line:column, for what is no such file, and where it draws no path or several.
std::vector<GivenSegment> read_svg(std::string_view text);
/// The same of all subpaths of all paths that it draws.
std::vector<std::vector<GivenSegment>> read_svg_subpaths(std::string_view text);

}  // namespace phrame
