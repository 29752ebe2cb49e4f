#pragma once
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/real_vector.hpp"

namespace phrame {

/// A point of a path, at any real parameter of a segment, as arc length gives them.
struct Place {
  std::size_t segment;  ///< 0, 1, …
  Real t;               ///< in [0, 1]

  /// On that segment, t of it.
  Place(std::size_t on_segment, Real at) : segment(on_segment), t(std::move(at)) {}
  /// The same point.
  Place(const PathParameter& at)  // NOLINT(google-explicit-constructor)
      : Place(at.segment, at.t) {}
};

/// p(t), exact where t is.
Real value(const Polynomial& p, const Real& t);

/// @{ r, H and H′ there, exact where t is and the curve is rational, or the form of its formulas
/// shows it. Of formulas H is ±dr/ds and H′ ±d²r/ds², positive multiples of ±dr/dt and ±d²r/dt².
Vector<Real> position(const RationalCurve& curve, const Real& t);
Vector<Real> direction(const RationalCurve& curve, const Real& t);
Vector<Real> position(const Path& path, const Place& at);
Vector<Real> direction(const Path& path, const Place& at);
Vector<Real> direction_slope(const Path& path, const Place& at);
/// @}
/// dⁿr/dsⁿ, n ≤ 3, by the parameter s of the formulas, exact where t is and the form shows it.
Vector<Real> derivative(const ExpressionCurve& curve, std::size_t order, const Real& t);

}  // namespace phrame
