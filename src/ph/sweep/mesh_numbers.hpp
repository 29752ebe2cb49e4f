#pragma once
#include "phrame/ph/sweep/mesh.hpp"

namespace phrame::inline v0 {

/// A mesh with coordinates that are floats, and how far its points are from those it was made of.
struct MeshInFloats {
  Mesh mesh;
  double error;  ///< a bound of the distances
};
/// The same mesh from another origin.
MeshInFloats in_floats(const Mesh& mesh, const Vector<Rational>& origin);

/// An origin in doubles, for a node of glTF, which has it: that of the mesh, or where that is 0 one
/// near the body.
Vector<Rational> node_origin(const Mesh& mesh);

/// Of such numbers.
double greatest_coordinate(Coordinates numbers);
/// For a watertight mesh as one that a file has numbers of. Throws Undecided, which names the way
/// out, where two points are the same in such numbers, or a triangle has no area, or a coordinate
/// is none of them: all of that is decided exactly.
void require_apart(const Mesh& mesh, Coordinates numbers);
/// Throws Undecided: "sweep: `what`; …", with the way out.
[[noreturn]] void fail_for_numbers(const std::string& what, Coordinates numbers);

}  // namespace phrame
