#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A disc that holds one root of q, above the real axis, and one that holds the residue of n/q
/// there. Integers stand for multiples of 2^−bits.
struct RootDisc {
  GaussianInteger center;   ///< of the disc of the root
  Integer radius;           ///< 0 for an exact root
  GaussianInteger residue;  ///< the center of the disc of the residue
  Integer residue_radius;   ///< and its radius
  friend bool operator==(const RootDisc&, const RootDisc&) = default;
};

/// Have the two discs of roots no point in common?
PHRAME_API bool are_apart(const RootDisc& a, const RootDisc& b);

/// Discs for all roots of the squarefree q above the real axis, from left to right, that integers
/// can prove (docs/certificate.md); they depend on nothing but the numbers q, n and bits, so that
/// every machine finds the same. No value where the grid is too coarse. q has coprime integer
/// coefficients and no real root, deg n < deg q.
PHRAME_API std::optional<std::vector<RootDisc>> root_discs(const Polynomial& q, const Polynomial& n,
                                                           long bits);

/// The least r with d·|q(z)| ≤ r·|q′(z)|, so that q, of degree d ≥ 1, has a root within r of the
/// center z; none where q′(z) = 0.
PHRAME_API std::optional<Integer> radius_of_root(const Polynomial& q, const GaussianInteger& center,
                                                 long bits);

/// Is the residue of n/q at each root in the disc within `residue_radius` of `residue`, by the law
/// of docs/certificate.md?
PHRAME_API bool holds_residue(const Polynomial& q, const Polynomial& n, const RootDisc& disc,
                              long bits);

/// What Σ c(z)·log((t − z)/(−z)) over all roots may be off, with their discs, where |t| ≤ reach.
PHRAME_API Rational log_error(const std::vector<RootDisc>& discs, long bits, const Rational& reach);

}  // namespace phrame
