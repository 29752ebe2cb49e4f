#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/twist/twist_objective.hpp"

namespace phrame::inline v0 {

/// @{ The precision of balls in proofs about a minimum, and such a ball. What is too wide to be of
/// use becomes infinite, never wrong.
inline constexpr long twist_proof_bits = 96;
inline RealBall twist_ball(const Rational& x) { return RealBall(x, twist_proof_bits); }
/// @}

/// An interval of the parameter of a RotationFamily.
struct ParameterRange {
  Rational a;
  Rational b;
};

/// Lower bounds of the mean square G on a branch, the parameters with one sign of γ, from the angle
/// Y(τ) between the frame and the exact one, known along the branch from its value at one
/// parameter: w(τ) goes along a straight line that does not meet 0, so that its argument changes by
/// a principal one.
class TwistBranch {
 public:
  TwistBranch(const TwistPiece& piece, const RotationFamily& family, const Rational& origin,
              long parts);

  /// Is G > `least` on the whole range?
  bool is_above(const ParameterRange& range, const RealBall& least) const;
  /// Decided with every so many-th node.
  bool is_above(const ParameterRange& range, const RealBall& least, std::size_t stride) const;
  /// Is it for all parameters beyond a, up to the end of the branch? Decided with so many parts.
  bool is_above_beyond(const Rational& a, int direction, const RealBall& least,
                       std::size_t parts) const;
  std::size_t parts() const { return nodes_.size() - 1; }
  /// The end of the branch in a direction; no value where it is infinite.
  std::optional<RealBall> end(int direction) const;

 private:
  struct Node {
    RealBall share;  ///< of the length, up to here
    ComplexBall p;   ///< w⁰ and w¹
    ComplexBall q;
    RealBall cross;      ///< Im(p̄q)
    ComplexBall origin;  ///< w at the origin
    RealBall deviation;  ///< Y there
    bool is_end;         ///< τ is 0 or 1: Y does not depend on the parameter
  };

  RealBall deviation(const Node& node, const ComplexBall& w) const;

  std::vector<Node> nodes_;
  RealBall gamma_;
  RealBall gamma_slope_;
  int sign_of_gamma_;
};

}  // namespace phrame
