#pragma once
#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Enclosures of all roots of a squarefree polynomial over ℚ, one root in each.
struct Roots {
  std::vector<RealBall> real;      ///< exactly real, ascending
  std::vector<ComplexBall> upper;  ///< imaginary part > 0, left to right; no conjugates
};

/// Every root of p, with a relative accuracy of about `bits` bits. Certified: the number of
/// enclosures is the degree. From a guess in double precision by the iteration of Ehrlich and
/// Aberth in as many bits as are needed to prove it, and from there on by `refine`.
/// Throws DomainError where p is constant or not squarefree.
PHRAME_API Roots isolate_roots(const Polynomial& p, long bits);

/// Are doubles too coarse to place any root of p ≠ 0, as when all roots lie in large clusters? Then
/// isolate_roots() takes far longer. This is a guess, in a hundredth of its time.
PHRAME_API bool has_no_clear_root(const Polynomial& p);

/// Narrows the enclosure of one real root of p to a relative accuracy of about `bits` bits, by
/// interval Newton steps; false where they do not reach that.
PHRAME_API bool refine(const Polynomial& p, RealBall& root, long bits);

/// Narrows the enclosures of isolate_roots(p, …) to about `bits` bits by interval Newton steps,
/// m − p(m)/p′(Z) with m the midpoint of Z, which keep the root of Z and converge quadratically.
/// Where they do not converge, Ehrlich's and Aberth's steps do the rest.
PHRAME_API void refine(const Polynomial& p, Roots& roots, long bits);

}  // namespace phrame
