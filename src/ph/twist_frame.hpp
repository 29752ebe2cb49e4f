#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/rational_twist.hpp"

namespace phrame {

/// Where the Euler–Rodrigues frame of a curve changes the direction in which it turns about e₁: the
/// zeros of odd order of h in (0, 1).
std::vector<RealAlgebraic> erf_inflections(const Curve& curve);
/// Where its rate ω₁ = 2h/(fσ²) has a local extremum in (0, 1): the zeros of odd order of
/// (h/(fσ²))′, of σh′ − 2σ′h for f = 1 [Farouki, Moon 2018, (18)]. None where ω₁ is constant.
std::vector<RealAlgebraic> erf_extrema(const Curve& curve);

/// Where a rational frame of minimal twist is divided, beside the joints.
struct Subdivision {
  std::vector<Rational> at;
  bool at_inflections = false;  ///< of the Euler–Rodrigues frame
  bool at_extrema = false;      ///< of its rate
  /// Pieces along which the frame turns back, or more than it should, are divided at the points of
  /// the two kinds above in them, and if there are none in the middle, until there is no such
  /// piece.
  bool until_monotone = false;
  /// Pieces are divided in the middle until the root mean square of Ω₁ − Ω̄₁ over |Ω̄₁|, or times
  /// the length of the curve where Ω̄₁ = 0, is at most this.
  std::optional<Rational> tolerance = {};
};

/// A frame whose Ω₁ has one sign, or not.
enum class Monotone { yes, no, undecided };
std::string_view to_string(Monotone monotone);

/// A rational frame along a curve or spline, piece by piece. Refers to the frame of minimal twist.
struct TwistFrame {
  std::vector<BestTwist> pieces;
};

/// Irrational points are taken as rational numbers within 2^−options.bits of them. Throws
/// DomainError as twist_pieces() and best_twist() do, and Undecided where 1000 pieces are not
/// enough.
TwistFrame twist_frame(const MinimalTwist& mtf, const RationalTwistOptions& options,
                       const Subdivision& subdivision);

/// θ at the parameter t ∈ [0, end] of the curve or spline, of the later piece at a joint. Throws
/// DomainError outside.
Real value(const TwistFrame& frame, const Real& t);

/// Of one piece: `no` where Ω₁ changes its sign.
Monotone is_monotone(const RationalTwist& twist);
/// Of the whole frame: all pieces, with the same sign.
Monotone is_monotone(const TwistFrame& frame);

/// The root mean square of Ω₁ − Ω̄₁ along the whole curve, times its length.
Real root_mean_square(const TwistFrame& frame);

}  // namespace phrame
