#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/handle.hpp"
#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// Rational numbers from their residues modulo more and more primes. A candidate is returned once
/// one more prime has confirmed it; that makes it likely, and a check of the result proves it.
class RationalLift {
 public:
  explicit RationalLift(std::size_t count);

  /// Takes in the residues modulo the new prime p. The numbers, as soon as they are likely.
  std::optional<std::vector<Rational>> include(const std::vector<ulong>& residues, ulong p);

 private:
  std::optional<std::vector<Rational>> reconstruct() const;

  std::vector<flint::Fmpz> lifted_;
  flint::Fmpz product_;
  std::optional<std::vector<Rational>> candidate_;
  long primes_ = 0;
  long next_attempt_ = 1;
};

}  // namespace phrame
