#pragma once
#include <cmath>

#include "support/random.hpp"

namespace phrame::inline v0::test {

/// Of 53 random bits and any sign, below 2^60, rarely below 2^−113.
inline double any_double(Random& random) {
  const double significand = static_cast<double>(random.integer(-(1L << 53), 1L << 53));
  return std::ldexp(significand, static_cast<int>(random.integer(-113, 7)));
}

}  // namespace phrame::test
