#pragma once
#include <optional>
#include <string_view>

#include "phrame/algebra/error_free.hpp"

namespace phrame::inline v0 {

/// What parse_rational() reads of a plain decimal, "-12", "0.9515", "1.5e-12", to about 2^−96 of
/// its size; exactly, with the error 0, where it is a double of few digits. An exponent may have a
/// D, as in Fortran. No value for anything else, and where the number is beyond 10^±270. In
/// rounding to nearest. Cost: some ten nanoseconds.
std::optional<NearNumber> near_decimal(std::string_view text);

}  // namespace phrame
