#pragma once
#include "phrame/answer/frame_table.hpp"
#include "phrame/ph/curve/travel_time.hpp"

namespace phrame {

/// The points that a motion passes at the times 0, period, 2·period, … and the end of the curve,
/// whose k is the next and whose time is the total. The columns are k, time, t, s (arc length), x,
/// y, z, all correctly rounded; as JSON, interpolation/1. `time` is that of the curve. Throws
/// DomainError for a period ≤ 0, InputError where a number is too large for a double, Undecided
/// where a precision limit is reached.
FrameTable interpolation_table(const Curve& curve, TravelTime& time, const Rational& period);

}  // namespace phrame
