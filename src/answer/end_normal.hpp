#pragma once
#include <optional>

#include "phrame/ph/along/frame_angle.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame {

/// Throws DomainError where there is an end normal of a closed path.
void require_open(const std::optional<Vector<Rational>>& end_normal, bool is_closed);

/// The angle to e₂ at the end of the path of the vector, projected to the normal plane. Throws
/// DomainError where it is along the tangent.
FrameAngle end_angle(const Vector<Rational>& end_normal, const PhPath& path);

}  // namespace phrame
