#pragma once
#include <string>

#include "phrame/answer/coq.hpp"

namespace phrame::inline v0 {

/// A Coq file whose last theorem is about the frame and its angle θ: θ(0), θ′, the tangent, that
/// the frame is rotation-minimizing and unique but for a constant turn, and |θ(t) − theta| ≤
/// half_unit (docs/proofs.md). It needs proofs/rotation_minimizing.v, and CoqInterval for the last
/// number.
std::string coq_proof(const CoqAnswer& answer);

}  // namespace phrame
