#pragma once
#include <functional>

#include "phrame/integrate/taylor_integral.hpp"
#include "phrame/ph/along/antisymmetry.hpp"
#include "phrame/ph/curve/formula.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// @{ Has the rate this symmetry, as an identity of polynomials or of sums of trigonometric
/// functions? Preconditions: 0 < t ≤ 1, and t is a multiple of 2δ.
///
/// Of N/(D√S): N(t − τ) = −N(τ), and D and S are even. With a shift only N = 0 has it.
bool has_antisymmetry(const RootQuotient& rate, const Rational& t, const Antisymmetry& symmetry);
/// Of the angle to the frame of v, or without it to the Frenet frame, along r(s), s from one
/// constant to another: where r is a sum of products of numbers, π, s, and of sines and cosines of
/// what is linear in it, and that is no more work than `most` (TrigonometricArithmetic).
bool has_antisymmetry(const Vector<Formula>& r, const Formula& from, const Formula& to,
                      const std::optional<Vector<Rational>>& v, const Rational& t,
                      const Antisymmetry& symmetry, const Integer& most);
/// @}

/// The first one that `has` allows: without a shift, then t/2, t/4, …, t/24.
std::optional<Antisymmetry> find_antisymmetry(const Rational& t,
                                              const std::function<bool(const Antisymmetry&)>& has);

}  // namespace phrame
