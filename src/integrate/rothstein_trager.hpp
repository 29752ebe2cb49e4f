#pragma once
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame::inline v0 {

/// Simple fractions with the same residues.
struct EqualResidues {
  RationalFunction sum;  ///< of the fractions
  Polynomial residues;   ///< its residue polynomial, a power of an irreducible one
  bool is_one;           ///< Is it one fraction?
};

/// One for each irreducible polynomial of residues, in the order in which they are met, when
/// fractions with the same denominator are one, or none where they cancel.
std::vector<EqualResidues> by_residues(const std::vector<SimpleFraction>& fractions);

/// Σ α log v(α, t) over the distinct residues α of the fractions, one sum for each irreducible
/// polynomial q of them, v(α, t) a constant times gcd(n − α d′, d) of all that have the residue α,
/// multiplied [Farouki 2003, (24); Rothstein 1976, Trager 1976]. As q is irreducible these gcds are
/// the arguments of lazard_rioboo_trager(), and so they are proved by whoever checks the derivative
/// of the sums, as integrate() does.
std::vector<LogSum> rothstein_trager(const std::vector<SimpleFraction>& fractions);

/// The same, checked.
std::vector<LogSum> over_residues(const std::vector<SimpleFraction>& fractions);

/// Sums with equal index and residue become one, their arguments multiplied: Σ α log(v·w).
std::vector<LogSum> merge_equal_residues(std::vector<LogSum> sums);

/// Do the residues of the fraction lie in fields of degree ≤ most? For most fractions of a higher
/// degree a prime denies it.
bool has_residues_of_degree_at_most(const SimpleFraction& f, long most);

}  // namespace phrame
