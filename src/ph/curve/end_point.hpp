#pragma once
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// r(1). Cost: that of the products of A's coefficients, integers over one denominator; no
/// polynomial r is made.
Vector<Rational> end_point(const Curve& curve);
/// Is r(1) this point? The first coordinate that differs tells, mostly in doubles.
bool ends_at(const Curve& curve, const Vector<Rational>& point);

}  // namespace phrame
