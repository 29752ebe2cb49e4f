#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/construct/given_points.hpp"

namespace phrame::inline v0 {

/// What a C¹ spline is to have: a point, a derivative with respect to the parameter, and a
/// parameter for each joint and end, the parameters increasing. In a closed spline the last point
/// and derivative equal the first.
struct HermiteSpline {
  /// @{ One for each joint and end.
  std::vector<Vector<Rational>> points;
  std::vector<Vector<Rational>> derivatives;
  std::vector<Rational> parameters;
  /// @}
  bool is_closed = false;  ///< is the last joint the first?
  /// Second derivatives with respect to the parameter, one for each joint and end; empty where they
  /// are not given.
  std::vector<Vector<Rational>> accelerations = {};
  /// The rotations of the frames (frame_rotation()) where poses are given, one for each joint and
  /// end; empty otherwise. Each derivative is exactly along the e₁ of its frame.
  std::vector<Quaternion<Integer>> frames = {};

  /// The number of segments, one between each point and the next.
  std::size_t segments() const { return points.size() - 1; }
  /// The step of the parameter from point k to the next.
  Rational step(std::size_t k) const { return parameters[k + 1] - parameters[k]; }
};

/// Where the derivatives of a spline come from.
enum class DerivativeSource { given, tangents, poses, natural_spline, periodic_spline };
/// Where the parameters of a spline come from.
enum class ParameterSource { given, whole_numbers, chord_lengths };
/// @{ Where hermite_spline() takes derivatives and parameters from.
PHRAME_API DerivativeSource derivative_source(const GivenPoints& given, bool is_closed);
PHRAME_API ParameterSource parameter_source(const GivenPoints& given);
/// @}

/// Completes what is given. Derivatives are taken as they are; tangents, and those of poses, get
/// the speed of the chords on both sides; where there is neither, the derivatives are those of the
/// C² cubic spline through the points, natural or periodic, rounded to 40 bits. Parameters are
/// taken as they are; where there are none, they are 0, 1, 2, … if derivatives are given, and
/// otherwise sums of chord lengths, each rounded to 12 bits. A closed spline ends at its first
/// point, which is appended unless the last point is that one, perhaps rounded
/// (close_to_rounding()). Throws DomainError where two successive points are equal and their
/// distance is needed, and where a closed spline does not end with the derivative, or orientation,
/// that it starts with.
PHRAME_API HermiteSpline hermite_spline(const GivenPoints& given, bool is_closed);

/// Throws DomainError where the derivative at a joint is 0, because the tangent would break there,
/// and where a segment is a single point: both of its points are equal and both derivatives are 0.
PHRAME_API void require_regular(const HermiteSpline& data);
/// Throws DomainError where a derivative is 0, for curves that need its direction; `what` ends the
/// message.
PHRAME_API void require_directions(const HermiteSpline& data,
                                   std::string_view what = "it has no direction");

/// The steps of the parameter from point to point: step k is counts[k] · unit.
struct ParameterSteps {
  std::vector<Integer> counts;  ///< ≥ 1, with no common divisor
  Rational unit;                ///< the greatest number of which all steps are multiples
};
/// Those of these data.
PHRAME_API ParameterSteps parameter_steps(const HermiteSpline& data);

/// The greatest difference between the same coordinate of two points. Where all points are equal,
/// it is the greatest derivative times the range of the parameter.
PHRAME_API Rational size_of_points(const HermiteSpline& data);
/// The greatest absolute value of a coordinate of a derivative.
PHRAME_API Rational size_of_derivatives(const HermiteSpline& data);
/// The greatest absolute value of a coordinate of an acceleration.
PHRAME_API Rational size_of_accelerations(const HermiteSpline& data);

/// Data in units in which chords and steps are about 1, and the factors, powers of 4, between both.
struct ScaledSpline {
  HermiteSpline data;       ///< in these units
  Rational step_scale;      ///< the unit of the parameter
  Vector<Rational> scales;  ///< the units of points, derivatives and accelerations
  Rational root;            ///< A of the scaled curve times this is A of the curve wanted
};
/// The same data in such units.
PHRAME_API ScaledSpline scaled(const HermiteSpline& data);

}  // namespace phrame
