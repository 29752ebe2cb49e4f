#pragma once
#include <optional>

#include "phrame/algebra/power_product.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame::inline v0 {

/// Σ exponent·log base + multiple·π.
struct TurnedLogs {
  std::vector<Power> sizes;
  RealAlgebraic multiple;
};

/// The change from a to b of Σ c(z)·log(t − z) over the poles z of all fractions f, c(z) their
/// residues, where every t − z turns by a known rational multiple ω(z) of π: then it is
/// π·Σ i·c(z)·ω(z), a real algebraic multiple of π, and logarithms of sizes. Ends for which the
/// angles of t − z are known are
///   ±∞, where log|t| is left out, as in LogChange;
///   a rational t about which f is even, Σ f(2t − s) = Σ f(s): the angle of t − z counts as −π/2
///   for Im z > 0, as the logarithms of z and 2t − z have opposite factors; a rational t such that
///   a power (t − z)ᴺ is rational, for each fraction.
/// Real poles between the ends count as in a principal value. No value where an angle is not known,
/// or the multiple not recognised: its polynomial is guessed from no more than 4000 bits of it
/// (most_lattice_bits in bounded_algebraic.cpp), as the reduction of the lattice takes time like a
/// power of them. So the same function with large coefficients may get no value where with small
/// ones it does; it never gets a wrong one. Precondition: no end is a pole.
std::optional<TurnedLogs> turned_logs(const std::vector<SimpleFraction>& fractions,
                                      const Endpoint& a, const Endpoint& b);

}  // namespace phrame
