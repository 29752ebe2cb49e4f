#pragma once
#include <variant>

#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// Is a curve Pythagorean, and what is its preimage?
struct IdentificationAnswer {
  /// What is near a curve that is not Pythagorean.
  struct Near {
    Rational epsilon;
    std::variant<NearCurve, NotNear> found;
  };

  std::string name;
  std::variant<Curve, NotPythagorean> result;
  std::optional<Near> near = std::nullopt;                  ///< where it was asked for
  std::optional<NearSuggestion> suggestion = std::nullopt;  ///< where it was not, but might be
};

/// Where the curve is not Pythagorean, but ε is given, what is that near to it.
IdentificationAnswer answer(const NamedHodograph& query,
                            const std::optional<Rational>& epsilon = std::nullopt);

}  // namespace phrame
