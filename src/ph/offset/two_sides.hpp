#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/ph_path.hpp"
#include "phrame/ph/curve/plane_ball.hpp"

namespace phrame::inline v0 {

/// What a boundary curve is at the distance |d| from, at the same parameter.
struct SideFoot {
  std::size_t segment;                 ///< of the path
  std::optional<Rational> point = {};  ///< the parameter there, 0 or 1, of an arc about a point
  bool is_reversed = false;            ///< does the boundary curve go against the path?
};

/// Tells that boundary curves on different sides of a path do not meet, however little |d| is.
class TwoSides {
 public:
  /// `feet` are those of all boundary curves; none of a mitre. A half-circle about an end counts as
  /// one that goes against the path, on the other side.
  TwoSides(const PhPath& path, std::vector<std::optional<SideFoot>> feet);

  /// Is it seen that these arcs of boundary curves, one on each side, have no point in common?
  /// Cost: some products, and a Taylor polynomial for what of the path is between the two.
  bool are_apart(const CurveNode& a, const CurveNode& b) const;

 private:
  class Pair;

  /// The stretches of a segment between places where it turns back.
  struct Stretches {
    int first_sign;  ///< of r′·e₁ on the first one; it changes from one to the next
    std::vector<DoubleInterval> breaks;  ///< around the places in between, ascending
  };

  PlaneBall along(std::size_t segment, double from, double to) const;
  /// The sign of r′·e₁ on a part of a segment; 0 where it changes there, or nearly there.
  int sign_on(std::size_t segment, double from, double to) const;

  std::vector<std::optional<SideFoot>> feet_;
  std::vector<Vector<Polynomial>> tangents_;     ///< σ·e₁ of each segment
  std::vector<std::vector<PlaneBall>> corners_;  ///< and its Bernstein coefficients
  std::vector<Stretches> stretches_;
  bool is_closed_;
};

}  // namespace phrame
