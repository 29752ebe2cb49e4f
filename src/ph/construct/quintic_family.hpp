#pragma once
#include <array>
#include <optional>

#include "phrame/algebra/angle.hpp"
#include "phrame/ph/construct/preimage.hpp"

namespace phrame {

/// What a segment on [0, 1] is to have: r(1) − r(0), r′(0) and r′(1).
template <class T>
struct HermiteData {
  Vector<T> step;
  Vector<T> d0;
  Vector<T> d1;
};

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
  Angle delta;
  Angle phi;
  friend bool operator==(const FreeAngles&, const FreeAngles&) = default;
};

/// The angles φ₀, φ₁, φ₂ of the solutions of Aᵢ i Aᵢ* = … in the literature: A = exp(φ i) from the
/// right times the solution whose α is positive, times i [Farouki 2007].
/// Adding the same number to all three changes nothing.
struct SolutionAngles {
  double phi0;
  double phi1;
  double phi2;
};

/// All quintics r′ = A i A*, A quadratic, with the data given, in doubles: guesses, which decide
/// the shape and nothing else. With c = 120·step − 15(d₀ + d₁) + 10·S(A₀, A₂) and
/// B = 3A₀ + 4A₁ + 3A₂ the condition on A₁ is B i B* = c, so that for every Δ and φ there is one.
/// Data of any size are wanted scaled, such that squares of them neither overflow nor underflow.
class QuinticFamily {
 public:
  explicit QuinticFamily(const HermiteData<double>& data);

  FreeAngles choose(QuinticSelection selection) const;
  /// Throws DomainError where d₀, d₁ or c is in the direction −x, which has no such solution.
  FreeAngles angles(const SolutionAngles& given) const;

  /// The Bernstein coefficients of A.
  using Member = std::array<Quaternion<double>, 3>;
  Member member(double delta, double phi) const;
  double length(double delta) const;

 private:
  Vector<double> c(double delta) const;
  /// Of A₀ − 2A₁ + A₂, four times the square of its size, the least of all φ.
  double distance_from_cubic(double delta) const;
  double cc_angle() const;
  double of_least_energy(double delta, double& phi) const;

  HermiteData<double> data_;
  Quaternion<double> a0_;
  Quaternion<double> a2_;  ///< of Δ = 0
  double g_;               ///< H(A₀, A₂) of Δ = 0
  Vector<double> a_;       ///< S(A₀, A₂) = a cos Δ + b sin Δ
  Vector<double> b_;
  double s0_;
  double s1_;
};

/// ∫κ² ds of r′ = A i A* by quadrature in doubles, about 8 digits of smooth curves; ∞ at a cusp.
double approximate_energy(const QuinticFamily::Member& a);
/// ∫|κ| ds likewise: how much the tangent turns.
double approximate_turning(const QuinticFamily::Member& a);

/// An |H(A, B)| below this, beside |A||B|, is rounding: the tangents are antiparallel, and the
/// preimages of both stay as they are.
inline constexpr double antiparallel = 0x1p-46;

}  // namespace phrame
