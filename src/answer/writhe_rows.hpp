#pragma once
#include "phrame/answer/totals.hpp"

namespace phrame::inline v0 {

/// The writhe and the self-linking number of a path that is closed with a continuous tangent, or
/// why there is none. Where that is undecided, the row says so.
std::vector<TotalsAnswer::Row> writhe_rows(const Path& path, long digits);

}  // namespace phrame
