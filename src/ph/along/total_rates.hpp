#pragma once
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/integrate/pole_change.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// What a total of a PH curve is the integral of, from 0 to 1, with the sign that it has for small
/// t > 0.
struct TotalRate {
  RationalFunction rate;        ///< not proper, perhaps
  Polynomial orientation;       ///< where this changes its sign, so does that of the rate
  RationalFunction known = {};  ///< a part of the rational part of the integral, where one is known
};

TotalRate bending_energy_rate(const Curve& curve);  ///< κ²·ds/dt
/// (κ² + τ²)·ds/dt. Throws DomainError for a straight line.
TotalRate frenet_energy_rate(const Curve& curve);
TotalRate total_torsion_rate(const Curve& curve);  ///< τ·ds/dt. Throws likewise
TotalRate erf_twist_rate(const Curve& curve);      ///< 2h/σ

/// Where the rates of a polynomial curve have their poles, found once for all of them.
struct TotalPoles {
  PoleBase sigma;
  PoleBase rho;
  Lazy<Polynomial> turning{};  ///< τ·ds/dt is this over σρ, but for the sign of f
};
TotalPoles total_poles(const Curve& curve);
/// @{ These rates, with the sign, by factors; no value for rational curves, for τ of straight
/// lines, and where the sign changes inside (0, 1).
std::optional<FactoredFunction> bending_energy_factors(const Curve& curve, const TotalPoles& poles);
std::optional<FactoredFunction> frenet_energy_factors(const Curve& curve, const TotalPoles& poles);
std::optional<FactoredFunction> total_torsion_factors(const Curve& curve, const TotalPoles& poles);
std::optional<FactoredFunction> erf_twist_factors(const Curve& curve, const TotalPoles& poles);
/// @}

/// The integral to any number of digits, by Taylor polynomials and without a closed form. No value
/// where the rate has a pole, or its sign changes, inside (0, 1).
std::optional<Real> value_without_closed_form(const TotalRate& of);
/// What of the integral is no logarithm, where value_without_closed_form() is one: apart from that
/// it is transcendental [Baker 1975].
Rational without_logarithms(const TotalRate& of);

}  // namespace phrame
