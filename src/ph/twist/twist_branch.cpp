#include "phrame/ph/twist/twist_branch.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

ComplexBall value_at(const Rotation& w, const RealBall& tau) {
  return {evaluate(w.a, tau, twist_proof_bits), evaluate(w.b, tau, twist_proof_bits)};
}

RealBall square_of(const RealBall& x) { return multiply(x, x, twist_proof_bits); }

/// x² ≥ this.
RealBall least_square(const RealBall& x) { return square_of(least_size(x, 53)); }

}  // namespace

TwistBranch::TwistBranch(const TwistPiece& piece, const RotationFamily& family,
                         const Rational& origin, long parts)
    : gamma_(family.end_factor[0]), gamma_slope_(family.end_factor[1]) {
  sign_of_gamma_ = sign(end_factor(family, {origin}, twist_proof_bits));
  const bool is_constant = gamma_slope_.is_zero();
  if (sign_of_gamma_ == 0 || (!is_constant && sign(gamma_slope_) == 0))
    throw Undecided("where the parameters with one sign of gamma end is not known");
  const Rotation w = member(family, {origin}, twist_proof_bits);
  const Polynomial share = antiderivative(piece.speed);
  const RealBall twist = piece.twist.enclose(twist_proof_bits);
  RealBall theta;
  for (long k = 0; k <= parts; ++k) {
    const Rational tau(k, parts);
    if (k > 0) {
      const auto turned = turn(w, Rational(k - 1, parts), tau, twist_proof_bits);
      if (!turned) throw Undecided("a rotation close to the best one may have a zero");
      theta = add(theta, *turned, twist_proof_bits);
    }
    const RealBall s = twist_ball(share(tau));
    const ComplexBall p = value_at(family.basis[0], twist_ball(tau));
    const ComplexBall q = value_at(family.basis[1], twist_ball(tau));
    const RealBall wanted =
        subtract(multiply(twist, s, twist_proof_bits),
                 piece.erf_twist(tau).enclose(twist_proof_bits), twist_proof_bits);
    nodes_.push_back({s, p, q, multiply(conjugate(p), q, twist_proof_bits).im(),
                      value_at(w, twist_ball(tau)), subtract(theta, wanted, twist_proof_bits),
                      k == 0 || k == parts});
  }
}

RealBall TwistBranch::deviation(const Node& node, const ComplexBall& w) const {
  if (node.is_end) return node.deviation;
  const RealBall angle =
      argument(multiply(w, conjugate(node.origin), twist_proof_bits), twist_proof_bits);
  return add(node.deviation, add(angle, angle, twist_proof_bits), twist_proof_bits);
}

bool TwistBranch::is_above(const ParameterRange& range, const RealBall& least) const {
  for (std::size_t stride = (nodes_.size() - 1) / 16; stride > 0; stride /= 4)
    if (is_above(range, least, stride)) return true;
  return false;
}

bool TwistBranch::is_above(const ParameterRange& range, const RealBall& least,
                           std::size_t stride) const {
  const Rational middle = (range.a + range.b) / 2;
  const RealBall offset =
      hull(Rational(range.a - middle), Rational(range.b - middle), twist_proof_bits);
  const RealBall whole = hull(range.a, range.b, twist_proof_bits);
  const auto slope = [&](const Node& node) -> RealBall {
    if (node.is_end) return {};
    const ComplexBall w = add(node.p, multiply(whole, node.q, twist_proof_bits), twist_proof_bits);
    const RealBall square = add(square_of(w.re()), square_of(w.im()), twist_proof_bits);
    return divide(add(node.cross, node.cross, twist_proof_bits), square, twist_proof_bits);
  };
  const auto in_middle = [&](const Node& node) {
    return deviation(node, add(node.p, multiply(twist_ball(middle), node.q, twist_proof_bits),
                               twist_proof_bits));
  };
  RealBall sum;
  RealBall last = in_middle(nodes_[0]);
  RealBall last_slope = slope(nodes_[0]);
  for (std::size_t k = stride; k < nodes_.size(); k += stride) {
    const RealBall here = in_middle(nodes_[k]);
    const RealBall here_slope = slope(nodes_[k]);
    const RealBall beside =
        multiply(offset, subtract(here_slope, last_slope, twist_proof_bits), twist_proof_bits);
    const RealBall change = add(subtract(here, last, twist_proof_bits), beside, twist_proof_bits);
    const RealBall length = subtract(nodes_[k].share, nodes_[k - stride].share, twist_proof_bits);
    sum = add(sum, divide(least_square(change), length, twist_proof_bits), twist_proof_bits);
    last = here;
    last_slope = here_slope;
  }
  return is_less(least, sum);
}

bool TwistBranch::is_above_beyond(const Rational& a, int direction, const RealBall& least,
                                  std::size_t parts) const {
  const std::size_t part = (nodes_.size() - 1) / parts;
  const auto limit = end(direction);
  std::vector<RealBall> ranges;
  for (std::size_t k = 0; k < nodes_.size(); k += part) {
    const Node& node = nodes_[k];
    const ComplexBall here =
        add(node.p, multiply(twist_ball(a), node.q, twist_proof_bits), twist_proof_bits);
    const RealBall at_a = deviation(node, here);
    if (node.is_end) {
      ranges.push_back(at_a);
      continue;
    }
    const ComplexBall there =
        limit ? add(node.p, multiply(*limit, node.q, twist_proof_bits), twist_proof_bits)
              : multiply(RealBall(direction, twist_proof_bits), node.q, twist_proof_bits);
    const RealBall angle =
        argument(multiply(there, conjugate(here), twist_proof_bits), twist_proof_bits);
    ranges.push_back(hull(at_a, add(at_a, add(angle, angle, twist_proof_bits), twist_proof_bits),
                          twist_proof_bits));
  }
  // Wide ranges are better compared over long parts.
  for (std::size_t stride = parts; stride > 0; stride /= 2) {
    RealBall sum;
    for (std::size_t k = 0; k < parts; k += stride) {
      const RealBall change = subtract(ranges[k + stride], ranges[k], twist_proof_bits);
      const RealBall length =
          subtract(nodes_[(k + stride) * part].share, nodes_[k * part].share, twist_proof_bits);
      sum = add(sum, divide(least_square(change), length, twist_proof_bits), twist_proof_bits);
    }
    if (is_less(least, sum)) return true;
  }
  return false;
}

std::optional<RealBall> TwistBranch::end(int direction) const {
  if (gamma_slope_.is_zero()) return std::nullopt;
  if (sign(gamma_slope_) * direction == sign_of_gamma_) return std::nullopt;
  return divide(multiply(gamma_, twist_ball(-1), twist_proof_bits), gamma_slope_, twist_proof_bits);
}

}  // namespace phrame
