#pragma once
#include <vector>

#include "phrame/algebra/rational.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A rational Bézier patch S(u, s) on [0, 1]², u around a profile and s along a path:
/// Σ wₖₗPₖₗBₖ(s)Bₗ(u)/Σ wₖₗBₖ(s)Bₗ(u), exactly.
struct SurfacePatch {
  Rational from;     ///< the parameter of the path at s = 0; it grows in proportion to s
  Rational to;       ///< at s = 1
  std::size_t side;  ///< of the profile: 0, 1, …
  /// @{ Rows along the path, each around the profile.
  std::vector<std::vector<Vector<Rational>>> points;
  std::vector<std::vector<Rational>> weights;  ///< > 0
  /// @}
};

/// The side of a swept body. Its normal S_u × S_s is outward.
struct RationalSurface {
  std::vector<SurfacePatch> patches;  ///< along the path, and around the profile at each place
  std::size_t sides = 0;              ///< of the profile
  std::vector<std::size_t> rings;     ///< of each of its rings, the first side: holes come last
  bool is_closed = false;             ///< are its ends one, so that it needs no caps?
};

}  // namespace phrame
