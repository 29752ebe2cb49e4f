#pragma once
#include "phrame/algebra/disc_evaluation.hpp"
#include "phrame/algebra/numerical_integral.hpp"
#include "phrame/algebra/rational_function.hpp"

namespace phrame::inline v0 {

inline constexpr long most_points_by_default = 100'000;

/// A ball around ∫ₐᵇ f by Arb's certified numerical quadrature, with a radius of about 2^−bits; a
/// wide or infinite one where that fails, as at a pole on [a, b], or with so many values of f. The
/// precision rises with what f loses next to poles. It knows no antiderivative and no root: the
/// other way to a value [Johansson 2018].
RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b, long bits,
                    long most_points = most_points_by_default);

/// A ball around ∫₀¹ f, in the same manner, with `bits` + 64 + `more` bits of precision for f, of
/// whatever width is reached with so many values of f.
RealBall quadrature(const AnalyticFunction& f, long bits, long more,
                    long most_points = most_points_by_default);

}  // namespace phrame
