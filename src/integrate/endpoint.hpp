#pragma once
#include <optional>
#include <variant>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// −∞ and ∞.
enum class Infinity { negative, positive };

/// An end of a path of integration.
using Endpoint = std::variant<Rational, RealAlgebraic, Infinity>;

/// Is it −∞ or ∞?
inline bool is_infinite(const Endpoint& end) { return std::holds_alternative<Infinity>(end); }

/// The number, of a finite end.
PHRAME_API std::optional<RealAlgebraic> finite(const Endpoint& end);

/// A ball around a finite end, as narrow as enclose(RealAlgebraic, bits). Throws DomainError for an
/// infinite one.
PHRAME_API RealBall enclose(const Endpoint& end, long bits);

/// Of a finite end, those of its number; of an infinite one, 0.
PHRAME_API long bits_of(const Endpoint& end);

/// From −∞ over the real numbers to ∞.
PHRAME_API std::strong_ordering compare(const Endpoint& a, const Endpoint& b);

}  // namespace phrame
