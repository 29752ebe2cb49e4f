#pragma once
#include <vector>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {

/// Σ terms[k]·zᵏ/2^bits.
struct GridPolynomial {
  std::vector<Integer> terms;  ///< maybe with zeros at the end
  long bits = 0;               ///< ≥ 0
  friend bool operator==(const GridPolynomial&, const GridPolynomial&) = default;
};

}  // namespace phrame
