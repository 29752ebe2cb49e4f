#pragma once
#include "phrame/export.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/ph/construct/given_points.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// Reads a path of curves of any kind, exactly (docs/curve-files.md):
///   curve/1, with `preimage`, `quaternions`, `hopf` or `complex`; `control_points`, perhaps with
///   `weights`;
///   or `position`, polynomials x, y, z, perhaps over w;
///   spline/1, `segments` of these, of bspline/1 and nurbs/1;
///   bspline/1 and nurbs/1; points/1, a cubic spline through points; tables of points, of text,
///   NumPy or JSON; JSON of geomdl, three.js and SciPy; curves of Godot, polylines of OBJ and PLY;
///   SVG files and path data; G-code and APT; DXF; G2; animations in glTF.
/// A path all of whose segments are PH is read as that, with the same PhPath as read_path(), so
/// that it is answered exactly. Throws InputError; its place is a JSON pointer, line:column, "line
/// 3" or "row 3".
PHRAME_API NamedPath read_any_path(std::string_view text, const CurveLimits& limits = {},
                                   const FileReading& reading = {});
/// The same of a JSON document or a part of it, where a curve may do without "phrame": "curve/1".
PHRAME_API NamedPath read_any_path(const JsonNode& node, const CurveLimits& limits = {},
                                   const FileReading& reading = {});

/// Points that a curve is to pass: those of read_points() or, of a file of another format that
/// consists of lines, as OBJ, G-code, DXF and SVG may, their ends. Throws as read_points() and
/// read_any_path(), and InputError for a segment that is no line.
PHRAME_API GivenPoints read_waypoints(std::string_view text, const FileReading& reading = {});

}  // namespace phrame
