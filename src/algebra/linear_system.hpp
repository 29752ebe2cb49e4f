#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// The numbers x_k with Σ x_k · columns[k] = right side. No value where the matrix is not seen to
/// be regular. Precondition: it is square.
std::optional<std::vector<RealBall>> solve(const std::vector<std::vector<RealBall>>& columns,
                                           const std::vector<RealBall>& right_side, long bits);

/// A basis of all (x₀, x₁, …) with Σ x_k · p_k = 0, in echelon form: the last entry of each that is
/// not 0 is 1, and the others are 0 there.
std::vector<std::vector<Rational>> linear_relations(const std::vector<Polynomial>& p);

}  // namespace phrame
