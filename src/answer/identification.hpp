#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// Is a curve Pythagorean, and what is its preimage?
struct IdentificationAnswer {
  /// What is near a curve that is not Pythagorean.
  struct Near {
    Rational epsilon;                        ///< as asked
    std::variant<NearCurve, NotNear> found;  ///< the curve, or how far away the nearest one is
  };

  std::string name;                                         ///< of the curve
  std::variant<Curve, NotPythagorean> result;               ///< the curve, or why it is none
  std::optional<Near> near = std::nullopt;                  ///< where it was asked for
  std::optional<NearSuggestion> suggestion = std::nullopt;  ///< where it was not, but might be
};

/// A PH spline, or what stands for one that is not.
struct PathIdentification {
  NamedPhPath path;  ///< near to that, or itself
};

/// Where the curve is not Pythagorean, but ε is given, what is that near to it. Throws as
/// identify().
PHRAME_API IdentificationAnswer answer(const NamedHodograph& query,
                                       const std::optional<Rational>& epsilon = std::nullopt);

}  // namespace phrame
