#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

// Straight lines, plane curves and helices, by the linear relations between x, y, z and σ, where
// (x, y, z) = A i A*. The multiplier of a curve does not matter. Vectors have coprime integer
// components.

/// a·b.
PHRAME_API Polynomial dot(const Vector<Rational>& a, const Vector<Polynomial>& b);

/// The direction of A i A* on a straight line; no value for other curves.
PHRAME_API std::optional<Vector<Rational>> line_direction(const QuaternionPolynomial& a);

/// n with n·A i A* = 0: the normal of a plane curve, and one of those of a straight line; no value
/// for other curves.
PHRAME_API std::optional<Vector<Rational>> plane_normal(const QuaternionPolynomial& a);

/// The tangent of what is not plane has a constant angle ψ to an axis, cos ψ = constant/|axis|:
///   axis·A i A* = constant·σ, constant > 0.
struct ConstantAngle {
  Vector<Rational> axis;    ///< with coprime integer components
  Rational constant;        ///< cos ψ·|axis|, > 0
  Rational cosine_squared;  ///< cos²ψ, strictly between 0 and 1
  friend bool operator==(const ConstantAngle&, const ConstantAngle&) = default;
};

/// A curve with a constant angle.
struct Helix : ConstantAngle {
  /// The degree of the tangent as a rational map to its circle: 1 for the monotone-helical quintics
  /// of [Farouki, Giannelli, Sestini 2009], where the circle is traced once, 2 for the general
  /// ones.
  long map_degree;
  /// Does the tangent go round the circle in one sense only, for all real t?
  bool is_monotone;
  friend bool operator==(const Helix&, const Helix&) = default;
};
/// No value where there is no such axis, and for plane curves and straight lines.
PHRAME_API std::optional<Helix> helix(const QuaternionPolynomial& a);

// The same of a path: one line, one plane, one angle to one axis for all of its segments.

/// @{ One line, one plane, one angle to one axis for all segments of a path; no value where there
/// is none.
PHRAME_API std::optional<Vector<Rational>> line_direction(const PhPath& path);
PHRAME_API std::optional<Vector<Rational>> plane_normal(const PhPath& path);
PHRAME_API std::optional<ConstantAngle> helix(const PhPath& path);
/// @}

}  // namespace phrame
