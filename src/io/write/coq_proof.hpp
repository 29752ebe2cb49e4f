#pragma once
#include <string>

#include "phrame/answer/coq.hpp"

namespace phrame::inline v0 {

/// A Coq file with the theorem |−2∫₀ᵗ h/σ − θ̂| ≤ 10ᵏ. σ and h are defined from u, v, p, q and their
/// proved derivatives. CoqInterval's tactic `integral` proves it.
std::string coq_proof(const CoqAnswer& answer);

}  // namespace phrame
