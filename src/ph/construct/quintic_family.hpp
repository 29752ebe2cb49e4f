#pragma once
#include <array>
#include <functional>

#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/quintic_choice.hpp"

namespace phrame::inline v0 {

/// What a segment on [0, 1] is to have: r(1) − r(0), r′(0) and r′(1).
template <class T>
struct HermiteData {
  Vector<T> step;  ///< r(1) − r(0)
  Vector<T> d0;    ///< r′(0)
  Vector<T> d1;    ///< r′(1)
};

/// All quintics r′ = A i A*, A quadratic, with the data given, in doubles: guesses, which decide
/// the shape and nothing else. With c = 120·step − 15(d₀ + d₁) + 10·S(A₀, A₂) and
/// B = 3A₀ + 4A₁ + 3A₂ the condition on A₁ is B i B* = c, so that for every Δ and φ there is one.
/// Data of any size are wanted scaled, such that squares of them neither overflow nor underflow.
class QuinticFamily {
 public:
  /// With these data.
  explicit QuinticFamily(const HermiteData<double>& data);

  /// The parameters of the member selected, rounded to 2⁻²⁰ of a half turn.
  FreeAngles choose(QuinticSelection selection) const;
  /// Those of the member with such angles. Throws DomainError where d₀, d₁ or c is in the direction
  /// −x, which has no such solution.
  FreeAngles angles(const SolutionAngles& given) const;

  /// The Bernstein coefficients of A.
  using Member = std::array<Quaternion<double>, 3>;
  Member member(double delta, double phi) const;  ///< with these parameters
  double length(double delta) const;              ///< ∫ |r′|, for any φ

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

/// The quintics with the data of segment k, in doubles, scaled: energies are not theirs.
QuinticFamily quintic_family(const HermiteSpline& data, std::size_t k);

/// x, in radians, rounded to 2⁻²⁰ of a half turn.
Angle rounded_angle(double x);
/// The x in (−π, π] with the least f, or about that; NaN counts as ∞.
double minimising_angle(const std::function<double(double x)>& f);

/// An |H(A, B)| below this, beside |A||B|, is rounding: the tangents are antiparallel, and the
/// preimages of both stay as they are.
inline constexpr double antiparallel = 0x1p-46;

}  // namespace phrame
