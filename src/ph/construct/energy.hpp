#pragma once
#include <optional>
#include <span>

#include "phrame/algebra/ball.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

// How much curves bend, by quadrature in doubles: to choose among them, and to give an impression.

/// The greatest degree of A, and of f, that the integrals below take.
inline constexpr std::size_t max_energy_degree = 7;

/// ∫κ² ds on [0, 1] of r′ = f·A i A*, f > 0, with the Bernstein coefficients of A and f: about 8
/// digits of smooth curves; ∞ at a cusp. Numbers of about 1 are wanted, whose 8th powers are in the
/// range of doubles.
double approximate_energy(std::span<const Quaternion<double>> a, std::span<const double> f);
/// The same for f = 1.
double approximate_energy(std::span<const Quaternion<double>> a);
/// ∫|κ| ds likewise, the angle by which the tangent turns. It is the same for every f.
double approximate_turning(std::span<const Quaternion<double>> a);

/// A ball around ∫κ² ds, of at least 26 bits where f does not change its sign; no value where it is
/// infinite.
std::optional<RealBall> proved_energy(const Curve& curve);

}  // namespace phrame
