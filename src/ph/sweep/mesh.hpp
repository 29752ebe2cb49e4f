#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// Triangles that share points, each counterclockwise seen from outside.
struct Mesh {
  std::vector<Vector<double>> points;                   ///< each once
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< the numbers of three points each
  Vector<Rational> origin = {};                         ///< from which the coordinates are
  std::string remark = {};  ///< a sentence in ASCII that files of it carry as a comment
};

/// What the coordinates of a file are.
enum class Coordinates { doubles, floats };

/// Is the mesh the boundary of a body: does each side of a triangle lie opposite to just one other?
/// Decided by the numbers of the points, which are below the number of points. Cost: linear, as few
/// sides start in one point.
PHRAME_API bool is_watertight(const Mesh& mesh);
/// The number of the first triangle without an area, its corners being on one line or the same:
/// decided exactly, for the coordinates as they are.
PHRAME_API std::optional<std::size_t> first_flat_triangle(const Mesh& mesh);
/// Of a watertight mesh, in doubles.
PHRAME_API double volume(const Mesh& mesh);

}  // namespace phrame
