#pragma once
#include <optional>

#include "phrame/algebra/real.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/gaussian_logs.hpp"

namespace phrame::inline v0 {

/// The change of logarithms with residues in ℚ(i) from a to b over π, where that is rational with a
/// denominator that is not large. The ends may be algebraic: from v(a) and v(b), which lie in the
/// fields of the ends, it is decided whether the logarithms of sizes cancel, ∏ v(b)ᵏ = ±∏ v(a)ᵏ,
/// and whether the arguments, multiplied by a whole number, agree. So 0 is decided, but for
/// exponents so large that their products are not formed. Precondition: `enclose` gives balls
/// around the change, no end is a zero of a logarithm, and logs.others is empty, else DomainError.
/// Real zeros between the ends count as in log|v|.
std::optional<Rational> multiple_of_pi(const GaussianLogs& logs, const Endpoint& a,
                                       const Endpoint& b, const Real::Enclosure& enclose);

}  // namespace phrame
