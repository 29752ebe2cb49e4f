#pragma once
#include "phrame/ph/construct/quintic_choice.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// How far a curve may be from its data, and how far it is. Of kinds that take the directions of
/// derivatives only, their deviation is an angle.
struct Deviation {
  Rational points;             ///< the greatest distance from a point
  Rational derivatives;        ///< of a derivative from the one wanted
  Rational accelerations = 0;  ///< of a second derivative, where they are wanted
  friend bool operator==(const Deviation&, const Deviation&) = default;
};

/// Is none greater than the tolerance?
inline bool is_within(const Deviation& deviation, const Deviation& tolerance) {
  return deviation.points <= tolerance.points && deviation.derivatives <= tolerance.derivatives &&
         deviation.accelerations <= tolerance.accelerations;
}

/// How the points are met.
enum class PointRule {
  near,  ///< within the tolerance
  exact  ///< by equal fractions; between two points there are then several segments
};

/// An exact curve near its data.
struct Construction {
  PhPath path;                       ///< the curve, or the spline
  std::vector<Rational> parameters;  ///< of the joints and the ends, those of the data
  std::vector<FreeAngles> angles;    ///< chosen for each segment of quintics; else none
  /// The coefficients of A are multiples of 2^−bits; but not those of what closes a spline. Of
  /// cubics they are products of two such, of septics with h = 0 those between the joints are
  /// products of several, over 3, and of degree 9 a quarter of the step of the parameter comes in.
  long bits;
  Deviation deviation;  ///< proved: not less than the greatest distances from the data
};

}  // namespace phrame
