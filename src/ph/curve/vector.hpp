#pragma once
#include <string>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

// Sums, multiples and products of vectors and quaternions, over any numbers: doubles, BigFloat,
// integers, fractions.

template <class T>
Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class T>
Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
Vector<T> operator*(const T& c, const Vector<T>& a) {
  return {c * a[0], c * a[1], c * a[2]};
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
Quaternion<T> operator+(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u + b.u, a.v + b.v, a.p + b.p, a.q + b.q};
}

template <class T>
Quaternion<T> operator-(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.u - b.u, a.v - b.v, a.p - b.p, a.q - b.q};
}

template <class T>
Quaternion<T> operator*(const T& c, const Quaternion<T>& a) {
  return {c * a.u, c * a.v, c * a.p, c * a.q};
}

/// A*.
template <class T>
Quaternion<T> conjugate(const Quaternion<T>& a) {
  return {a.u, -a.v, -a.p, -a.q};
}

/// "(1, 0, 2/3)", long numbers cut in the middle.
std::string abbreviated(const Vector<Rational>& v);

}  // namespace phrame
