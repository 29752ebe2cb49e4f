#pragma once
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Is it Wavefront's OBJ with vertices, or a PLY file?
bool is_polyline_file(std::string_view text);
/// The cubic spline through the points of a polyline: of OBJ those that `l` elements join, of PLY
/// in ASCII those that the element `edge` joins, or all vertices, in order, where there are neither
/// edges nor faces. Lines of an object that share their ends are one polyline, from the end that
/// comes first; a loop has a periodic spline, any other a natural one, which a note says. Of
/// several, that of the object or group which is picked. (Wavefront's Object Files appendix B1,
/// elements v and l; Turk: The PLY Polygon File Format.) Throws InputError; its place is "line 3".
PointCurve read_polyline(std::string_view text, const FileReading& reading);

}  // namespace phrame
