#pragma once
#include "phrame/answer/sweep.hpp"
#include "phrame/ph/sweep/mesh_sink.hpp"

namespace phrame::inline v0 {

/// What answer(named, query) is, but for points and triangles, which go to `out` as they are made.
SweepAnswer answer(const NamedPath& named, const SweepQuery& query, MeshSink& out);

}  // namespace phrame
