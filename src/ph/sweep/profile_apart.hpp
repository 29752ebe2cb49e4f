#pragma once
#include "phrame/ph/sweep/profile_curve.hpp"

namespace phrame::inline v0 {

/// Throws Undecided unless the rings of the profile are seen to have no point in common, naming
/// two of them: a curve lies within the box around its control points, exactly, and where two boxes
/// meet the larger curve is halved, down to 2^−40 of the profile, and not without end. Rings have
/// the numbers in which they are there, from 1.
void require_rings_apart(const ProfileCurve& profile);

}  // namespace phrame
