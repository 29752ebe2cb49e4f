#pragma once
#include <memory>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

class AlgebraicPoint;

/// A point of a path, at any real parameter of a segment, as arc length gives them.
struct PHRAME_API Place {
  std::size_t segment;  ///< 0, 1, …
  Real t;               ///< in [0, 1]; of a PH curve by itself it may be any
  /// t again where it is irrational and known to be algebraic: values are then exact where they are
  /// rational. Else null.
  std::shared_ptr<const AlgebraicPoint> algebraic = nullptr;

  /// @{ On that segment, t of it.
  Place(std::size_t on_segment, Real at) : segment(on_segment), t(std::move(at)) {}
  Place(std::size_t on_segment, const Rational& at) : Place(on_segment, Real(at)) {}
  Place(std::size_t on_segment, const RealAlgebraic& at);
  /// @}
  /// The same point.
  Place(const PathParameter& at)  // NOLINT(google-explicit-constructor)
      : Place(at.segment, at.t) {}
};

/// From where to where the parameter of formulas goes, as NamedPath::parameters; exact where their
/// form shows a fraction.
PHRAME_API std::vector<Real> formula_parameters(const ExpressionCurve& curve);
/// Where the parameter that the file of the path has is x; an end of it for an x beyond that which
/// rounds to the same double. Throws DomainError where it has none, and for another x outside of
/// what it goes through.
PHRAME_API Place native_place(const NamedPath& named, const Rational& x);

/// The last point of the path.
PHRAME_API Place end_of(const Path& path);
/// t of the place, where it is known to be algebraic.
PHRAME_API std::optional<RealAlgebraic> algebraic_number(const Place& at);
/// @{ The parameter along the path, segment + t; the second where it is known to be algebraic.
PHRAME_API Real parameter(const Place& at);
PHRAME_API std::optional<RealAlgebraic> algebraic_parameter(const Place& at);
/// @}

/// @{ f(t), exact where t is; of a place also where it is rational and t algebraic.
PHRAME_API Real value(const Polynomial& p, const Real& t);
PHRAME_API Real value(const Polynomial& p, const Place& at);
PHRAME_API Real value(const RationalFunction& f, const Place& at);
/// @}

/// @{ r, H and H′ there, exact where t is and the curve is rational, or the form of its formulas
/// shows it, and r where it is known by algebra. Of formulas H is ±dr/ds and H′ ±d²r/ds², positive
/// multiples of ±dr/dt and ±d²r/dt².
PHRAME_API Vector<Real> position(const RationalCurve& curve, const Real& t);
PHRAME_API Vector<Real> direction(const RationalCurve& curve, const Real& t);
PHRAME_API Vector<Real> position(const Path& path, const Place& at);
PHRAME_API Vector<Real> direction(const Path& path, const Place& at);
PHRAME_API Vector<Real> direction_slope(const Path& path, const Place& at);
/// @}
/// dⁿr/dsⁿ, n ≤ 3, by the parameter s of the formulas, exact where t is and the form shows it.
PHRAME_API Vector<Real> derivative(const ExpressionCurve& curve, std::size_t order, const Real& t);
/// dⁿr/dtⁿ on the segment there, by its t, exact as position() is, and of formulas for n ≤ 3.
PHRAME_API Vector<Real> derivative(const Path& path, std::size_t order, const Place& at);

}  // namespace phrame
