#pragma once
#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/rational_function.hpp"

namespace phrame {

/// A ball around ∫ₐᵇ f by Arb's certified numerical quadrature, with a radius of about 2^−bits; a
/// wide or infinite one where that fails, as at a pole on [a, b]. It knows no antiderivative and no
/// root: the other way to a value [Johansson 2018].
RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b, long bits);

}  // namespace phrame
