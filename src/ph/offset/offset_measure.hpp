#pragma once
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/ph/offset/offset.hpp"

namespace phrame::inline v0 {

/// A stretch of an offset, from a cusp at which it turns back, or where it begins, to the next one,
/// or where it ends.
struct OffsetStretch {
  std::size_t first_piece;  ///< it begins on that
  RealAlgebraic from;       ///< there
  std::size_t last_piece;   ///< it ends on that
  RealAlgebraic to;         ///< there
  DefiniteIntegral length;  ///< |Δs + d·Δφ|, in finite terms where it is known so
};

/// The lengths of an offset.
struct OffsetLength {
  std::vector<OffsetStretch> stretches;  ///< one after the other, from the start of the path
  DefiniteIntegral total;                ///< of all of them
};
/// ∫ |speed + d·φ′| dt. Cost: the antiderivative of each piece.
OffsetLength length(const Offset& offset);

/// ½ ∮ (x dy − y dx) of a closed path of rational curves, positive where it goes round to the left.
Real signed_area(const Path& path);
/// ½ ∮ (x dy − y dx) of a closed offset, positive where it goes round to the left; no value for
/// others. For a smooth path with the signed area A and length L that turns by 2πk it is
/// A + d·L + d²·πk (Steiner).
std::optional<DefiniteIntegral> signed_area(const Offset& offset);

}  // namespace phrame
