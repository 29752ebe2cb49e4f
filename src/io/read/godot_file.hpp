#pragma once
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Is it a text file of Godot, a resource (.tres) or a scene (.tscn)?
bool is_godot_file(std::string_view text);
/// The Curve3D or Curve2D in such a file, of several the one that is picked, by its resource_name
/// or id. Its points are triples: in, out, position, the first two relative to the third; between
/// two of them is a cubic Bézier curve, or a line where both handles are 0. Where it is closed, one
/// goes from the last to the first. Tilts are left out, which a note says. (Godot's documentation
/// of Curve3D; of the text format, its "TSCN file format".) Throws InputError; its place is
/// line:column.
PointCurve read_godot(std::string_view text, const FileReading& reading);

}  // namespace phrame
