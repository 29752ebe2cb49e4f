#pragma once
#include <map>
#include <mutex>
#include <vector>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

/// The sums x₀ + … + xₖ₋₁ of numbers that are known to any number of bits. They are kept for each
/// number of bits, so that few should be asked for; any thread may ask.
class PartialSums {
 public:
  /// A ball around the k-th sum, where term(n, bits) → RealBall is one around xₙ.
  template <class Term>
  RealBall before(std::size_t k, long bits, const Term& term) {
    const std::lock_guard locked(lock_);
    std::vector<RealBall>& known = known_[bits];
    if (known.empty()) known.emplace_back();
    while (known.size() <= k) {
      const RealBall next = term(known.size() - 1, bits);
      known.push_back(add(known.back(), next, bits + 32));  // for sums of many terms
    }
    return known[k];
  }

 private:
  std::mutex lock_;
  std::map<long, std::vector<RealBall>> known_;
};

}  // namespace phrame
