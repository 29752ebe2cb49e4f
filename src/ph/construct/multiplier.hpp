#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// What of a multiplier may be changed.
enum class MultiplierFreedom {
  all,        ///< all; its degree becomes 2 at least
  inner_only  ///< not f(0) and f(1), so that the derivatives at the ends stay; 4 at least
};

/// The Bernstein coefficients of the multiplier next to f with ∫₀¹ f·A i A* = displacement,
/// exactly: that for which the sum of the squares of the changes is least. A, so frames, helices,
/// RRMF and h ≡ 0, does not see f. No value where there is none: a line goes along itself only, a
/// plane curve in its plane only.
std::optional<std::vector<Rational>> multiplier_with(const QuaternionPolynomial& a,
                                                     const std::vector<Rational>& f,
                                                     const Vector<Rational>& displacement,
                                                     MultiplierFreedom freedom);

/// The same for f ≥ 0 where that stays so and no coefficient changes by more than a 2^−20th of the
/// greatest of f; else no value.
std::optional<std::vector<Rational>> slight_multiplier(const QuaternionPolynomial& a,
                                                       const std::vector<Rational>& f,
                                                       const Vector<Rational>& displacement,
                                                       MultiplierFreedom freedom);

/// What Undecided says of a segment that has none.
inline constexpr std::string_view no_slight_multiplier =
    "no slight change of its speed leads to its point exactly, for it is straight or plane, or "
    "nearly; without exact points it comes as near as asked";

}  // namespace phrame
