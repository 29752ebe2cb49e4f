#pragma once

namespace phrame::inline v0 {

/// re + i·im over a ring: integers, fractions, polynomials, doubles.
template <class T>
struct ComplexOf {
  T re;  ///< the real part; of a polynomial for real t
  T im;  ///< the imaginary part

  friend bool operator==(const ComplexOf&, const ComplexOf&) = default;
  /// @{ Sums, differences, products and multiples, exact where those of T are.
  friend ComplexOf operator+(const ComplexOf& a, const ComplexOf& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend ComplexOf operator-(const ComplexOf& a, const ComplexOf& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend ComplexOf operator*(const ComplexOf& a, const ComplexOf& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend ComplexOf operator*(const T& c, const ComplexOf& a) { return {c * a.re, c * a.im}; }
  /// @}
  /// re − i·im.
  friend ComplexOf conjugate(const ComplexOf& a) { return {a.re, -a.im}; }
  /// |a|² = a·ā.
  friend T norm(const ComplexOf& a) { return a.re * a.re + a.im * a.im; }
};

}  // namespace phrame
