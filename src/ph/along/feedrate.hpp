#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame {

/// A feedrate: the speed V = ds/dt at which a tool moves along a curve, a rational function of one
/// of the curve's own quantities. Constant, linear or quadratic in the arc length, any polynomial
/// in the parameter, V₀/(1 + κd) for a plane curve: all are of this kind [Farouki 2008].
struct Feedrate {
  /// The quantity that the speed is a function of.
  enum class Of {
    arc_length,  ///< s
    parameter,   ///< t
    curvature,   ///< κ, signed, of a plane curve
  };
  RationalFunction speed;  ///< V, of that quantity
  Of of = Of::arc_length;  ///< which one it is

  friend bool operator==(const Feedrate&, const Feedrate&) = default;
};

/// Where a curve begins that is a segment of a path: what the quantities of the path are there.
struct SegmentStart {
  Rational parameter = 0;   ///< of the path
  Rational arc_length = 0;  ///< from the start of the path
};

/// V as a function of the parameter t ∈ [0, 1] of the curve. Throws DomainError where the curvature
/// is asked for and is no rational function (signed_curvature says why), and where f changes sign
/// on [0, 1].
RationalFunction speed_along(const Curve& curve, const Feedrate& feedrate,
                             const SegmentStart& start = {});

/// |f|σ/V, the rate dT/dt at which time passes. Throws DomainError as above and where V is not
/// positive and finite on all of [0, 1]: decided exactly, with the place of the zero or the pole.
RationalFunction travel_time_rate(const Curve& curve, const Feedrate& feedrate,
                                  const SegmentStart& start = {});

}  // namespace phrame
