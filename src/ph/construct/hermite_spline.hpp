#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/construct/given_points.hpp"

namespace phrame::inline v0 {

/// Points, derivatives and increasing parameters, as many of each: what a C¹ spline is to have. The
/// derivatives are those with respect to the parameter. Of a closed one the last point and
/// derivative are the first.
struct HermiteSpline {
  /// @{ One for each joint and end.
  std::vector<Vector<Rational>> points;
  std::vector<Vector<Rational>> derivatives;
  std::vector<Rational> parameters;
  /// @}
  bool is_closed = false;  ///< is the last joint the first?
  /// Second derivatives with respect to the parameter, where they are given: one for each, too.
  std::vector<Vector<Rational>> accelerations = {};
  /// Of poses the rotations of their frames (frame_rotation()), one for each, too: derivatives are
  /// along their e₁, exactly.
  std::vector<Quaternion<Integer>> frames = {};

  /// How many there are between the points.
  std::size_t segments() const { return points.size() - 1; }
  /// Of the parameter, from point k to the next.
  Rational step(std::size_t k) const { return parameters[k + 1] - parameters[k]; }
};

/// Where the derivatives of a spline come from.
enum class DerivativeSource { given, tangents, poses, natural_spline, periodic_spline };
/// The same of the parameters.
enum class ParameterSource { given, whole_numbers, chord_lengths };
/// @{ Where hermite_spline() takes them from.
PHRAME_API DerivativeSource derivative_source(const GivenPoints& given, bool is_closed);
PHRAME_API ParameterSource parameter_source(const GivenPoints& given);
/// @}

/// What the points given mean: derivatives as they are; tangents, and those of poses, with the
/// speed of the chords on both sides; else the derivatives of the C² cubic spline, natural or
/// periodic, rounded to 40 bits. Parameters as they are; else 0, 1, 2, … where derivatives are
/// given, and sums of chord lengths, rounded to 12 bits each, where they are not. A closed spline
/// ends at its first point, which is appended unless it is given at the end, perhaps rounded
/// (close_to_rounding()). Throws DomainError where two successive points are equal and their
/// distance is needed, and where a closed spline does not end with the first derivative, or
/// orientation.
PHRAME_API HermiteSpline hermite_spline(const GivenPoints& given, bool is_closed);

/// Throws DomainError where a derivative is 0 at a joint, so that the tangent would break there,
/// and where a segment is a point: its points are equal, its derivatives 0.
PHRAME_API void require_regular(const HermiteSpline& data);
/// Throws DomainError where a derivative is 0, of which a direction is wanted.
PHRAME_API void require_directions(const HermiteSpline& data,
                                   std::string_view what = "it has no direction");

/// The steps of the parameter.
struct ParameterSteps {
  std::vector<Integer> counts;  ///< times …
  Rational unit;                ///< … the greatest number of which all are multiples
};
/// Between the points.
PHRAME_API ParameterSteps parameter_steps(const HermiteSpline& data);

/// The greatest difference of a coordinate of two points; of points that are all equal, of what
/// the derivatives say the points do.
PHRAME_API Rational size_of_points(const HermiteSpline& data);
/// The greatest coordinate of a derivative.
PHRAME_API Rational size_of_derivatives(const HermiteSpline& data);
/// The greatest coordinate of an acceleration.
PHRAME_API Rational size_of_accelerations(const HermiteSpline& data);

/// The same data in units that powers of 4 make of about the size of chords and steps.
struct ScaledSpline {
  HermiteSpline data;
  Rational step_scale;      ///< of the parameter
  Vector<Rational> scales;  ///< of points, derivatives, accelerations
  Rational root;            ///< that A is to be multiplied by to come back
};
PHRAME_API ScaledSpline scaled(const HermiteSpline& data);

}  // namespace phrame
