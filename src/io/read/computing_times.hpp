#pragma once
#include <map>
#include <string>
#include <string_view>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// How long somebody's program took for one table of frames.
struct ComputingTime {
  Rational seconds;  ///< ≥ 0
  long line;         ///< where it is told, counted from 1
};

/// A line "name,seconds", and below it a line for each table: "51/tame-01,0.0012". A name is a
/// path without its ending. Empty lines and lines that begin with '#' are skipped. Throws
/// InputError with the line for another header, a name given twice, and seconds that are no number
/// ≥ 0.
std::map<std::string, ComputingTime> computing_times(std::string_view text);

}  // namespace phrame
