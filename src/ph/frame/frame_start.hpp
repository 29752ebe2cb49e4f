#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/ph_path.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {

/// A start with f₂ along this vector, once that is projected to the normal plane.
struct StartNormal {
  Vector<Rational> vector;  ///< of any length, neither 0 nor along the tangent

  /// The start along this vector.
  explicit StartNormal(Vector<Rational> along) : vector(std::move(along)) {}
  friend bool operator==(const StartNormal&, const StartNormal&) = default;
};

/// Where f₂ is at the start of a path unless something else is asked for: the least rotation that
/// takes (1, 0, 0) to e₁ takes (0, 1, 0) to f₂, which is then turned about e₁ by an angle. Where e₁
/// is (−1, 0, 0) there is no least one, and (0, 1, 0) is taken. It depends on the tangent alone,
/// not on how the curve is given, and continuously but for that tangent; there is no rule for all
/// tangents that is continuous [Hairy ball theorem: Brouwer 1912].
struct LeastRotation {
  Angle turn = {};  ///< about e₁
  friend bool operator==(const LeastRotation&, const LeastRotation&) = default;
};

/// A vector whose projection to the normal plane is along f₂ of the LeastRotation for e₁: for
/// e₁ = H/|H| it is (−H₂, |H| + H₁, 0).
PHRAME_API Vector<Rational> least_rotation_normal(const Vector<Rational>& e1);

/// Where a rotation-minimizing frame starts, at t = 0 of the first segment: by the tangent there,
/// at an angle to the frame that angles are measured from, or with f₂ along a vector.
using FrameStart = std::variant<LeastRotation, Angle, StartNormal>;

/// θ(0) of a path that starts with this PH curve, exactly. That of a vector, and of a LeastRotation
/// before it is turned, is in (−π, π]. At a cusp the frames are those that are continued through
/// it; where the curve starts with an inflection, the Frenet frame is that of small t > 0. `up` is
/// v, where θ is measured from the frame of v. Throws DomainError for a vector that is 0 or along
/// the tangent, for such a v, and where θ is measured from the Frenet frame of a straight line. At
/// another t it is likewise, unless θ is measured from the Frenet frame.
PHRAME_API FrameAngle start_angle(const FrameStart& start, const Curve& first,
                                  Reference reference = Reference::euler_rodrigues,
                                  const Vector<Rational>& up = {}, const Rational& t = 0);
/// The same for a path of PH curves. Throws DomainError for Reference::up, too: there is
/// start_angle(start, PathAngle(path, v)).
PHRAME_API FrameAngle start_angle(const FrameStart& start, const PhPath& path,
                                  Reference reference = Reference::euler_rodrigues);

}  // namespace phrame
