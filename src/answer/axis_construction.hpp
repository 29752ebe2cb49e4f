#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/offset/minkowski_spline.hpp"

namespace phrame::inline v0 {

/// Asks for a spline of plane curves with radii near given points (x, y, r) and derivatives.
struct AxisConstructionQuery {
  /// As ConstructQuery::tolerance.
  Rational tolerance = Rational(1, 1'000'000'000'000'000);
};

/// A C¹ spline of Minkowski PH quintics, and how near it is to its data.
struct AxisConstructionAnswer {
  NamedAxis axis;                                     ///< the segments
  std::vector<std::vector<RealAlgebraic>> lightlike;  ///< of each: where σ = 0 in [0, 1]
  HermiteSpline data;                                 ///< what the curve should have
  /// @{ Where derivatives and parameters come from.
  DerivativeSource derivatives_from;
  ParameterSource parameters_from;
  /// @}
  Deviation tolerance;  ///< what was asked for, as distances
  Deviation deviation;  ///< proved bounds
};

/// Throws InputError for points of two coordinates, a radius < 0, orientations and accelerations,
/// DomainError where there is no such spline.
PHRAME_API AxisConstructionAnswer answer(const GivenPoints& given,
                                         const AxisConstructionQuery& query);

}  // namespace phrame
