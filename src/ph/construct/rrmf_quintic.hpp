#pragma once
#include <array>
#include <optional>

#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/refine.hpp"

namespace phrame::inline v0 {

// Quintics with a rational rotation-minimizing frame, of class I: S(A₀, A₂) = A₁ i A₁*. With
// A₁ = A₀b this is A₂ = A₀q, q = τi − (b i b*)i, for any quaternion b and any number τ, and there
// are no others. The condition is that of [Farouki 2010].

/// Of r′ = A₀·(f·B i B*)·A₀*, B = (1, b, q): the curve turned such that it starts along x.
template <class T>
struct RrmfQuintic {
  Quaternion<T> b;
  T tau;  ///< τ
  T f;    ///< > 0
};

/// q.
template <class T>
Quaternion<T> last_coefficient(const RrmfQuintic<T>& x) {
  const Vector<T> v = rotated_i(x.b);
  return {v[0], x.tau, -v[2], v[1]};
}

/// f·∫ B i B* on [0, 1].
template <class T>
Vector<T> step_of(const RrmfQuintic<T>& x) {
  const Quaternion<T> one{T(1), T(0), T(0), T(0)};
  const Quaternion<T> q = last_coefficient(x);
  const Quaternion<T> middle = T(3) * (one + q) + T(4) * x.b;
  return T(x.f / T(120)) * (rotated_i(middle) + integral_of_ends(one, q));
}

/// Where it is to end, and in which direction. The preimage of that is of any size ≠ 0.
template <class T>
struct RrmfEnds {
  Vector<T> step;     ///< r(1) − r(0)
  Quaternion<T> end;  ///< a preimage of the direction
};

/// What it lacks: three coordinates of r(1) − r(0), and α_q β − β_q α with the preimage of the end,
/// which is 0 where both have one direction, or q = 0.
template <class T>
std::array<T, 5> rrmf_defect(const RrmfQuintic<T>& x, const RrmfEnds<T>& wanted) {
  const Vector<T> off = step_of(x) - wanted.step;
  const ComplexOf<T> turn = wedge(last_coefficient(x), wanted.end);
  return {off[0], off[1], off[2], turn.re, turn.im};
}

/// In doubles, for a step of about 1: of those found, for there is a one-parameter family if there
/// is any, one where energy times length is least nearby. No value where none is found.
std::optional<RrmfQuintic<double>> rrmf_quintic(const RrmfEnds<double>& wanted);

/// ∂(defect)/∂(u, v, p, q of b; τ; f), by differences.
JacobianRows rrmf_jacobian(const RrmfQuintic<double>& x, const RrmfEnds<double>& wanted);
/// Which of these six moves most along the solutions.
std::size_t freest_parameter(const RrmfQuintic<double>& x, const RrmfEnds<double>& wanted);

}  // namespace phrame
