#pragma once
#include <vector>

#include "phrame/ph/curve/plane_cubics.hpp"

namespace phrame::inline v0 {

/// Plane curves in parts, each a cubic.
struct PlaneParts {
  std::vector<CubicPart> parts;
  std::vector<std::size_t> curves;  ///< for each part what it is of
  Rational error;  ///< each cubic is within that of its part, at the same share of the parameter
};

/// A place on a part.
struct GapPlace {
  std::size_t part;  ///< of `parts`
  double share;      ///< of its parameter, exactly
};
/// The parameter of its curve, and the point of its cubic.
Rational parameter(const PlaneParts& curves, const GapPlace& at);
std::array<Rational, 2> point(const PlaneParts& curves, const GapPlace& at);

/// A stretch, perhaps over several parts, that is not all seen to be near other curves.
struct GapStretch {
  GapPlace from;
  GapPlace to;
  GapPlace farthest;  ///< of what was looked at
  double at_least;    ///< as far as it is there, but for errors
  bool is_proved;     ///< is that beyond the tolerance?
};

/// How far curves are from others.
struct PlaneGap {
  Rational lower;     ///< sup over a of inf over b of |a − b| is this at least …
  Rational upper;     ///< … and this at most
  GapPlace farthest;  ///< where it is `lower` at least
  std::vector<GapStretch>
      stretches;  ///< all else is within the tolerance; by curves and parameters
};

/// Of all points of `a` from the nearest ones of `b`, to three percent of what it is, or to the
/// errors; where that takes too many parts of parts, lower and upper are farther apart.
/// Precondition: there are parts in both, tolerance > 0. Cost: microseconds for each part of a
/// part, of which it takes about √(length²·κ/gap).
PlaneGap greatest_gap(const PlaneParts& a, const PlaneParts& b, const Rational& tolerance);

}  // namespace phrame
