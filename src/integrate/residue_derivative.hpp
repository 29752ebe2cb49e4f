#pragma once
#include <optional>

#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// (Σ α·log v(α, t))′ over the roots α of an index, proved; no value where the residue of the sum
/// is not x, or some t is a zero of v(α, t) twice or for two α. Found modulo a few primes, as the
/// rational function that it is has short coefficients, however long those of v are.
std::optional<RationalFunction> derivative_over_residues(const LogSum& sum);

}  // namespace phrame
