#pragma once
#include <array>

#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Three components x, y, z.
template <class T>
using Vector = std::array<T, 3>;

/// u + v i + p j + q k with i² = j² = k² = ijk = −1, over ℚ or ℚ[t].
template <class T>
struct Quaternion {
  T u;  ///< the real part
  /// @{ The components of i, j and k.
  T v;
  T p;
  T q;
  /// @}
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// The product, not commutative.
template <class T>
Quaternion<T> operator*(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {
      a.u * b.u - a.v * b.v - a.p * b.p - a.q * b.q, a.u * b.v + a.v * b.u + a.p * b.q - a.q * b.p,
      a.u * b.p - a.v * b.q + a.p * b.u + a.q * b.v, a.u * b.q + a.v * b.p - a.p * b.v + a.q * b.u};
}

/// |A|² = A·A*.
template <class T>
T norm(const Quaternion<T>& a) {
  return a.u * a.u + a.v * a.v + a.p * a.p + a.q * a.q;
}

/// @{ A i A*, A j A*, A k A*: pure quaternions, |A|² times the columns of the rotation that A
/// means.
template <class T>
Vector<T> rotated_i(const Quaternion<T>& a) {
  const auto twice = [](const T& x) { return T(x + x); };
  return {a.u * a.u + a.v * a.v - a.p * a.p - a.q * a.q, twice(a.u * a.q + a.v * a.p),
          twice(a.v * a.q - a.u * a.p)};
}

template <class T>
Vector<T> rotated_j(const Quaternion<T>& a) {
  const auto twice = [](const T& x) { return T(x + x); };
  return {twice(a.v * a.p - a.u * a.q), a.u * a.u - a.v * a.v + a.p * a.p - a.q * a.q,
          twice(a.u * a.v + a.p * a.q)};
}

template <class T>
Vector<T> rotated_k(const Quaternion<T>& a) {
  const auto twice = [](const T& x) { return T(x + x); };
  return {twice(a.u * a.p + a.v * a.q), twice(a.p * a.q - a.u * a.v),
          a.u * a.u - a.v * a.v - a.p * a.p + a.q * a.q};
}
/// @}

/// A constant quaternion.
using RationalQuaternion = Quaternion<Rational>;
/// A curve in ℍ, such as the preimage of a PH curve.
using QuaternionPolynomial = Quaternion<Polynomial>;

/// The Hopf form A = α + kβ: α = u + iv, β = q + ip.
struct HopfForm {
  GaussianPolynomial alpha;  ///< u + iv
  GaussianPolynomial beta;   ///< q + ip
};
/// @{ The one from the other.
PHRAME_API HopfForm hopf_form(const QuaternionPolynomial& a);
PHRAME_API QuaternionPolynomial from_hopf_form(const HopfForm& form);
/// @}

PHRAME_API long degree(
    const QuaternionPolynomial& a);  ///< the greatest of the components; −1 for 0
PHRAME_API bool is_zero(const QuaternionPolynomial& a);  ///< are all components 0?
PHRAME_API RationalQuaternion evaluate(const QuaternionPolynomial& a, const Rational& t);  ///< A(t)
/// gcd(u, v, p, q): the greatest real polynomial that divides A.
PHRAME_API Polynomial real_content(const QuaternionPolynomial& a);
/// a over its real content ≠ 0: what its frames depend on.
PHRAME_API QuaternionPolynomial without_real_content(const QuaternionPolynomial& a);

/// @{ The components: "(1, 0, 2/3)", of a quaternion u, v, p, q.
PHRAME_API std::ostream& operator<<(std::ostream& out, const Vector<Rational>& v);
PHRAME_API std::ostream& operator<<(std::ostream& out, const Vector<Polynomial>& v);
PHRAME_API std::ostream& operator<<(std::ostream& out, const RationalQuaternion& a);
PHRAME_API std::ostream& operator<<(std::ostream& out, const QuaternionPolynomial& a);
/// @}

}  // namespace phrame
