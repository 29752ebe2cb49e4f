#pragma once
#include "phrame/algebra/conic.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// r(t) = curve(parameter(t)), where r is traced several times, but no part of it from 0 to 1.
struct TracedOnce {
  RationalFunction parameter;  ///< from 0 at t = 0 to 1 at t = 1
  RationalCurve curve;         ///< traced once
};

/// Which offsets of a curve in a plane are rational [Lü 1995]. |H|² = D·g² with a squarefree D
/// decides: the offsets to both sides together are birational to y² = D(t), if the curve is traced
/// once.
struct OffsetKind {
  enum class Kind {
    each_side,  ///< deg D = 0: both by themselves, in the same parameter, over ℚ(√radicand)
    two_sided,  ///< deg D = 2: both together, by a parameter of the conic, over ℚ(√radicand)
    none,       ///< deg D ≥ 4: neither, but perhaps for some d
    undecided   ///< numbers are not factored, or it is not found how often the curve is traced
  };
  Kind kind;              ///< which
  Polynomial squarefree;  ///< D, with integers for coefficients
  Integer radicand = 1;   ///< of the field that is needed; 1: ℚ
  /// Of a two-sided one over ℚ(√radicand) ≠ ℚ, the p of ConicParameters.
  Integer prime = 0;
  /// Of a two-sided one over ℚ, t by the parameter m.
  std::optional<ConicParameters> conic = {};
  /// Of a curve that is traced several times, where D is that of another one: that, which `conic`
  /// is of. There is no conic where a part of it is run through again from t = 0 to 1.
  std::optional<TracedOnce> once = {};
};

/// Precondition: the curve is in a plane. In a plane z = const a conic has points over ℚ always: H₁
/// + iH₂ has a factor kt + c over ℚ(i) where deg D = 2, and D is |kt + c|². Where a curve is
/// traced several times, and its D is of a higher degree, D is that of the curve that it is by a
/// function h(t).
PHRAME_API OffsetKind offset_kind(const RationalCurve& curve);

/// A two-sided offset r ± d·n, n = (y′, −x′)/|r′|, in lowest terms: X/W by m, both sides.
struct TwoSidedOffset {
  RationalFunction parameter;            ///< t by m; where `once` is there, its parameter by m
  std::optional<RationalFunction> once;  ///< of a curve traced several times, that parameter by t
  std::array<Polynomial, 2> numerator;   ///< X of x and of y
  Polynomial weight;                     ///< W
  /// What of it belongs to t from 0 to 1, at d, and at −d. m at the ends is rounded
  /// inwards, by less than 10^−digits.
  std::vector<RationalCurve> sides;
  std::vector<std::array<Rational, 2>> ends;  ///< m at the ends of these
};
/// Precondition: offset_kind() has a conic with a form, d ≠ 0, z = const.
PHRAME_API TwoSidedOffset two_sided_offset(const RationalCurve& curve, const OffsetKind& kind,
                                           const Rational& d, long digits);

}  // namespace phrame
