#pragma once
#include <string>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// A number as somebody would write it, for messages: "1/3", and "4.0000000001" for what was given
/// as that decimal or as the double nearest to it; a long fraction is abbreviated.
std::string as_written(const Rational& x);

/// Do both numbers round to the same double, one with all of its bits? What a caller computed as an
/// end may lie beyond it, and is that end. Doubles that overflow or underflow say nothing.
bool is_rounded(const Rational& x, const Real& end);

}  // namespace phrame
