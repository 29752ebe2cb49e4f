#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/twist/twist_objective.hpp"

namespace phrame::inline v0 {

/// A member of a family with one parameter.
struct LineGuess {
  double parameter;
  double value;      ///< G
  double convexity;  ///< G″
  bool is_interior;  ///< false where G decreases towards an end of the branch
};

/// Near the least G among those with this sign of γ; no value where none was found. Refines the
/// quadrature.
std::optional<LineGuess> search_line(TwistObjective& objective, int sign_of_gamma);

/// Parameters near a local minimum of G, by NLopt's SLSQP from the given ones. Refines the
/// quadrature.
std::vector<double> search(TwistObjective& objective, std::vector<double> start);

}  // namespace phrame
