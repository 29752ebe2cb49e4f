#pragma once
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/drawn_chain.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"

namespace phrame::inline v0 {

/// What `make` throws without a place is said of the entity of a file.
template <class Entity, class Make>
auto of_entity(const Entity& entity, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    entity.fail(error.reason());
  }
}

/// Where a conic is in space: an ellipse is center + a cos φ · x + b sin φ · y, with x and y of
/// length 1 and normal to each other: exactly, or within 2^−ellipse_bits where their lengths are
/// irrational.
struct SpaceConic {
  Vector<Rational> center;
  std::array<Rational, 2> semiaxes;  ///< a, b > 0
  Vector<Rational> x;
  Vector<Rational> y;
};

/// That with x along the part of `reference` across the axis, and y to its left seen from where the
/// axis goes to. Throws InputError (no place) where the axis is 0 or the reference is along it, and
/// for a semiaxis that is not > 0.
SpaceConic conic_about(const Vector<Rational>& center, const Vector<Rational>& axis,
                       const Vector<Rational>& reference, const std::array<Rational, 2>& semiaxes);

/// The arc with the angle growing, or falling, between points of the unit circle that stand for its
/// ends; all of it where they are one.
CurvePieces arc_between(const SpaceConic& conic, const PlaneVector& from, const PlaneVector& to,
                        bool is_growing);
/// The same between two places, which are kept exactly; that of a circle is exact where they are as
/// far from the center, in its plane, and is that through them otherwise. Throws InputError (no
/// place) for one that is farther from the conic than rounding explains.
CurvePieces arc_between(const SpaceConic& conic, const Vector<Rational>& from,
                        const Vector<Rational>& to, bool is_growing);

/// The arc of the hyperbola center + a cosh u · x + b sinh u · y, or of the parabola
/// center + a(u² x + 2u y), between two places, which are kept exactly. Throws InputError (no
/// place) for one that is farther from the conic than rounding explains.
RationalBezier hyperbola_between(const SpaceConic& conic, const Vector<Rational>& from,
                                 const Vector<Rational>& to);
RationalBezier parabola_between(const SpaceConic& conic, const Vector<Rational>& from,
                                const Vector<Rational>& to);
/// The places with the parameter u: of a parabola; of a hyperbola, e^u to a 2^ellipse_bits-th of
/// itself. The latter throws InputError (no place) for |u| > 1000.
Vector<Rational> on_parabola(const SpaceConic& conic, const Rational& u);
Vector<Rational> on_hyperbola(const SpaceConic& conic, const Rational& u);

/// v over its length, exactly or to within 2^−ellipse_bits. Throws InputError (no place) for 0.
Vector<Rational> near_unit(const Vector<Rational>& v);

}  // namespace phrame
