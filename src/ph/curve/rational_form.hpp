#pragma once
#include <optional>
#include <string>

#include "phrame/ph/curve/formula.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// The curve of these formulas from s = a to s = b as X/W, where they are rational functions with
/// fractions for coefficients and the ends are fractions; no value for others, and beyond degree
/// 400. Throws DomainError for a pole on the way, "x has a pole at s = 1", and as RationalCurve;
/// that the formulas have other poles, which cancel, is no matter.
std::optional<RationalCurve> rational_form(const Vector<Formula>& position, const Formula& from,
                                           const Formula& to, const std::string& variable = "s");

}  // namespace phrame
