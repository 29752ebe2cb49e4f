#pragma once
#include <array>

#include "phrame/io/read/drawn_chain.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"

namespace phrame::inline v0 {

/// The curve A·x² + B·xy + C·y² + D·x + E·y + F = 0 of the plane z = 0: six coefficients in this
/// order.
using PlaneConic = std::array<Rational, 6>;

/// B² − 4AC: < 0 for ellipses, 0 for parabolas, > 0 for hyperbolas.
Rational discriminant(const PlaneConic& conic);

/// A point off the conic by ε is moved to within O(ε²) of it, by one step of Newton's method along
/// the gradient. Throws InputError (no place) where that is 0.
PlaneVector moved_onto(const PlaneConic& conic, const PlaneVector& p);

/// The arc of a parabola, or of one branch of a hyperbola, between two points on it, or so near to
/// it that they are meant: an arc of degree 2 through both, exactly, with the directions that the
/// conic has there; `is_parabola` makes it one although the coefficients are rounded. Throws
/// InputError (no place) where there is none.
RationalBezier open_arc(const PlaneConic& conic, bool is_parabola, const PlaneVector& from,
                        const PlaneVector& to);

/// The arc of an ellipse counterclockwise between two points on it, or so near to it that they are
/// meant, through both exactly; all of it where they meet. Throws InputError (no place) where there
/// is none.
CurvePieces closed_arc(const PlaneConic& conic, const PlaneVector& from, const PlaneVector& to);

}  // namespace phrame
