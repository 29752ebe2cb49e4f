#pragma once
#include <variant>

#include "phrame/algebra/angle.hpp"

namespace phrame::inline v0 {

/// The rule by which one of the PH quintics with the same Hermite data is chosen. Rules other than
/// `energy` choose Δ and have φ = 0.
enum class QuinticSelection {
  automatic,  ///< whichever of minimal, bv and cc has the least bending energy
  minimal,    ///< Δ = 0: the minimal rotation from d₀ to d₁
  bv,         ///< next to a PH cubic: |A₀ − 2A₁ + A₂| is least
  cc,         ///< S(A₀, A₂) is next to the middle leg of the ordinary cubic with these data
  shortest,   ///< the shortest of all
  longest,    ///< the longest of all
  energy      ///< automatic, then downhill to a local minimum of ∫κ² ds over Δ and φ
};

/// The two free parameters: Δ = arg H(A₀, A₂), φ = arg H(A₀ + A₂, 3A₀ + 4A₁ + 3A₂). Rotations of
/// the data leave them alone; the length depends on Δ only.
struct FreeAngles {
  Angle delta;  ///< Δ
  Angle phi;    ///< φ
  friend bool operator==(const FreeAngles&, const FreeAngles&) = default;
};

/// The free angles φ₀, φ₁, φ₂ of the literature [Farouki 2007], one for each of the equations
/// Aᵢ i Aᵢ* = … that define the quintic: Aᵢ is the solution with positive α, multiplied on the
/// right by i and exp(φᵢ i). Adding one number to all three leaves the curve as it is.
struct SolutionAngles {
  double phi0;  ///< φ₀
  double phi1;  ///< φ₁
  double phi2;  ///< φ₂
};

/// Which of the quintics is wanted: by a rule, or by angles that all segments share.
using QuinticChoice = std::variant<QuinticSelection, FreeAngles, SolutionAngles>;

}  // namespace phrame
