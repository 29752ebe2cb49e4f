#pragma once
#include <variant>

#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// Is a curve Pythagorean, and what is its preimage?
struct IdentificationAnswer {
  std::string name;                            ///< of the curve
  std::variant<Curve, NotPythagorean> result;  ///< the curve, or why it is none
};

/// Throws as identify().
IdentificationAnswer answer(const NamedHodograph& query);

}  // namespace phrame
