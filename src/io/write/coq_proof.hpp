#pragma once
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// A Coq file with the theorem |−2∫₀ᵗ h/σ − θ̂| ≤ 10ᵏ: θ̂ is the angle θ_ERF(t), rounded to so many
/// digits, and 10ᵏ the place of its last digit. σ and h are defined from u, v, p, q and their
/// proved derivatives. CoqInterval's tactic `integral` proves it; precision, degree and number of
/// parts are chosen by the distance of the poles. Throws DomainError for t ≤ 0 and where A has a
/// zero in [0, t].
std::string coq_proof(const NamedCurve& curve, const Rational& t, long digits);

}  // namespace phrame
