#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/curve/curve.hpp"

namespace phrame {

/// What a multiplier may change.
enum class MultiplierFreedom {
  all,        ///< f is quadratic
  inner_only  ///< f is quartic with f(0) = f(1) = 1: the derivatives at the ends stay
};

/// The Bernstein coefficients of an f with ∫₀¹ f·A i A* = displacement, exactly: of all those the f
/// for which the sum of the squares of what they differ from 1 is least. A, so frames, helices,
/// RRMF and h ≡ 0, does not see f. No value where there is none: a line goes along itself only, a
/// plane curve in its plane only.
std::optional<std::vector<Rational>> multiplier_with(const QuaternionPolynomial& a,
                                                     const Vector<Rational>& displacement,
                                                     MultiplierFreedom freedom);

}  // namespace phrame
