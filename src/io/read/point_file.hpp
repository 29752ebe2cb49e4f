#pragma once
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/ph/construct/given_points.hpp"

namespace phrame::inline v0 {

/// A place in a JSON document; its definition is not public.
class JsonNode;

/// Reads points that a curve is to pass: a points/1 file (docs/construct.md) or a table.
/// In points/1, JSON, are `points`, a list of two or three coordinates each, and, as many of each,
/// `derivatives` or `tangents`, `accelerations` and `parameters`; all but the points may be left
/// out. `kind` is "polyline", if it is there: its points are these. `name` and `note` are for
/// people. A table is text (TextTable), of JSON, a list (JsonTable), or of NumPy (NpyTable). Its
/// columns are named x, y and z, or as position_column() knows them, and may be t, the parameter,
/// dx, dy, dz, the derivatives by t, and e1x, e1y, e1z, the tangents. Without t the first of time,
/// timestamp, parameter, u and s is the parameter, if its numbers increase. All others are skipped;
/// notes_on_columns() names them. Without names two columns are x, y, three x, y, z, and 8, 12 and
/// 16 poses (read_point_rows). Numbers are read exactly. Throws InputError for what is not of this
/// form, for fewer than two points, tangents that are 0, parameters that do not increase, and for a
/// point that is that before it, unless there are derivatives. The place is a JSON pointer, "line
/// 3", "line 3, y" or "row 3".
PHRAME_API GivenPoints read_points(std::string_view bytes, const FileReading& reading = {});
/// Reads what points/1 has at these keys, and no others.
PHRAME_API GivenPoints read_points(const JsonNode& node);

/// What a reader is to be told of the columns of a table, in sentences without a point: which of
/// another name is the parameter, and which were skipped.
PHRAME_API std::vector<std::string> notes_on_columns(const GivenPoints& given);
/// Skips a parameter_column that is not to be the parameter.
PHRAME_API void leave_parameters_out(GivenPoints& given, const std::string& why);

}  // namespace phrame
