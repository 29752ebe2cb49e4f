#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// A PH curve in a plane z = const with x + iy for (x, y): r′ = f·w² [Farouki 1994].
struct ComplexForm {
  Polynomial multiplier;    ///< f ∈ ℚ[t]
  GaussianPolynomial root;  ///< w = u + iq
  friend bool operator==(const ComplexForm&, const ComplexForm&) = default;
};

/// A = u + qk for w = u + iq: A i A* is w² as (x, y, 0).
PHRAME_API QuaternionPolynomial from_complex_root(const GaussianPolynomial& w);
/// That of a curve in such a plane; no value for others. f and A are as they are where A = u + qk;
/// else u and q have coprime integer coefficients and no factor in common, and f has all others.
PHRAME_API std::optional<ComplexForm> complex_form(const Curve& curve);

/// The Tschirnhausen cubic a·sec³(φ/3), |φ| < π, about its focus: a(1 − 3s², s(3 − s²)), which is
/// what each PH cubic in a plane is a part of, but for straight lines [Farouki, Sakkalis 1990].
struct TschirnhausenCubic {
  Rational vertex_at;       ///< t of the vertex, any: where the curvature is greatest, 2/(3a)
  Vector<Rational> vertex;  ///< r there
  Vector<Rational> focus;   ///< at the distance a from the vertex, on the axis, inside the loop
  Rational squared_scale;   ///< a²
  friend bool operator==(const TschirnhausenCubic&, const TschirnhausenCubic&) = default;
};
/// No value for curves that are no plane cubic, or straight.
PHRAME_API std::optional<TschirnhausenCubic> tschirnhausen_cubic(const Curve& curve);

}  // namespace phrame
