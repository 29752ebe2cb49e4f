#pragma once
#include "phrame/ph/sweep/mesh_sink.hpp"
#include "phrame/ph/sweep/sweep.hpp"

namespace phrame::inline v0 {

/// The body of sweep(path, form), whose points and triangles go to `out` as they are made; its mesh
/// has neither. All is checked when it returns, and it throws the same: only where it does, or two
/// points happen to have the same hash, is there a whole mesh in memory.
SweptBody sweep(const SweepPath& path, const SweepForm& form, MeshSink& out);

}  // namespace phrame
