#pragma once
#include "phrame/ph/offset/gauge.hpp"
#include "phrame/ph/offset/offset_kind.hpp"

namespace phrame::inline v0 {

/// Which offsets of a curve under a gauge are rational, where they are not over ℚ to each side and
/// φ to both sides is a zero of one factor c₀ + c₁φ + c₂φ² of r′ × U′: then c₁² − 4c₀c₂ = D·g² with
/// a squarefree D decides as |H|² does for the unit circle. No value for others: where there is a
/// factor of degree 1, and where φ is of a higher degree. Precondition: a curve in a plane z =
/// const. Cost: factors of a polynomial in two unknowns.
std::optional<OffsetKind> offset_kind(const RationalCurve& curve, const Gauge& gauge);

/// The offsets r ± d·U(φ) by m, as two_sided_offset() without a gauge. Precondition: offset_kind()
/// has a conic with a form, d ≠ 0.
TwoSidedOffset two_sided_offset(const RationalCurve& curve, const Gauge& gauge,
                                const OffsetKind& kind, const Rational& d, long digits);

}  // namespace phrame
