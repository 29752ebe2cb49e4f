#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "phrame/ph/sweep/profile.hpp"

namespace phrame::inline v0 {

/// The sign of the area of a triangle: 1 where it is counterclockwise.
int profile_turn(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c);
/// Is p, which is on the line through a and b, between them, the ends included?
bool is_between(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b);
/// Do the line segments from a to b and from c to d have a point in common?
bool meet(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c,
          const ProfilePoint& d);

/// Triangles of corners, counterclockwise, that fill the profile; decided exactly, by clipping ears
/// [Meisters 1975] after each hole was joined to what is around it by a side there and back. None
/// is degenerate, and their areas are seen to add up to that of the profile. Cost: the number of
/// corners times that of the reflex ones; of a profile with holes its square.
std::vector<std::array<std::uint32_t, 3>> triangulated(const Profile& profile);

}  // namespace phrame
