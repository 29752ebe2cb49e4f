#pragma once
#include <memory>
#include <string>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// A curve as it was read: its name, and its pieces.
struct PointCurve {
  std::string name;
  std::vector<GivenSegment> segments;
  std::vector<std::string> notes = {};  ///< what was assumed, as notes_on_columns()
};

/// A points/1 file as a curve: with "derivatives" the C¹ cubic spline that has them; else the C²
/// cubic spline of "kind" natural, clamped (with "start_derivative" and "end_derivative") or
/// periodic, natural where it is not said, with the "parameters" given, or of "spacing" uniform,
/// chord-length or centripetal, chord-length where it is not said
/// (ph/construct/cubic_interpolation.hpp). The kind polyline has the lines from point to point. A
/// last point that is the first one but for rounding is that one where the kind is periodic.
PointCurve read_point_curve(const JsonNode& node);

/// The same of a table (read_points). In comments of a text, "# kind:
/// periodic", may be kind, not clamped, and spacing; what the reading asks for comes first. With
/// the kind bezier or bspline the points are control points, with weights where there is a column
/// w: of one Bézier curve, or of a B-spline with clamped uniform knots, of degree 3 unless "#
/// degree: 4".
PointCurve read_point_table(std::string_view bytes, const CurveLimits& limits,
                            const FileReading& reading = {});

/// The natural cubic spline through the rows of a table whose columns are named; a periodic one
/// where they are those `of_a_loop`, the last point being the first.
PointCurve spline_through(std::unique_ptr<NumberTable> table, bool of_a_loop,
                          const FileReading& reading);

}  // namespace phrame
