#pragma once
#include <optional>

#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {

/// A real algebraic number x given by enclosures, with bounds that tell how near to 0 a polynomial
/// in x can come without being 0 there.
struct BoundedAlgebraic {
  Real::Enclosure enclose;
  Integer denominator = 1;  ///< denominator·x is an algebraic integer
  Rational size = 0;        ///< no conjugate of x is larger
  long conjugates = 1;      ///< there are no more of them, x included
};

/// Bounds beyond this are not counted further.
inline constexpr long many_conjugates = 1L << 40;

BoundedAlgebraic bounded(const RealAlgebraic& x);
BoundedAlgebraic operator+(const BoundedAlgebraic& x, const BoundedAlgebraic& y);

/// Is p(x) = 0, p ≠ 0? Decided by the product of the conjugates; no value where that needs more
/// than 2¹⁸ bits of x and fewer do not show p(x) ≠ 0. Cost: x to so many bits at worst, where
/// p(x) = 0.
std::optional<bool> is_root(const Polynomial& p, const BoundedAlgebraic& x);

/// x with its polynomial, which is guessed from digits of x (a short vector of a lattice) and then
/// proved by is_root(). No value where no polynomial of a degree ≤ largest_degree was found, which
/// does not prove that there is none, or where the proof is too long.
std::optional<RealAlgebraic> recognized(const BoundedAlgebraic& x, long largest_degree);

}  // namespace phrame
