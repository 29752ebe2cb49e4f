#pragma once
#include "phrame/answer/frame_table.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/along/feedrate.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// Asks for the points of a motion at the times 0, period, 2·period, …
struct InterpolationQuery {
  Feedrate feedrate;            ///< the speed along the path
  Rational period;              ///< > 0, in units of time
  long most_rows = 10'000'000;  ///< more are refused
};

/// Those points and the end of the path, whose k is the next and whose time is the total. The
/// columns are k, time, t, s (arc length), x, y, z, all correctly rounded, and v, the speed, where
/// that is no rational function or has limits; as JSON, interpolation/1. Throws DomainError for a
/// period ≤ 0 and as TravelTime, InputError without a place where there are too many rows, and with
/// one where a number is too large for a double, Undecided where a precision limit is reached.
PHRAME_API FrameTable answer(const NamedPath& path, const InterpolationQuery& query);

/// Throws InputError where `ticks` and the end are too many rows.
PHRAME_API void require_few_rows(const InterpolationQuery& query, const Integer& ticks);

}  // namespace phrame
