#pragma once
#include <array>
#include <optional>

#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/refine.hpp"

namespace phrame::inline v0 {

// Septics r′ = A i A* with h ≡ 0, so that the Euler–Rodrigues frame, which is rational, is the
// rotation-minimizing one. Here in doubles: guesses, which decide the shape and nothing else.

/// The coefficients of a cubic A in Bernstein's basis.
template <class T>
using CubicPreimage = std::array<Quaternion<T>, 4>;

/// What a septic is to have, seen from its start: A = A₀·(1, b, b′, c), and r′ = A₀ v A₀* where v
/// is that of (1, b, b′, c). The tangents at its ends must not be parallel: c₀ has j or k.
struct SepticData {
  Vector<double> step;    ///< ∫ v from 0 to 1
  Quaternion<double> c0;  ///< c for the minimal rotation: its real part ≥ 0, its i 0
};

/// One of the septics with these data. b and b′ have no i; their components are those of 1, j, k.
struct SepticShape {
  double turn;  ///< c = c₀·e^{iπκt}, κ of phase_unit(); this is t
  Vector<double> b;
  Vector<double> b_prime;
};

/// A power of 2, about |j and k of c₀|/|c₀|: of the phase of c where tangents are nearly parallel.
double phase_unit(const SepticData& data);

/// The septic with h ≡ 0 of least energy ∫κ² ds that is found: of the solutions next to quintics
/// with the same data the best one, and from there downhill along the curve of solutions, all
/// rounded to 24 bits. No value where none is found.
std::optional<SepticShape> rmf_septic(const SepticData& data);

/// The Bernstein coefficients 1, b, b′, c.
CubicPreimage<double> septic_preimage(const SepticData& data, const SepticShape& shape);

/// The neighbours of a septic from which one is to be taken: on one side of the curve of solutions
/// to the other, so that there is exactly one solution in it.
class SepticSection {
 public:
  /// Through this shape; its phase is kept unless that cuts the curve of solutions at a small
  /// angle.
  SepticSection(const SepticData& data, const SepticShape& shape);

  bool keeps_phase() const { return keeps_phase_; }
  /// The solution in it, as nearly as doubles are; where none is found, the shape as it was.
  const SepticShape& solution() const { return solution_; }
  /// t, b, b′ ↦ what has to be added to them for the step to become greater by so much.
  std::vector<double> change(const std::vector<double>& of_step) const;

 private:
  SepticData data_;
  std::array<double, 7> across_;
  bool keeps_phase_;
  SepticShape solution_;
};

}  // namespace phrame
