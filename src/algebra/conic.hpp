#pragma once
#include <array>
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Whether y² = q(t) can be had with rational functions t and y of a parameter, for a q of degree 2
/// that is > 0 on ℝ: by lines through one rational point, if there is any.
struct ConicParameters {
  /// t and y by m, y² = q(t): each point of the curve is that of one m, ∞ included. No value where
  /// there is no rational point, or none is found.
  std::optional<std::array<RationalFunction, 2>> form;
  /// m of a point is (y − y₀)/(t − t₀) with the rational point (t₀, y₀), or y − √a·t without one.
  std::optional<std::array<Rational, 2>> base;
  /// Else, a prime p for which there is not even a point in ℚₚ [Legendre 1785]; 0 where it is not
  /// decided, since numbers of more than 2¹²⁸ were to be factored.
  Integer prime;
  Integer radicand;  ///< with √radicand, that of the leading coefficient, there are points; else 1
};

/// Legendre's criterion, by Hilbert's symbols, and Lagrange's descent to a point. Precondition: deg
/// q = 2, q > 0. Cost: factors of the leading coefficient, of the discriminant and, where there is
/// a point, of smaller numbers.
PHRAME_API ConicParameters conic_parameters(const Polynomial& q);
/// By lines through that point. Precondition: y² = q(t).
PHRAME_API ConicParameters conic_through(const Polynomial& q, const Rational& t, const Rational& y);

/// x ≥ 1 without square factors as far as factors() finds them: x = square²·rest.
PHRAME_API Integer squarefree_rest(const Integer& x);

}  // namespace phrame
