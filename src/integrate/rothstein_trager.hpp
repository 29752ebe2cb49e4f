#pragma once
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame {

/// ∫ n/d = Σ α log gcd(n − α d′, d) over the distinct residues α, the roots of the irreducible
/// polynomial q of which the residue polynomial of n/d is a power [Farouki 2003, (24); Rothstein
/// 1976, Trager 1976]. The gcd in ℚ[x]/(q) is computed modulo primes, lifted, and rationally
/// reconstructed; it is proved by whoever checks the derivative of the sum, as integrate() does.
LogSum rothstein_trager(const SimpleFraction& f);

/// Sums with equal index and residue become one, their arguments multiplied: Σ α log(v·w).
std::vector<LogSum> merge_equal_residues(std::vector<LogSum> sums);

}  // namespace phrame
