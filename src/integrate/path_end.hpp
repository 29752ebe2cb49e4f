#pragma once
#include "phrame/export.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/endpoint.hpp"

namespace phrame::inline v0 {

/// g(π), where g ∈ ℚ(x) is not constant: a transcendental number [Baker 1975, chapter 1], so that
/// it is no pole of a rational function, and the same number as h(π) only for h = g.
struct PiValue {
  RationalFunction of_pi;  ///< g
  friend bool operator==(const PiValue&, const PiValue&) = default;
};

/// The number. Its enclosures are finite only from some precision on.
PHRAME_API Real to_real(const PiValue& x);

/// An Endpoint, or one that is no algebraic number.
using PathEnd = std::variant<Rational, RealAlgebraic, Infinity, PiValue>;

/// definite_integral() between ends of any kind, which throws as that does. Between ends with a π
/// the value is known in finite terms only where it is seen to be rational.
PHRAME_API DefiniteIntegral path_integral(const RationalFunction& f, const PathEnd& a,
                                          const PathEnd& b, AtPoles at_poles = AtPoles::refuse);

}  // namespace phrame
