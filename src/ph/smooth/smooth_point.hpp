#pragma once
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/smooth/smooth_path.hpp"

namespace phrame {

/// A point of a path, at any real parameter of a segment, as arc length gives them.
struct SmoothParameter {
  std::size_t segment;  ///< 0, 1, …
  Real t;               ///< in [0, 1]

  /// On that segment, t of it.
  SmoothParameter(std::size_t on_segment, Real at) : segment(on_segment), t(std::move(at)) {}
  /// The same point.
  SmoothParameter(const PathParameter& at)  // NOLINT(google-explicit-constructor)
      : SmoothParameter(at.segment, at.t) {}
};

/// p(t), exact where t is.
Real value(const Polynomial& p, const Real& t);

/// @{ r and H there, exact where t is.
Vector<Real> position(const RationalCurve& curve, const Real& t);
Vector<Real> direction(const RationalCurve& curve, const Real& t);
Vector<Real> position(const SmoothPath& path, const SmoothParameter& at);
Vector<Real> direction(const SmoothPath& path, const SmoothParameter& at);
/// @}

}  // namespace phrame
