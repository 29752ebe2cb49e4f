#pragma once
#include <optional>

#include "phrame/algebra/surd.hpp"
#include "phrame/ph/curve/formula.hpp"

namespace phrame::inline v0 {

/// α + βπ with sums α and β of square roots: two of them are equal just where both parts are,
/// because π is transcendental.
struct FormulaConstant {
  Surd plain;  ///< α
  Surd of_pi;  ///< β
  friend bool operator==(const FormulaConstant&, const FormulaConstant&) = default;
};

/// What an operation on such numbers gives, where that is one again by a simple rule: sums,
/// products with a number without π, quotients, whole powers, √ of a fraction, sines and cosines of
/// multiples of π/12 and π/10, and their arctangents. No value for others, where it is undefined,
/// and where it is long.
std::optional<FormulaConstant> apply(const Formula::Step& step, const FormulaConstant& left,
                                     const FormulaConstant& right);

}  // namespace phrame
