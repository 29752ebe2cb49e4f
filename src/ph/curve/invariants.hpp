#pragma once
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

// The polynomials that the frames of a PH curve are made of. What depends on the preimage only is a
// function of A = u + vi + pj + qk; α = u + iv, β = q + ip is its Hopf form.

/// σ = |A|² = u² + v² + p² + q²; |r′| = |f|·σ.
PHRAME_API Polynomial sigma(const QuaternionPolynomial& a);
/// h = uv′ − u′v − pq′ + p′q = Im(ᾱα′ + β̄β′). The ERF turns about the tangent with 2h/σ.
PHRAME_API Polynomial twist_numerator(const QuaternionPolynomial& a);
/// g = αβ′ − α′β: the ERF components of the derivative of the tangent are ±2·Im g/σ, 2·Re g/σ.
PHRAME_API GaussianPolynomial bend_numerator(const QuaternionPolynomial& a);
/// ρ = 4|g|²; |r′ × r″|² = f⁴σ²ρ.
PHRAME_API Polynomial rho(const QuaternionPolynomial& a);

/// ρ = constant·ω², with ω primitive: then |r′ × r″| = √constant·|f²σω| is a polynomial, up to its
/// sign, over ℝ, and κ, n and b are rational over ℚ(√constant). For a straight line ρ = 0 = 0·1².
struct DoublePh {
  Rational constant;  ///< > 0, also where it is a square; 0 for a straight line
  Polynomial omega;   ///< primitive
  friend bool operator==(const DoublePh&, const DoublePh&) = default;
};
/// No value where a factor of ρ has an odd exponent. All helices have one [Beltran, Monterde 2007].
PHRAME_API std::optional<DoublePh> double_ph(const QuaternionPolynomial& a);

/// (r′ × r″)·r‴ = f³(2hρ − 4 Im(g′ḡ)σ). Throws DomainError for a rational curve; what follows is of
/// these, too, with f/W² for f.
PHRAME_API Polynomial triple_product(const Curve& curve);
/// κ² = ρ/(f²σ⁴). The curvature of a cusp is a pole.
PHRAME_API RationalFunction squared_curvature(const Curve& curve);
/// τ = (r′ × r″)·r‴/|r′ × r″|². Throws DomainError for a straight line.
PHRAME_API RationalFunction torsion(const Curve& curve);

/// ω² = κ² + τ²: the Frenet frame turns by ω per unit of arc length, a rotation-minimizing frame by
/// κ [Farouki 2003, (5)]. Throws DomainError for a straight line.
PHRAME_API RationalFunction squared_frenet_rate(const Curve& curve);
/// ω²·fσ, the same by t where f > 0. Throws likewise.
PHRAME_API RationalFunction frenet_rate_by_t(const Curve& curve);
/// The signed curvature of a plane curve, (r′ × r″)·n/|r′|³ with the unit normal n of its plane
/// whose last component that is not 0 (z, else y, else x) is positive: in the xy-plane κ > 0 is a
/// left turn. 0 for a straight line. |f| stands for ±f as on [0, 1]. Throws DomainError where the
/// curve is not plane, n is not rational or f changes sign on [0, 1].
PHRAME_API RationalFunction signed_curvature(const Curve& curve);

/// The split (15) of [Farouki 2003], triple_product = f³(a·ρ + b·σ), in closed form:
/// a = 2h, b = −4 Im(g′ḡ). Then θ_Frenet′ = −a/σ − b/ρ.
struct AngleSplit {
  Polynomial a;  ///< of ρ
  Polynomial b;  ///< of σ
  friend bool operator==(const AngleSplit&, const AngleSplit&) = default;
};
/// Of the curves with this preimage.
PHRAME_API AngleSplit closed_split(const QuaternionPolynomial& preimage);

}  // namespace phrame
