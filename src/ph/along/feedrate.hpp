#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/formula.hpp"

namespace phrame::inline v0 {

/// A feedrate: the speed V = ds/dt at which a tool moves along a path, a rational function of one
/// of its own quantities. Constant, linear or quadratic in the arc length, any polynomial in the
/// parameter, V₀/(1 + κd) for a plane curve: all are of this kind [Farouki 2008]. Beside these
/// there are formulas, their least and greatest, in pieces; and limits of the acceleration, with
/// which V is not the speed but the greatest one, and the motion is the fastest under all of them.
struct Feedrate {
  /// The quantity that the speed is a function of.
  enum class Of {
    arc_length,  ///< s
    parameter,   ///< t
    curvature,   ///< κ, signed, of a plane curve
  };
  /// A formula of one of them.
  struct Function {
    Formula speed;  ///< V, of that quantity
    Of of;          ///< which one it is

    friend bool operator==(const Function&, const Function&) = default;
  };
  /// V on a part of the path.
  struct Piece {
    /// The least of these greatest ones: min(a, max(b, c)) is {{a}, {b, c}}.
    std::vector<std::vector<Function>> least_of;
    std::optional<Rational> end = {};  ///< where it ends; of the last piece there is none

    friend bool operator==(const Piece&, const Piece&) = default;
  };
  /// Of the acceleration, each by itself: |a|² is the sum of both squares.
  struct Limits {
    std::optional<Rational> normal = {};      ///< κv² ≤ it, > 0
    std::optional<Rational> tangential = {};  ///< |dv/dt| ≤ it, > 0
    /// @{ v at the start and at the end of the path, ≥ 0, where there is a tangential limit.
    Rational start_speed = 0;
    Rational end_speed = 0;
    /// @}

    friend bool operator==(const Limits&, const Limits&) = default;
  };

  RationalFunction speed = {};       ///< V, of that quantity
  Of of = Of::arc_length;            ///< which one it is
  std::vector<Piece> pieces = {};    ///< V where there are any: `speed` is none then
  bool ends_are_parameters = false;  ///< are the ends of pieces t, and not s?
  Limits limits = {};                ///< of the acceleration

  /// Is V a rational function, without a limit of the acceleration?
  bool is_rational() const { return pieces.empty() && !limits.normal && !limits.tangential; }
  friend bool operator==(const Feedrate&, const Feedrate&) = default;
};

/// V > 0 as a function of the quantity, which goes from 0 to `end`. Throws DomainError where it is
/// 0, infinite or negative there, decided exactly, with `place_of(x)` of the first such x;
/// Undecided where the end is not told from it.
PHRAME_API void require_positive(
    const RationalFunction& speed, const Real& end,
    const std::function<std::string(const RealAlgebraic& x)>& place_of);
/// The same of a function of the parameter of a segment that starts at t = `start`.
PHRAME_API void require_positive_along(const RationalFunction& speed, const Rational& start);
/// V(0), where the curvature is 0 all along. Throws DomainError where that is not positive.
PHRAME_API Rational speed_without_curvature(const RationalFunction& speed);

/// V of the parameter of the path, which is t + start, or of the curvature, as a function of the
/// parameter t of a PH curve. Throws DomainError where the curvature is no rational function
/// (signed_curvature() says why).
PHRAME_API RationalFunction speed_along(const Curve& curve, const Feedrate& feedrate,
                                        const Rational& start = 0);
/// |f|σ/V, the rate dT/dt at which time passes. Throws DomainError as above, where f changes sign
/// on [0, 1], and where V is not positive and finite on all of [0, 1]: decided exactly, with the
/// place of the zero or the pole.
PHRAME_API RationalFunction travel_time_rate(const Curve& curve, const Feedrate& feedrate,
                                             const Rational& start = 0);

}  // namespace phrame
