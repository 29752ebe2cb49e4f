#pragma once
#include <string>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A curve/1 file that read_curve reads as the same curve, in the power basis.
PHRAME_API std::string write_curve(const NamedCurve& named);
/// The same of a path of segments of any kind: a spline/1 file where it is a spline. A PH segment
/// behind a PH or rational one does not say where it starts: where the one before ends. A rational
/// segment is written as control points with weights, where these are all > 0, as curve/1 wants
/// them, else as polynomials x, y, z over w.
PHRAME_API std::string write_path(const NamedPath& named);
/// Of paths, a file each on one line, which `phrame batch` reads; of a single one as above.
PHRAME_API std::string write_paths(const std::vector<NamedPath>& paths);

}  // namespace phrame
