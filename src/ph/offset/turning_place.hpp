#pragma once
#include "phrame/ph/offset/boundary.hpp"
#include "phrame/ph/offset/gauge_cover.hpp"

namespace phrame::inline v0 {

/// Where a path turns back, all points of d·U about that place that are ahead of it are at the
/// distance |d|: where what is left of the offset may end on it. `form` is that of U. Cost: an
/// eliminant for each such place and each piece of the offset.
std::vector<BoundaryEvent> events_at_turns(const std::vector<RationalCurve>& path,
                                           const Offset& offset, const GaugeForm& form);

}  // namespace phrame
