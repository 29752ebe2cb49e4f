#pragma once
#include <variant>

#include "phrame/algebra/real_algebraic.hpp"

namespace phrame {

enum class Infinity { negative, positive };

/// An end of a path of integration.
using Endpoint = std::variant<Rational, RealAlgebraic, Infinity>;

}  // namespace phrame
