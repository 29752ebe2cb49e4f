#pragma once
#include <string_view>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Does the text begin as a DXF file in ASCII?
bool is_dxf_file(std::string_view text);

/// The curve that the entities of a DXF file make, or the one that is picked by its layer or the
/// handle of an entity in it: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE with their
/// bulges, and SPLINE. Entities of a layer whose ends meet, but for what rounding leaves, are one
/// curve, in whatever order and direction they are. Lines, splines and arcs of polylines, which are
/// given by the tangent of a quarter of their angle, are exact; angles are as rotation_by_degrees()
/// and rotation_by_radians() say. Other entities are left out, which a note says. Throws
/// InputError, its place "line 3", for splines without control points, extrusions other than along
/// z, meshes, and where there is no curve or several.
PointCurve read_dxf(std::string_view text, const FileReading& reading, const CurveLimits& limits);

}  // namespace phrame
