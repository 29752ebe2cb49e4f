#pragma once
#include <functional>

#include "phrame/algebra/modular.hpp"

namespace phrame::inline v0 {

/// What is looked for modulo one prime, given the inputs modulo that prime; no value where the
/// prime tells nothing.
using ModularImage =
    std::function<std::optional<ModularPolynomial>(const std::vector<ModularPolynomial>& inputs)>;

/// The integer polynomial of degree < `length` and |coefficients| < 2^bits whose residues are those
/// of `image`, by the Chinese remainder theorem for all primes at once. The bound is the caller's
/// proof: nothing is stopped early. Does not return where `image` has no value for all primes.
/// Cost: bits/61 images, and O(M(bits)·log(bits)) for each coefficient.
flint::FmpzPoly modular_lift(const std::vector<flint::FmpzPoly>& inputs, long length, long bits,
                             const ModularImage& image);

}  // namespace phrame
