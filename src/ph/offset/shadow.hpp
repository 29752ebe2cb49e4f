#pragma once
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// Is all of the curve from `lower` to `upper` seen to be nearer than |d| to the base, a curve in
/// the same plane for t in [0, 1], given as X, Y and W > 0? It is where offsets to one side of two
/// curves nearly coincide, and one of these curves is in front: however little that is, it is
/// decided by one polynomial. Of a base that is no point, `beside` is a t of it next to the part;
/// false says nothing.
bool is_nearer_along(const RationalCurve& curve, const Rational& lower, const Rational& upper,
                     const Vector<Polynomial>& base, const Rational& beside, const Rational& d);

}  // namespace phrame
