#pragma once
#include "phrame/ph/curve/crossings.hpp"
#include "phrame/ph/offset/offset.hpp"

namespace phrame {

/// Where the offset meets itself, with segments that are pieces of it. Where a piece ends on
/// another one, both branches crossing there, that is one of the places; at a joint it is told of
/// the piece that begins there.
SelfIntersections self_intersections(const Offset& offset);

}  // namespace phrame
