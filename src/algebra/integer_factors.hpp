#pragma once
#include <vector>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {

/// A power in a product.
struct PrimePower {
  Integer base;
  unsigned long exponent;
};

/// All primes up to that are found.
inline constexpr unsigned largest_divisor = 10'000;

/// x ≥ 1 as a product of powers > 1; all bases are primes where at most one prime factor is above
/// 10⁴, and where x < 2¹²⁸. Cost: up to a second, for two large primes.
std::vector<PrimePower> factors(const Integer& x);

/// Is it a prime? (By the test of Baillie, Pomerance, Selfridge and Wagstaff, that no composite
/// number is known to pass.)
bool is_prime(const Integer& x);

}  // namespace phrame
