#pragma once
#include <string>

#include "phrame/answer/offset_drawing.hpp"

namespace phrame::inline v0 {

/// A nurbs/1 file with the curve, or for several of them a file each on a line.
std::string write_nurbs(const OffsetNurbs& nurbs);
/// A DXF file with a SPLINE for each, on layers of their own, offset-1, offset-2, …: of all numbers
/// the next doubles.
std::string write_dxf(const OffsetNurbs& nurbs);

}  // namespace phrame
