#include "phrame/algebra/rational_lift.hpp"

namespace phrame::inline v0 {

RationalLift::RationalLift(std::size_t count) : lifted_(count) { fmpz_one(product_.get()); }

std::optional<std::vector<Rational>> RationalLift::include(const std::vector<ulong>& residues,
                                                           ulong p) {
  for (std::size_t k = 0; k < lifted_.size(); ++k)
    fmpz_CRT_ui(lifted_[k].get(), lifted_[k].get(), product_.get(), residues[k], p, 0);
  fmpz_mul_ui(product_.get(), product_.get(), p);
  if (++primes_ < next_attempt_) return std::nullopt;
  auto found = reconstruct();
  if (found && found == candidate_) return found;
  // Reconstruction costs more than a prime: after a failure wait for a fifth more primes; after a
  // success one prime decides.
  next_attempt_ = primes_ + 1 + (found ? 0 : primes_ / 5);
  candidate_ = std::move(found);
  return std::nullopt;
}

/// The rationals with these residues and small enough numerators and denominators, if any.
std::optional<std::vector<Rational>> RationalLift::reconstruct() const {
  std::vector<Rational> result;
  Rational value;
  for (const auto& x : lifted_) {
    if (fmpq_reconstruct_fmpz(value.raw(), x.get(), product_.get()) == 0) return std::nullopt;
    result.push_back(value);
  }
  return result;
}

}  // namespace phrame
