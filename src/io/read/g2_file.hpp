#pragma once
#include <string_view>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/given_segment.hpp"

namespace phrame::inline v0 {

/// Does the text begin as a curve in the format G2 of GoTools and Splipy, "100 1 0 0"?
bool is_g2_file(std::string_view text);

/// The B-spline or NURBS of a G2 file: dimension and whether it is rational, points and order,
/// knots, control points, of a rational one multiplied by their weights, which follow them. Throws
/// InputError, its place line:column or what the spline lacks, and where a second one follows.
std::vector<GivenSegment> read_g2(std::string_view text, const CurveLimits& limits);

}  // namespace phrame
