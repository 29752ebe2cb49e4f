#pragma once
#include <string>
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// Why a hodograph has no form f · A i A* over ℚ: |r′|² = radicand · odd_factor · (a square in
/// ℚ[t]), and not both are 1.
struct NotPythagorean {
  /// Squarefree, primitive. Where it is 1, |r′| = √radicand · (a polynomial): the curve is PH over
  /// ℝ, but |f|·|A|² would be rational.
  Polynomial odd_factor;
  Integer radicand;  ///< ≥ 1; the rest of split_square
  friend bool operator==(const NotPythagorean&, const NotPythagorean&) = default;
};

/// Is a curve whose tangent has this direction H ≠ 0 one? It is where |H|² is a square in ℚ[t],
/// which a curve at random is soon seen not to be.
PHRAME_API bool is_pythagorean(const Vector<Polynomial>& direction);

/// One line: why not.
PHRAME_API std::string to_string(const NotPythagorean& reason);
/// Writes to_string(reason).
PHRAME_API std::ostream& operator<<(std::ostream& out, const NotPythagorean& reason);

/// The curve with the hodograph r′ and r(0) = start as r′ = f · A i A*, checked exactly, or why
/// there is no such form. A has the least degree, f is ±gcd(x′, y′, z′) up to a constant, with f >
/// 0 just after t = 0. A is then unique up to a factor on the right, A·c with c ∈ ℚ(i), |c| = 1,
/// which turns the Euler–Rodrigues frame about the tangent by a constant; of these A·iᵏ the one is
/// taken where the lowest coefficient of α = u + iv (of β = q + ip where α = 0) is in the first
/// quadrant. The numbers: f is primitive times an integer ≥ 1 that is no norm |c|² as far as
/// split_norm sees, mostly 1. Throws DomainError for r′ = 0, a point.
PHRAME_API std::variant<Curve, NotPythagorean> identify(const Vector<Polynomial>& hodograph,
                                                        const Vector<Rational>& start);
/// The same with r(0) = (0, 0, 0).
PHRAME_API std::variant<Curve, NotPythagorean> identify(const Vector<Polynomial>& hodograph);

/// A rational curve that may not be PH.
struct NamedRationalCurve {
  std::string name;     ///< may be empty
  RationalCurve curve;  ///< whose weight is no constant
};

/// The same of X/W: of a rational curve r′ = f · A i A*/W².
PHRAME_API std::variant<Curve, NotPythagorean> identify(const RationalCurve& curve);

}  // namespace phrame
