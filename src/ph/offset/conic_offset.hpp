#pragma once
#include <functional>

#include "phrame/ph/offset/offset_kind.hpp"

namespace phrame::inline v0 {

// What offsets by the Euclidean distance and under a gauge have in common, where those to both
// sides are functions of t and of a y with y² = D(t).

/// q = squarefree·square², with integers for the coefficients of squarefree, and square(0) > 0.
struct SplitSquare {
  Polynomial squarefree;
  Polynomial square;
};
/// Precondition: q > 0 on ℝ.
SplitSquare split_square(const Polynomial& q);

/// What is asked of offset_kind_by().
struct OffsetKindQuery {
  std::function<OffsetKind(const RationalCurve& curve)> of_curve;  ///< the kind for another curve
  std::function<ConicParameters()> conic;                          ///< where deg D = 2
};
/// The kind by D. Of a curve that is traced several times, and deg D > 2, it is that of the curve
/// that it is by h(t).
OffsetKind offset_kind_by(const Polynomial& squarefree, const RationalCurve& curve,
                          const OffsetKindQuery& query);

/// The curve that `kind.conic` is of.
const RationalCurve& traced_once(const RationalCurve& curve, const OffsetKind& kind);

/// r + step of a curve that is traced_once(), both by m; the sides belong to y of the sign `first`
/// and of the other one.
TwoSidedOffset two_sided_by(const RationalCurve& curve, const OffsetKind& kind,
                            const std::array<RationalFunction, 2>& step, int first, long digits);

}  // namespace phrame
