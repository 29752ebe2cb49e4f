#pragma once
#include <string_view>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// The curve in a STEP file (ISO 10303-21), in its unit of length: what a GEOMETRIC_CURVE_SET has,
/// curves that meet being one, an EDGE_CURVE of a body, or a curve that nothing refers to; of
/// several the one that is picked by its name or number, "#12". Curves are
/// B_SPLINE_CURVE_WITH_KNOTS, rational ones too, POLYLINE, and LINE, CIRCLE and ELLIPSE between
/// ends, TRIMMED_CURVE and COMPOSITE_CURVE of these. Splines and polylines are exact, lines from
/// end to end; of arcs both ends are kept, as arc_between() does. Throws InputError, its place
/// "line 3", for other curves, by their names, and where there is no curve or several.
PointCurve read_step(std::string_view text, const FileReading& reading, const CurveLimits& limits);

}  // namespace phrame
