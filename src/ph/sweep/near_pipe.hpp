#pragma once
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A path near to another one.
struct NearPipe {
  Path path;          ///< lines and arcs, smooth at the joints, whose unit tangents are over ℚ
  Rational distance;  ///< of its points to those of the other one at the same t, at most, proved
};

/// Of a path of lines and of arcs of circles of less than half a turn each, smooth but for
/// rounding, one whose unit tangents are rational functions over ℚ, so that it has exact surfaces:
/// directions, lengths, angles and radii are rounded to some ellipse_bits bits, and each piece
/// begins where the one before ends, with its tangent. What is no such path is far from it. Throws
/// DomainError for segments that are neither a line nor turn, and formulas.
NearPipe near_pipe(const Path& path);

}  // namespace phrame
