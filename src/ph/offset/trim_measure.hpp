#pragma once
#include <optional>

#include "phrame/ph/offset/offset_trim.hpp"

namespace phrame::inline v0 {

/// The length of a branch, Σ |Δs + d·Δφ| of its parts, and of a closed one its area ½ ∮ (x dy −
/// y dx), positive where it goes round to the left. Exact where all of it is straight.
struct BranchMeasure {
  Real length;
  std::optional<Real> area;
};
/// 1 where the parameter grows along a part, else −1.
int way_along(const OffsetPart& part);
/// Precondition: the branch is one of that offset of the path.
BranchMeasure measure(const PhPath& path, const TrimmedOffset& trimmed,
                      const TrimmedBranch& branch);

}  // namespace phrame
