#pragma once
#include "phrame/ph/construct/quintic_choice.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// How far a curve is from its data, or may be. Where a kind of curve takes only the directions of
/// the derivatives, their deviation is an angle in radians.
struct Deviation {
  Rational points;             ///< the greatest distance from a point
  Rational derivatives;        ///< the greatest distance of a derivative from the one wanted
  Rational accelerations = 0;  ///< that of a second derivative, where these are given
  Rational lengths = 0;        ///< the greatest difference of a segment's length, where it is given
  friend bool operator==(const Deviation&, const Deviation&) = default;
};

/// Are all of them at most those of the tolerance?
inline bool is_within(const Deviation& deviation, const Deviation& tolerance) {
  return deviation.points <= tolerance.points && deviation.derivatives <= tolerance.derivatives &&
         deviation.accelerations <= tolerance.accelerations &&
         deviation.lengths <= tolerance.lengths;
}

/// How the points are met.
enum class PointRule {
  near,  ///< within the tolerance
  exact  ///< exactly; there are then several segments between two points
};

/// An exact curve near its data.
struct Construction {
  PhPath path;                       ///< the curve, or the spline
  std::vector<Rational> parameters;  ///< the parameters of the data at the ends and the joints
  std::vector<FreeAngles> angles;    ///< of quintics, those of each segment; else empty
  /// The coefficients of A are multiples of 2^−bits, but for the segments that close a spline, and
  /// but for four kinds: those of cubics are products of two such numbers; those of septics with
  /// h = 0, between the joints, are products of several, over 3; those of degree 9 also have a
  /// quarter of the step of the parameter as a factor; those of RRMF quintics are near such numbers
  /// times an integer.
  long bits;
  Deviation deviation;  ///< proved: not less than the greatest distances from the data
};

}  // namespace phrame
