#pragma once
#include <string>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// Sums, multiples and products of vectors and quaternions, over any numbers: doubles, BigFloat,
// integers, fractions.

/// The sum.
template <class T>
Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The difference.
template <class T>
Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// c·a.
template <class T>
Vector<T> operator*(const T& c, const Vector<T>& a) {
  return {c * a[0], c * a[1], c * a[2]};
}

/// a·b = a₁b₁ + a₂b₂ + a₃b₃.
template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a × b.
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The sum.
template <class T>
Quaternion<T> operator+(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u + b.u, a.v + b.v, a.p + b.p, a.q + b.q};
}

/// The difference.
template <class T>
Quaternion<T> operator-(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u - b.u, a.v - b.v, a.p - b.p, a.q - b.q};
}

/// c·a.
template <class T>
Quaternion<T> operator*(const T& c, const Quaternion<T>& a) {
  return {c * a.u, c * a.v, c * a.p, c * a.q};
}

/// A*.
template <class T>
Quaternion<T> conjugate(const Quaternion<T>& a) {
  return {a.u, -a.v, -a.p, -a.q};
}

Vector<Polynomial> differentiate(const Vector<Polynomial>& v);  ///< v′
Vector<Polynomial> as_polynomials(const Vector<Rational>& v);   ///< v, a constant
Polynomial gcd(const Vector<Polynomial>& v);                    ///< of its components

/// "(1, 0, 2/3)", long numbers cut in the middle.
std::string abbreviated(const Vector<Rational>& v);

}  // namespace phrame
