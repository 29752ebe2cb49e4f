#pragma once
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

// Where the graphs over t of what is seen of a segment turn round, so that a drawing through these
// places, too, shows each quantity as far as it goes.

/// What is seen.
enum class Plotted { theta, theta_rate, curvature, torsion, speed };

/// A place where it is greatest or least among its neighbours, or may be.
struct Turn {
  Plotted quantity;
  Rational at;   ///< in [0, 1], within 2⁻⁹⁰ of it
  double about;  ///< a guess of the value or of its square, which orders the turns of a quantity
};

/// The turns of a segment.
struct Turns {
  std::vector<Turn> list;         ///< in no order
  std::vector<Plotted> infinite;  ///< those with a pole in [0, 1]
  /// Is it proved that between these, the ends and the poles nothing goes farther, but for `slack`?
  bool are_all = true;
  double slack = 0;  ///< of the greatest size of a quantity
};

/// Of a PH curve, all five quantities: the zeros of the derivatives, which are rational.
Turns turns(const Curve& curve);
/// Of other curves κ and τ. Of rational ones likewise; of a curve by formulas the farthest values
/// only, to a thousandth, by enclosures on smaller and smaller parts.
Turns turns(const Segment& segment);

}  // namespace phrame
