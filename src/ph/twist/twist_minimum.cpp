#include "phrame/ph/twist/twist_minimum.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/twist/twist_error.hpp"

namespace phrame {
namespace {

/// What is too wide to be of use becomes infinite, never wrong.
constexpr long proof_bits = 96;

ComplexBall evaluate(const Rotation& w, const RealBall& tau) {
  return {phrame::evaluate(w.a, tau, proof_bits), phrame::evaluate(w.b, tau, proof_bits)};
}

RealBall ball(const Rational& x) { return RealBall(x, proof_bits); }

RealBall square_of(const RealBall& x) { return multiply(x, x, proof_bits); }

/// x² ≥ this.
RealBall least_square(const RealBall& x) { return square_of(least_size(x, 53)); }

/// A parameter interval.
struct Range {
  Rational a;
  Rational b;
};

/// Lower bounds of G on a branch, the parameters with one sign of γ, from the angle Y(τ) between
/// the frame and the exact one, known along the branch from its value at one parameter: w(τ) goes
/// along a straight line that does not meet 0, so that its argument changes by a principal one.
class Branch {
 public:
  Branch(const TwistPiece& piece, const RotationFamily& family, const Rational& origin, long parts);

  /// Is G ≥ `least` on the whole range?
  bool is_above(const Range& range, const RealBall& least) const;
  /// Decided with every so many-th node.
  bool is_above(const Range& range, const RealBall& least, std::size_t stride) const;
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

Branch::Branch(const TwistPiece& piece, const RotationFamily& family, const Rational& origin,
               long parts)
    : gamma_(family.end_factor[0]), gamma_slope_(family.end_factor[1]) {
  sign_of_gamma_ = sign(end_factor(family, {origin}, proof_bits));
  const bool is_constant = gamma_slope_.is_zero();
  if (sign_of_gamma_ == 0 || (!is_constant && sign(gamma_slope_) == 0))
    throw Undecided("where the parameters with one sign of gamma end is not known");
  const Rotation w = member(family, {origin}, proof_bits);
  const Polynomial share = antiderivative(piece.speed);
  const RealBall twist = piece.twist.enclose(proof_bits);
  RealBall theta;
  for (long k = 0; k <= parts; ++k) {
    const Rational tau(k, parts);
    if (k > 0) {
      const auto turned = turn(w, Rational(k - 1, parts), tau, proof_bits);
      if (!turned) throw Undecided("a rotation close to the best one may have a zero");
      theta = add(theta, *turned, proof_bits);
    }
    const RealBall s = ball(share(tau));
    const ComplexBall p = evaluate(family.basis[0], ball(tau));
    const ComplexBall q = evaluate(family.basis[1], ball(tau));
    const RealBall wanted = subtract(multiply(twist, s, proof_bits),
                                     piece.erf_twist(tau).enclose(proof_bits), proof_bits);
    nodes_.push_back({s, p, q, multiply(conjugate(p), q, proof_bits).im(), evaluate(w, ball(tau)),
                      subtract(theta, wanted, proof_bits), k == 0 || k == parts});
  }
}

RealBall Branch::deviation(const Node& node, const ComplexBall& w) const {
  if (node.is_end) return node.deviation;
  const RealBall angle = argument(multiply(w, conjugate(node.origin), proof_bits), proof_bits);
  return add(node.deviation, add(angle, angle, proof_bits), proof_bits);
}

bool Branch::is_above(const Range& range, const RealBall& least) const {
  for (std::size_t stride = (nodes_.size() - 1) / 16; stride > 0; stride /= 4)
    if (is_above(range, least, stride)) return true;
  return false;
}

bool Branch::is_above(const Range& range, const RealBall& least, std::size_t stride) const {
  const Rational middle = (range.a + range.b) / 2;
  const RealBall offset = hull(Rational(range.a - middle), Rational(range.b - middle), proof_bits);
  const RealBall whole = hull(range.a, range.b, proof_bits);
  const auto slope = [&](const Node& node) -> RealBall {
    if (node.is_end) return {};
    const ComplexBall w = add(node.p, multiply(whole, node.q, proof_bits), proof_bits);
    const RealBall square = add(square_of(w.re()), square_of(w.im()), proof_bits);
    return divide(add(node.cross, node.cross, proof_bits), square, proof_bits);
  };
  const auto in_middle = [&](const Node& node) {
    return deviation(node, add(node.p, multiply(ball(middle), node.q, proof_bits), proof_bits));
  };
  RealBall sum;
  RealBall last = in_middle(nodes_[0]);
  RealBall last_slope = slope(nodes_[0]);
  for (std::size_t k = stride; k < nodes_.size(); k += stride) {
    const RealBall here = in_middle(nodes_[k]);
    const RealBall here_slope = slope(nodes_[k]);
    const RealBall beside =
        multiply(offset, subtract(here_slope, last_slope, proof_bits), proof_bits);
    const RealBall change = add(subtract(here, last, proof_bits), beside, proof_bits);
    const RealBall length = subtract(nodes_[k].share, nodes_[k - stride].share, proof_bits);
    sum = add(sum, divide(least_square(change), length, proof_bits), proof_bits);
    last = here;
    last_slope = here_slope;
  }
  return is_less(least, sum);
}

bool Branch::is_above_beyond(const Rational& a, int direction, const RealBall& least,
                             std::size_t parts) const {
  const std::size_t part = (nodes_.size() - 1) / parts;
  const auto limit = end(direction);
  std::vector<RealBall> ranges;
  for (std::size_t k = 0; k < nodes_.size(); k += part) {
    const Node& node = nodes_[k];
    const ComplexBall here = add(node.p, multiply(ball(a), node.q, proof_bits), proof_bits);
    const RealBall at_a = deviation(node, here);
    if (node.is_end) {
      ranges.push_back(at_a);
      continue;
    }
    const ComplexBall there = limit ? add(node.p, multiply(*limit, node.q, proof_bits), proof_bits)
                                    : multiply(RealBall(direction, proof_bits), node.q, proof_bits);
    const RealBall angle = argument(multiply(there, conjugate(here), proof_bits), proof_bits);
    ranges.push_back(hull(at_a, add(at_a, add(angle, angle, proof_bits), proof_bits), proof_bits));
  }
  // Wide ranges are better compared over long parts.
  for (std::size_t stride = parts; stride > 0; stride /= 2) {
    RealBall sum;
    for (std::size_t k = 0; k < parts; k += stride) {
      const RealBall change = subtract(ranges[k + stride], ranges[k], proof_bits);
      const RealBall length =
          subtract(nodes_[(k + stride) * part].share, nodes_[k * part].share, proof_bits);
      sum = add(sum, divide(least_square(change), length, proof_bits), proof_bits);
    }
    if (is_less(least, sum)) return true;
  }
  return false;
}

std::optional<RealBall> Branch::end(int direction) const {
  if (gamma_slope_.is_zero()) return std::nullopt;
  if (sign(gamma_slope_) * direction == sign_of_gamma_) return std::nullopt;
  return divide(multiply(gamma_, ball(-1), proof_bits), gamma_slope_, proof_bits);
}

/// A lower bound of G″ on parameter intervals; −∞ where there is none.
class Convexity {
 public:
  /// `smallness`: G″ is about 2^−smallness.
  Convexity(const TwistPiece& piece, const RotationFamily& family, const Rational& centre,
            long smallness)
      : convexity_(piece, family, centre, smallness + 8) {}

  RealBall operator()(const Range& range) {
    constexpr long most_points = 1000;
    return lower_end(convexity_(hull(range.a, range.b, proof_bits), most_points), proof_bits);
  }

 private:
  MeanSquareConvexity convexity_;
};

/// A range around the least value of G, on which G″ ≥ convexity > 0.
struct Core {
  Range range;
  RealBall convexity;
};

Core core_around(Convexity& convexity, const Rational& parameter, Rational width) {
  for (int failures = 0; failures < 40; ++failures, width /= 2) {
    const Range range{parameter - width, parameter + width};
    const RealBall least_convexity = convexity(range);
    if (is_less({}, least_convexity)) return {range, least_convexity};
  }
  throw Undecided("the mean square of the rates is too flat at its least value");
}

/// That G increases from a parameter on, away from its least value.
struct Climb {
  Convexity& convexity;
  RealBall slope;  ///< > 0: its rate there is no less
};

/// Shows that G > least from `from` to the end of the branch, in steps as large as can be decided:
/// by Branch, or as long as it must have increased all the way.
void walk(const Branch& branch, const Rational& from, int direction, Rational step,
          const RealBall& least, std::optional<Climb> climb = {}) {
  constexpr int most_steps = 300;
  const auto limit = branch.end(direction);
  Rational a = from;
  Rational growth = 2;
  // Few parts do, or nearly always.
  const auto is_done = [&](int steps) {
    return branch.is_above_beyond(a, direction, least, steps % 8 == 7 ? branch.parts() : 16);
  };
  for (int steps = 0; !is_done(steps); ++steps) {
    if (limit) {  // the end itself is for is_above_beyond
      const RealBall room =
          multiply(subtract(*limit, ball(a), proof_bits), ball(direction), proof_bits);
      for (; !is_less(ball(step), room) && steps <= most_steps; ++steps) step /= 2;
    }
    if (steps > most_steps)
      throw Undecided("other rotations are too nearly as good for the proof that one is the best");
    const Rational b = a + direction * step;
    const Range range{std::min(a, b), std::max(a, b)};
    bool is_shown = branch.is_above(range, least);
    if (is_shown) {
      climb.reset();
    } else if (climb) {
      const RealBall slope =
          add(climb->slope, multiply(climb->convexity(range), ball(step), proof_bits), proof_bits);
      is_shown = is_less({}, slope);
      if (is_shown) climb.emplace(Climb{climb->convexity, lower_end(slope, proof_bits)});
    }
    if (is_shown) {
      a = b;
      step *= growth;
    } else {
      step /= 2;
      growth = Rational(5, 4);
    }
  }
}

/// The change of the parameter that moves w(1/2) by its own length.
Rational natural_unit(const RotationFamily& family, const Rotation& w) {
  const auto size = [](const Rotation& v) {
    return absolute(evaluate(v, ball(Rational(1, 2))), proof_bits);
  };
  const RealBall unit = divide(size(w), size(family.basis[1]), proof_bits);
  if (!unit.is_finite() || !is_less({}, unit))
    throw Undecided("a rotation close to the best one may have a zero");
  return unit.midpoint();
}

/// A guess at the best member of a family, and what the proof around it works with.
struct Candidate {
  const TwistPiece& piece;
  RotationFamily family;
  Rational parameter;
  Rotation w = {};
  Rational unit = {};  ///< the change of the parameter that moves w(1/2) by its own length
  long smallness = 0;  ///< G″ is about 2^−smallness, which all precisions of integrals follow
  long precision = 0;  ///< of G′, whose zero is the best parameter
  RotationFamily fine = {};   ///< the family, as precise as that takes
  RealBall mean_square = {};  ///< G
};

Candidate candidate(const TwistPiece& piece, long degree, EndRates rates, const LineGuess& guess,
                    long goal) {
  if (!guess.is_interior)
    throw Undecided("no least mean square was found: it decreases as an end of w tends to 0");
  if (!(guess.convexity > 0) || !std::isfinite(guess.convexity))
    throw Undecided("the mean square of the rates is too flat at its least value");
  Candidate result{piece, rotation_family(piece, degree, rates, proof_bits),
                   exact_rational(guess.parameter)};
  result.w = member(result.family, {result.parameter}, proof_bits);
  result.unit = natural_unit(result.family, result.w);
  result.smallness = std::max(0, 1 - std::ilogb(guess.convexity));
  result.precision = goal + result.smallness + 10;
  const long working = working_precision(piece, result.precision);
  result.fine = rotation_family(piece, degree, rates, working);
  result.mean_square =
      mean_square(piece, member(result.fine, {result.parameter}, working), result.smallness + 24);
  return result;
}

/// Is it known that all rotations with the other sign of γ have a greater G? A frame that makes k
/// turns more than the exact one has G ≥ (2πk)² (Cauchy and Schwarz). If this one makes none, one
/// with the other sign makes an odd number.
bool is_better_than_other_sign(const Candidate& c) {
  const auto turned = turn(c.w, 0, 1, proof_bits);
  if (!turned) return false;
  const RealBall excess = subtract(*turned, c.piece.turn.enclose(proof_bits), proof_bits);
  const RealBall one_turn = multiply(ball(2), pi(proof_bits), proof_bits);
  return is_less(absolute(excess), ball(1)) && is_less(c.mean_square, square_of(one_turn));
}

/// Shows that G is greater than that of the candidate outside its core, and on the branch with the
/// other sign of γ if a parameter there is given; on that, with a quarter of the parts.
void show_greater(const Candidate& c, const Core& core, const Climb& climb,
                  const std::optional<Rational>& other_sign, long parts) {
  const Branch branch(c.piece, c.family, c.parameter, parts);
  const Rational step = (core.range.b - core.range.a) / 2;
  walk(branch, core.range.a, -1, step, c.mean_square, climb);
  walk(branch, core.range.b, 1, step, c.mean_square, climb);
  if (!other_sign) return;
  const Branch other(c.piece, c.family, *other_sign, parts / 4);
  walk(other, *other_sign, -1, c.unit / 4, c.mean_square);
  walk(other, *other_sign, 1, c.unit / 4, c.mean_square);
}

/// The same with as many parts as it takes.
void show_greater(const Candidate& c, const Core& core, const Climb& climb,
                  const std::optional<Rational>& other_sign) {
  constexpr long most_parts = 256;
  for (long parts = 64;; parts *= 4) {
    try {
      return show_greater(c, core, climb, other_sign, parts);
    } catch (const Undecided&) {
      if (parts == most_parts) throw;
    }
  }
}

/// A parameter that is within `radius` of the zero of G′ in the core, given G′ at the candidate:
/// |p − p*| ≤ |G′(p)|/min G″. The steps are those of the secant method.
Rational zero_of_slope(const Candidate& c, const Core& core, RealBall slope,
                       const Rational& radius) {
  Rational parameter = c.parameter;
  RealBall convexity = core.convexity;  // G″, about
  for (int step = 0; step < 40 && slope.is_finite(); ++step) {
    if (divide(absolute(slope), core.convexity, 53).upper() <= radius) return parameter;
    const RealBall here(parameter, c.precision);
    const RealBall next = subtract(here, divide(slope, convexity, c.precision), c.precision);
    parameter = std::clamp(next.midpoint(), core.range.a, core.range.b);
    const RealBall next_slope = mean_square_slope(c.piece, c.fine, parameter, c.precision);
    const RealBall run = subtract(RealBall(parameter, c.precision), here, c.precision);
    const RealBall secant = divide(subtract(next_slope, slope, c.precision), run, c.precision);
    if (is_less({}, secant)) convexity = secant;
    slope = next_slope;
  }
  throw Undecided("the precision does not suffice to enclose the best rotation");
}

}  // namespace

TwistMinimum twist_minimum(const TwistPiece& piece, long degree, EndRates rates,
                           const LineGuess& guess, const std::optional<LineGuess>& other_guess,
                           long goal) {
  const Candidate c = candidate(piece, degree, rates, guess, goal);
  Convexity convexity(piece, c.fine, c.parameter, c.smallness);
  const Core core = core_around(convexity, c.parameter, c.unit / 32);
  const RealBall slope = mean_square_slope(piece, c.fine, c.parameter, c.precision);
  // G′ at the ends of the core, away from the candidate, is no less than this.
  const RealBall half_width = ball((core.range.b - core.range.a) / 2);
  const RealBall climb = lower_end(
      subtract(multiply(core.convexity, half_width, proof_bits), absolute(slope), proof_bits),
      proof_bits);
  if (!is_less({}, climb)) throw Undecided("the guess is too far from the least value");

  const bool is_other_worse = is_better_than_other_sign(c);
  std::optional<Rational> other_sign;  // a parameter there, if that branch has to be walked
  if (other_guess && !is_other_worse) other_sign = exact_rational(other_guess->parameter);
  show_greater(c, core, {convexity, climb}, other_sign);

  const Rational radius = c.unit * power_of_two(-goal);
  const bool has_one_sign = c.family.end_factor[1].is_zero();
  return {zero_of_slope(c, core, slope, radius), radius,
          has_one_sign || is_other_worse || other_sign.has_value()};
}

}  // namespace phrame
