#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {

/// The unit quaternion Q with (e₁, e₂, e₃) = (Q i Q*, Q j Q*, Q k Q*), one of the two that differ
/// by their sign: its component of greatest size, about, is positive. Components are exact or known
/// to be irrational where those of the frame are exact. Precondition: the frame is orthonormal and
/// right-handed.
PHRAME_API Quaternion<Real> quaternion_of(const Frame<Real>& frame);

}  // namespace phrame
