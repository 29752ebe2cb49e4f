#pragma once
#include "phrame/algebra/ball.hpp"

namespace phrame {

/// Disjoint enclosures of all roots of a squarefree polynomial over ℚ, one root in each.
struct Roots {
  std::vector<RealBall> real;      ///< exactly real, ascending
  std::vector<ComplexBall> upper;  ///< imaginary part > 0; the conjugates are not listed
};

/// Every root of p, with a relative accuracy of about `bits` bits. Certified: the number of
/// enclosures is the degree. Throws DomainError where p is constant or not squarefree.
/// Cost: the largest single cost of an evaluation (seconds beyond degree 150).
Roots isolate_roots(const Polynomial& p, long bits);

/// Narrows the enclosures of isolate_roots(p, …) to about `bits` bits by interval Newton steps,
/// m − p(m)/p′(Z) with m the midpoint of Z, which keep the root of Z and converge quadratically.
void refine(const Polynomial& p, Roots& roots, long bits);

}  // namespace phrame
