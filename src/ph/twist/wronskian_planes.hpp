#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

// The pairs of polynomials a, b of degree ≤ n with ab′ − a′b = N, deg N ≤ 2n − 2: the system (24)
// of [Peng, Pang, Pan 2023], of rank 2n − 1 for 2n + 2 unknowns. With (a, b) it has (a, b)·G for
// all G with det G = 1, so that the plane which a and b span is what is looked for. Of planes there
// are finitely many: with their multiplicity as many as the Catalan number (2n − 2)!/((n − 1)!·n!),
// the degree of the Grassmannian: 1 for n = 2, 5 for n = 4.

/// One real plane, by its basis in normal form: with τ = t − origin
///   a = 1 + a₂τ² + a₃τ³ + …,  b = n₀τ + b₂τ² + …,  ab′ − a′b = N.
struct WronskianPlane {
  RealAlgebraic parameter;  ///< x: a₂, but where two planes have the same it is a₃
  /// @{ The coefficients of τ⁰, τ¹, …, n + 1 of them, as functions of x, which have no pole there.
  /// For every other x, too, ab′ − a′b − N is a number times τ²ⁿ⁻², or times (t − z)²τ²ⁿ⁻⁴.
  std::vector<RationalFunction> a;
  std::vector<RationalFunction> b;
  /// @}
  /// z, a common zero of a and b, and a double one of N; with every x, but where x is rational.
  std::optional<Rational> zero;
};

/// All planes of N.
struct WronskianPlanes {
  long degree;           ///< n
  Rational origin;       ///< the first of 0, 1, −1, 2, … where N is not 0
  Polynomial resolvent;  ///< its roots are the a₂ of all planes, with those that are not real
  std::vector<WronskianPlane> real;  ///< by ascending a₂, at least one
};

/// For n = 2 and n = 4. Throws DomainError for other n, for N = 0, and where its degree is higher
/// than 2n − 2.
PHRAME_API WronskianPlanes wronskian_planes(const Polynomial& wronskian, long n);

/// A pair of polynomials over ℚ next to the best one. The Euler–Rodrigues frame turned by
/// 2·arg(b + ia) is a rational frame, and ab′ − a′b = 2hσ + defect·(t − origin)²ⁿ⁻², or, with a
/// common zero z, 2hσ + defect·(t − z)²(t − origin)²ⁿ⁻⁴.
struct RationalPair {
  Rational parameter;  ///< of the plane
  /// @{ a = −b₀/g, b = g·a₀ + q·b₀ by the basis a₀, b₀ in normal form at that parameter.
  Rational g;
  Rational q;
  Polynomial a;
  Polynomial b;
  /// @}
  Rational defect;  ///< 0 where (24) is solved exactly, as only a rational parameter can
};

}  // namespace phrame
