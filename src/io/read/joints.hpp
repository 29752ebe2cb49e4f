#pragma once
#include <optional>

#include "phrame/io/read/given_segment.hpp"

namespace phrame::inline v0 {

/// Closes gaps between segments, and from the end to the start, of at most so far; by default of
/// what rounding of coordinates leaves (rounding_gap). A PH curve is moved, of another the start,
/// or at last the end, by a straight motion along it; nothing is done next to formulas, at the end
/// of a PH curve, where the path is not some 32 times as large as the gap of its ends, and where it
/// would turn back. In words
/// how many gaps were closed, empty for none.
std::string close_gaps(std::vector<GivenSegment>& segments, const std::optional<Rational>& most);

/// Of a path that begins or ends with formulas, which are not moved: how far its ends are apart,
/// where that is at most so much, by default rounding, and they are told not to meet; else empty.
std::string open_ends(const Path& path, const std::optional<Rational>& most);

}  // namespace phrame
