#pragma once
#include <optional>

#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// The points that two short parts have in common, where one curve is the mirror image of the other
/// one, P(s) that of Q(s) or Q(1 − s): all points of the axis a curve has are the roots of one
/// polynomial, and if that has no root, or one of even order, both are on different sides of it.
/// No value where it is not told, as where they overlap, or one goes on into the other.
std::optional<std::vector<KnownMeeting>> touching(const OffsetBranches& offset,
                                                  const CurveSeries& series,
                                                  const UndecidedCrossing& place);

}  // namespace phrame
