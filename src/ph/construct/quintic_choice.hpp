#pragma once
#include <variant>

#include "phrame/algebra/angle.hpp"

namespace phrame::inline v0 {

/// Which member of the family of PH quintics with the same Hermite data. `phi` is 0 but for
/// `energy`.
enum class QuinticSelection {
  automatic,  ///< of minimal, bv and cc that of least bending energy
  minimal,    ///< Δ = 0: the minimal rotation from d₀ to d₁
  bv,         ///< next to a PH cubic: |A₀ − 2A₁ + A₂| is least
  cc,         ///< S(A₀, A₂) is next to the middle leg of the ordinary cubic with these data
  shortest,   ///< of all lengths the least …
  longest,    ///< … and the greatest
  energy      ///< automatic, then downhill to a local minimum of ∫κ² ds over Δ and φ
};

/// The two free parameters: Δ = arg H(A₀, A₂), φ = arg H(A₀ + A₂, 3A₀ + 4A₁ + 3A₂). Rotations of
/// the data leave them alone; the length depends on Δ only.
struct FreeAngles {
  Angle delta;  ///< Δ
  Angle phi;    ///< φ
  friend bool operator==(const FreeAngles&, const FreeAngles&) = default;
};

/// The angles φ₀, φ₁, φ₂ of the solutions of Aᵢ i Aᵢ* = … in the literature: A = exp(φ i) from the
/// right times the solution whose α is positive, times i [Farouki 2007].
/// Adding the same number to all three changes nothing.
struct SolutionAngles {
  double phi0;  ///< φ₀
  double phi1;  ///< φ₁
  double phi2;  ///< φ₂
};

/// Which of the quintics: by a rule, or by angles, the same in all segments.
using QuinticChoice = std::variant<QuinticSelection, FreeAngles, SolutionAngles>;

}  // namespace phrame
