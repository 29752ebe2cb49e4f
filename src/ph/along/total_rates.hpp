#pragma once
#include <optional>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/integrate/rational_change.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// What a total of a PH curve is the integral of, from 0 to 1, with the sign that it has for small
/// t > 0.
struct TotalRate {
  RationalFunction rate;        ///< not proper, perhaps
  Polynomial orientation;       ///< where this changes its sign, so does that of the rate
  RationalFunction known = {};  ///< a part of the rational part of the integral, where one is known
  std::vector<PolePower> denominator = {};  ///< of the rate; none where it may be squarefree
};

TotalRate bending_energy_rate(const Curve& curve);  ///< κ²·ds/dt
/// (κ² + τ²)·ds/dt. Throws DomainError for a straight line.
TotalRate frenet_energy_rate(const Curve& curve);
TotalRate total_torsion_rate(const Curve& curve);  ///< τ·ds/dt. Throws likewise
TotalRate erf_twist_rate(const Curve& curve);      ///< 2h/σ

/// The integral to any number of digits, by Taylor polynomials and without a closed form. No value
/// where the rate has a pole, or its sign changes, inside (0, 1).
std::optional<Real> value_without_closed_form(const TotalRate& of);
/// What of the integral is no logarithm, where value_without_closed_form() is one: apart from that
/// it is transcendental [Baker 1975].
Rational without_logarithms(const TotalRate& of);
/// The same in a ball, much faster, where rational_change() has a value.
std::optional<RealBall> without_logarithms(const TotalRate& of, long bits);

}  // namespace phrame
