#pragma once
#include <optional>

#include "phrame/io/read/given_segment.hpp"

namespace phrame {

/// Closes gaps between segments, and from the end to the start, of at most so far; by default of
/// what rounding of coordinates leaves (rounding_gap). A PH curve is moved, of another the start,
/// or at last the end, by a straight motion along it; nothing is done next to formulas, nor where
/// the whole path is hardly longer than its gap. In words how many gaps were closed, empty for
/// none.
std::string close_gaps(std::vector<GivenSegment>& segments, const std::optional<Rational>& most);

}  // namespace phrame
