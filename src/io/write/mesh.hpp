#pragma once
#include <string>

#include "phrame/answer/sweep.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/sweep/mesh.hpp"

namespace phrame::inline v0 {

// A mesh as files of other programs: bytes, little-endian where they are numbers. Coordinates are
// from the origin of the mesh. A comment says it where it is not 0, and has the remark of the mesh,
// for which the 80 characters of STL are too few. Where formats have floats, other numbers are
// rounded to such: in_floats() is that beforehand, with a bound.

/// Wavefront OBJ: text, coordinates in the fewest digits that are theirs.
PHRAME_API std::string to_obj(const Mesh& mesh);
/// Binary PLY with coordinates in doubles.
PHRAME_API std::string to_ply(const Mesh& mesh);
/// Binary STL, with coordinates in floats.
PHRAME_API std::string to_stl(const Mesh& mesh);
/// glTF 2.0 in one binary file, with coordinates in floats, as they are, of which glTF takes y for
/// up, beside a translation to the origin, rounded to doubles.
PHRAME_API std::string to_glb(const Mesh& mesh);

/// The remark about a body: where the frame starts in which the profile was swept.
PHRAME_API std::string sweep_remark(const SweepQuery& query);

}  // namespace phrame
