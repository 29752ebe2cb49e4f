#pragma once
#include <cmath>

#include "phrame/algebra/complex_of.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

// The algebra that interpolation by PH curves lives in, for any numbers: doubles for guesses,
// BigFloat for what is rounded, integers and fractions for what is exact.

/// A·(re + i·im). By a complex number of size 1 this leaves A i A* alone.
template <class T>
Quaternion<T> turned(const Quaternion<T>& a, const ComplexOf<T>& z) {
  return {a.u * z.re - a.v * z.im, a.u * z.im + a.v * z.re, a.p * z.re + a.q * z.im,
          a.q * z.re - a.p * z.im};
}

/// S(A, B) = ½(A i B* + B i A*), a vector, bilinear; S(A, A) = A i A*.
template <class T>
Vector<T> symmetric_product(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u * b.u + a.v * b.v - a.p * b.p - a.q * b.q,
          a.u * b.q + a.q * b.u + a.v * b.p + a.p * b.v,
          a.v * b.q + a.q * b.v - a.u * b.p - a.p * b.u};
}

/// 15(S(A₀, A₀) + S(A₂, A₂)) − 10·S(A₀, A₂): with B = 3A₀ + 4A₁ + 3A₂, 120·∫ A i A* of a quadratic
/// A on [0, 1] is B i B* and this.
template <class T>
Vector<T> integral_of_ends(const Quaternion<T>& a0, const Quaternion<T>& a2) {
  return T(15) * (rotated_i(a0) + rotated_i(a2)) - T(10) * symmetric_product(a0, a2);
}

/// 120·∫ A i A* of a quadratic A on [0, 1].
template <class T>
Vector<T> integral_times_120(const Quaternion<T>& a0, const Quaternion<T>& a1,
                             const Quaternion<T>& a2) {
  return rotated_i(T(3) * (a0 + a2) + T(4) * a1) + integral_of_ends(a0, a2);
}

/// H(A, B) = ᾱ_A·α_B + β̄_A·β_B for A = α + kβ. Its real part is the scalar product A·B, its
/// imaginary part ω(A, B); h = ω(A, A′). H(A, B·z) = z·H(A, B), and
/// |H(A, B)|² = ½(|A|²|B|² + S(A, A)·S(B, B)).
template <class T>
ComplexOf<T> hermitian_product(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u * b.u + a.v * b.v + a.p * b.p + a.q * b.q,
          a.u * b.v - a.v * b.u - a.p * b.q + a.q * b.p};
}

/// α_A·β_B − β_A·α_B: 0 where B is A times a complex number, so that both have one direction.
template <class T>
ComplexOf<T> wedge(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u * b.q - a.v * b.p - a.q * b.u + a.p * b.v,
          a.u * b.p + a.v * b.q - a.q * b.v - a.p * b.u};
}

/// A*·v·A: v turned back by the rotation that A means, |A|² times as long.
template <class T>
Vector<T> turned_back(const Vector<T>& v, const Quaternion<T>& a) {
  const Quaternion<T> w = conjugate(a) * (Quaternion<T>{T(0), v[0], v[1], v[2]} * a);
  return {w.v, w.p, w.q};
}

/// An A with A i A* = d, up to rounding; the others are A·z, |z| = 1. Without cancellation,
/// because the greater of |α|, |β| is the one that comes from a root: it is real and not negative.
/// 0 for 0.
template <class T>
Quaternion<T> preimage(const Vector<T>& d) {
  using std::sqrt;
  const auto& [x, y, z] = d;
  const T half(0.5);
  const T s = sqrt(dot(d, d));
  if (s == T(0.0)) return {T(0.0), T(0.0), T(0.0), T(0.0)};
  if (!(x < T(0.0))) {
    const T alpha = sqrt(half * (s + x));
    return {alpha, T(0.0), -(half * z / alpha), half * y / alpha};
  }
  const T beta = sqrt(half * (s - x));
  return {half * y / beta, half * z / beta, T(0.0), beta};
}

/// z/|z|; 1 where |z| ≤ `least`, so that its argument means nothing.
template <class T>
ComplexOf<T> direction_of(const ComplexOf<T>& z, const T& least) {
  using std::sqrt;
  const T size = sqrt(norm(z));
  if (!(least < size)) return {T(1.0), T(0.0)};
  return {z.re / size, z.im / size};
}

}  // namespace phrame
