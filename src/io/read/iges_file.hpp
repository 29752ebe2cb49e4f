#pragma once
#include <string_view>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Does the text begin as an IGES file in ASCII?
bool is_iges_file(std::string_view text);

/// The curve in an IGES file [IGES 5.3], in its unit: entities 126 (B-spline), 110 (line), 100
/// (circular arc) and 102 (those in a row), under their matrices (124), that no other entity is
/// made of. Of a level, those that meet are one curve; of several --pick names one by its level or
/// the number of its directory entry, "D3". Splines and lines are exact; of arcs both ends are
/// kept. Throws InputError, its place "line 3", for other members of a 102, by their numbers, and
/// where there is no curve or several.
PointCurve read_iges(std::string_view text, const FileReading& reading, const CurveLimits& limits);

}  // namespace phrame
