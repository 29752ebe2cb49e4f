#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/twist/rational_twist.hpp"

namespace phrame::inline v0 {

/// Where a rational frame of minimal twist is divided, beside the joints.
struct Subdivision {
  std::vector<Rational> at;     ///< parameters of the path
  bool at_inflections = false;  ///< of the Euler–Rodrigues frame, where it turns back
  bool at_extrema = false;      ///< of its rate ω₁ [Farouki, Moon 2018, (17), (18)]
  /// Divide pieces along which the frame turns back, or turns more than it should, at their
  /// inflections and extrema, and where there are none in the middle, until there is no such piece.
  bool until_monotone = false;
  /// Divide pieces in the middle until the root mean square of Ω₁ − Ω̄₁ is at most this: relative
  /// to |Ω̄₁|, or where Ω̄₁ = 0 times the length of the curve.
  std::optional<Rational> tolerance = {};
};

/// A frame whose Ω₁ has one sign, or not.
enum class Monotone { yes, no, undecided };

/// A rational frame along a curve or spline, piece by piece.
struct TwistFrame {
  std::vector<BestTwist> pieces;  ///< from the start of the path to its end
};

/// The rational frame next to the frame of minimal twist, piece by piece. Irrational points of
/// division are replaced by rational numbers within 2^−options.bits of them. Throws DomainError as
/// twist_pieces() and best_twist() do, and where the angle is not that to the Euler–Rodrigues
/// frame; Undecided where 1000 pieces are not enough.
PHRAME_API TwistFrame twist_frame(const MinimalTwist& mtf, const RationalTwistOptions& options,
                                  const Subdivision& subdivision);

/// θ at the parameter t ∈ [0, end] of the curve or spline, of the later piece at a joint. Throws
/// DomainError outside.
PHRAME_API Real value(const TwistFrame& frame, const Real& t);

/// Has Ω₁ one sign along this piece? `no` where it changes its sign.
PHRAME_API Monotone is_monotone(const RationalTwist& twist);
/// The same by the sign changes of Ω₁.
PHRAME_API Monotone is_monotone(const SignChanges& changes);
/// Has Ω₁ the same sign along all pieces?
PHRAME_API Monotone is_monotone(const TwistFrame& frame);

/// An error of Ω₁ times the length of its piece, as a share of |Ω̄₁|; where that is 0, times the
/// length of the whole.
PHRAME_API Real relative_error(const Real& error, const MinimalTwist& mtf, const Real& length);

/// The root mean square of Ω₁ − Ω̄₁ along the whole curve, times its length.
PHRAME_API Real root_mean_square(const TwistFrame& frame);

}  // namespace phrame
