#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/curve/curve_integrands.hpp"
#include "phrame/ph/curve/formula_domain.hpp"

namespace phrame::inline v0 {

/// A part of [0, 1] of the parameter on which an integrand y is analytic, and on the disc of
/// `radius` times its size, where |y| ≤ bound with z = ±1 at the ends.
struct TaylorPart {
  Rational lower;
  Rational upper;
  RealBall bound;
  bool is_gap = false;         ///< is |y| ≤ bound on the part all that is known?
  long length = 0;             ///< of the series that show it
  long radius = inner_radius;  ///< ≥ least_radius
};

/// [0, 1] in parts, by halving; or up to where that ends, at 2^−40 or with too many.
struct TaylorParts {
  std::vector<TaylorPart> parts;
  std::optional<NarrowPart> fault;
};

/// The parts of |r′|.
TaylorParts find_regular_parts(const ExpressionCurve& curve);
/// Those of other integrands, found on one walk along the curve. They are inside those of |r′|,
/// without which none is analytic, and each is as large as its integrand lets it be.
std::vector<TaylorParts> find_parts(const ExpressionCurve& curve,
                                    const std::vector<CurveIntegrand>& integrands,
                                    const std::vector<TaylorPart>& regular);
/// The same of a y that is continuous where a factor with an exponent > 0 has a zero, as √ρ is:
/// around these there are gaps, over each of which |∫ y| < 2^−bits. `known` is what was found
/// without gaps, up to a fault, or with larger ones: its other parts are taken as they are.
TaylorParts find_parts_with_gaps(const ExpressionCurve& curve, const CurveIntegrand& y,
                                 const std::vector<TaylorPart>& regular, const TaylorParts& known,
                                 long bits);

}  // namespace phrame
