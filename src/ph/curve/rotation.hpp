#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "phrame/algebra/angle.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// Which axis of a body that moves along a curve is the tangent e₁. f₂ and f₃ are the next two of
/// x, y, z, x, y; where the tangent is the opposite of that axis they change places.
struct TangentAxis {
  std::size_t axis = 0;      ///< 0, 1, 2: x, y, z
  bool is_reversed = false;  ///< is the tangent its opposite?
  friend bool operator==(const TangentAxis&, const TangentAxis&) = default;
};

/// "x" to "-z".
PHRAME_API std::string name_of(const TangentAxis& axis);
/// All six by their names.
PHRAME_API const std::vector<std::pair<std::string, TangentAxis>>& tangent_axes();

/// How a body lies, over ℚ: the rotation v ↦ P v P*/|P|², P ≠ 0 of any length, that takes x, y, z
/// to its axes.
struct Orientation {
  RationalQuaternion rotation{1, 0, 0, 0};  ///< P
  /// Where it stands for rounded vectors: no axis of it is farther from the one given. 0 where they
  /// are these.
  Rational off = 0;
  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// The images of x, y, z by the rotation v ↦ P v P*/|P|², P ≠ 0: the columns of its matrix.
PHRAME_API std::array<Vector<Rational>, 3> rotation_columns(const RationalQuaternion& p);

/// The rotation next to a matrix with these columns, in the least squares of their distances: that
/// of its polar decomposition, exactly where the columns are orthonormal, else to some 60 bits. No
/// value where two columns are not orthogonal, or one is not of length 1, to within 1/100, and
/// where they are left-handed.
PHRAME_API std::optional<Orientation> nearest_rotation(
    const std::array<Vector<Rational>, 3>& columns);

/// P of the rotation by an angle about an axis, by the right hand: exactly where the angle over π
/// and the matrix are fractions, as by 90° about z or 120° about (1, 1, 1); else the angle is
/// within 2^−100 of that. Throws DomainError for the axis 0.
PHRAME_API RationalQuaternion rotation_about(const Vector<Rational>& axis, const Angle& angle);

/// The frame (e₁, f₂, f₃) of a body with this rotation, as integers without a common factor: Q with
/// e₁ along Q i Q*, f₂ along Q j Q* and f₃ along Q k Q*.
PHRAME_API Quaternion<Integer> frame_rotation(const RationalQuaternion& body,
                                              const TangentAxis& tangent);

}  // namespace phrame
