#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {

/// factor·x + shift. Throws DomainError for factor = 0.
RealAlgebraic affine(const RealAlgebraic& x, const Rational& factor, const Rational& shift);

/// y(x) for a polynomial y: the root, near its value, of the characteristic polynomial of y in
/// ℚ[t]/(p), a power of an irreducible one, where p is the polynomial of x. Cost: that polynomial
/// and its squarefree part.
RealAlgebraic image(const Polynomial& y, const RealAlgebraic& x);
/// f(x). Throws DomainError at a pole.
RealAlgebraic image(const RationalFunction& f, const RealAlgebraic& x);

}  // namespace phrame
