#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// The legs L₀, L₁, L₂ of the control polygon of a PH cubic: L₀ and L₂ lie on a right circular cone
/// around L₁, of half-angle ϑ, and a turn by φ around L₁ takes one to the direction of the other. A
/// cubic is a PH curve if and only if there is such a cone and cos φ = 1 − 2|L₁|²/(|L₀||L₂|)
/// [Farouki 2007]; of a plane one φ is π.
struct ControlCone {
  Rational cosine_squared;  ///< cos²ϑ, less than 1
  bool is_obtuse;           ///< is ϑ greater than π/2, so that the polygon turns back?
  Rational azimuth_cosine;  ///< cos φ
  friend bool operator==(const ControlCone&, const ControlCone&) = default;
};
/// No value for curves of other degrees, straight lines, and where a leg is 0.
PHRAME_API std::optional<ControlCone> control_cone(const Curve& curve);

}  // namespace phrame
