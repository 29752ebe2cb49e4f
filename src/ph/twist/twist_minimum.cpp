#include "phrame/ph/twist/twist_minimum.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/twist/twist_error.hpp"

namespace phrame {
namespace {

/// What is too wide to be of use becomes infinite, never wrong.
constexpr long bits = 96;

ComplexBall evaluate(const Rotation& w, const RealBall& tau) {
  return {phrame::evaluate(w.a, tau, bits), phrame::evaluate(w.b, tau, bits)};
}

RealBall ball(const Rational& x) { return RealBall(x, bits); }

RealBall square_of(const RealBall& x) { return multiply(x, x, bits); }

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
  sign_of_gamma_ = sign(end_factor(family, {origin}, bits));
  const bool is_constant = gamma_slope_.is_zero();
  if (sign_of_gamma_ == 0 || (!is_constant && sign(gamma_slope_) == 0))
    throw Undecided("where the parameters with one sign of gamma end is not known");
  const Rotation w = member(family, {origin}, bits);
  const Polynomial share = antiderivative(piece.speed);
  const RealBall twist = piece.twist.enclose(bits);
  RealBall theta;
  for (long k = 0; k <= parts; ++k) {
    const Rational tau(k, parts);
    if (k > 0) {
      const auto turned = turn(w, Rational(k - 1, parts), tau, bits);
      if (!turned) throw Undecided("a rotation close to the best one may have a zero");
      theta = add(theta, *turned, bits);
    }
    const RealBall s = ball(share(tau));
    const ComplexBall p = evaluate(family.basis[0], ball(tau));
    const ComplexBall q = evaluate(family.basis[1], ball(tau));
    const RealBall wanted =
        subtract(multiply(twist, s, bits), piece.erf_twist(tau).enclose(bits), bits);
    nodes_.push_back({s, p, q, multiply(conjugate(p), q, bits).im(), evaluate(w, ball(tau)),
                      subtract(theta, wanted, bits), k == 0 || k == parts});
  }
}

RealBall Branch::deviation(const Node& node, const ComplexBall& w) const {
  if (node.is_end) return node.deviation;
  const RealBall angle = argument(multiply(w, conjugate(node.origin), bits), bits);
  return add(node.deviation, add(angle, angle, bits), bits);
}

bool Branch::is_above(const Range& range, const RealBall& least) const {
  for (std::size_t stride = (nodes_.size() - 1) / 16; stride > 0; stride /= 4)
    if (is_above(range, least, stride)) return true;
  return false;
}

bool Branch::is_above(const Range& range, const RealBall& least, std::size_t stride) const {
  const Rational middle = (range.a + range.b) / 2;
  const RealBall offset = hull(Rational(range.a - middle), Rational(range.b - middle), bits);
  const RealBall whole = hull(range.a, range.b, bits);
  const auto slope = [&](const Node& node) -> RealBall {
    if (node.is_end) return {};
    const ComplexBall w = add(node.p, multiply(whole, node.q, bits), bits);
    const RealBall square = add(square_of(w.re()), square_of(w.im()), bits);
    return divide(add(node.cross, node.cross, bits), square, bits);
  };
  const auto in_middle = [&](const Node& node) {
    return deviation(node, add(node.p, multiply(ball(middle), node.q, bits), bits));
  };
  RealBall sum;
  RealBall last = in_middle(nodes_[0]);
  RealBall last_slope = slope(nodes_[0]);
  for (std::size_t k = stride; k < nodes_.size(); k += stride) {
    const RealBall here = in_middle(nodes_[k]);
    const RealBall here_slope = slope(nodes_[k]);
    const RealBall beside = multiply(offset, subtract(here_slope, last_slope, bits), bits);
    const RealBall change = add(subtract(here, last, bits), beside, bits);
    const RealBall length = subtract(nodes_[k].share, nodes_[k - stride].share, bits);
    sum = add(sum, divide(least_square(change), length, bits), bits);
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
    const ComplexBall here = add(node.p, multiply(ball(a), node.q, bits), bits);
    const RealBall at_a = deviation(node, here);
    if (node.is_end) {
      ranges.push_back(at_a);
      continue;
    }
    const ComplexBall there = limit ? add(node.p, multiply(*limit, node.q, bits), bits)
                                    : multiply(RealBall(direction, bits), node.q, bits);
    const RealBall angle = argument(multiply(there, conjugate(here), bits), bits);
    ranges.push_back(hull(at_a, add(at_a, add(angle, angle, bits), bits), bits));
  }
  // Wide ranges are better compared over long parts.
  for (std::size_t stride = parts; stride > 0; stride /= 2) {
    RealBall sum;
    for (std::size_t k = 0; k < parts; k += stride) {
      const RealBall change = subtract(ranges[k + stride], ranges[k], bits);
      const RealBall length =
          subtract(nodes_[(k + stride) * part].share, nodes_[k * part].share, bits);
      sum = add(sum, divide(least_square(change), length, bits), bits);
    }
    if (is_less(least, sum)) return true;
  }
  return false;
}

std::optional<RealBall> Branch::end(int direction) const {
  if (gamma_slope_.is_zero()) return std::nullopt;
  if (sign(gamma_slope_) * direction == sign_of_gamma_) return std::nullopt;
  return divide(multiply(gamma_, ball(-1), bits), gamma_slope_, bits);
}

/// A lower bound of G″ on parameter intervals; −∞ where there is none.
class Bend {
 public:
  /// `smallness`: G″ is about 2^−smallness.
  Bend(const TwistPiece& piece, const RotationFamily& family, const Rational& centre,
       long smallness)
      : bend_(piece, family, centre, smallness + 8) {}

  RealBall operator()(const Range& range) {
    // The width comes from that of the range, so that many points often are of no use.
    const RealBall parameter = hull(range.a, range.b, bits);
    const RealBall quick = lower_end(bend_(parameter, 100), bits);
    return is_less({}, quick) ? quick : lower_end(bend_(parameter, 1000), bits);
  }

 private:
  MeanSquareBend bend_;
};

/// A range around the least value of G, on which G″ ≥ bend > 0.
struct Core {
  Range range;
  RealBall bend;
};

Core core_around(Bend& bend, const Rational& parameter, Rational width) {
  for (int failures = 0; failures < 40; ++failures, width /= 2) {
    const Range range{parameter - width, parameter + width};
    const RealBall least_bend = bend(range);
    if (is_less({}, least_bend)) return {range, least_bend};
  }
  throw Undecided("the mean square of the rates is too flat at its least value");
}

/// That G increases from a parameter on, away from its least value.
struct Climb {
  Bend& bend;
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
      const RealBall room = multiply(subtract(*limit, ball(a), bits), ball(direction), bits);
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
          add(climb->slope, multiply(climb->bend(range), ball(step), bits), bits);
      is_shown = is_less({}, slope);
      if (is_shown) climb.emplace(Climb{climb->bend, lower_end(slope, bits)});
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
    return absolute(evaluate(v, ball(Rational(1, 2))), bits);
  };
  const RealBall unit = divide(size(w), size(family.basis[1]), bits);
  if (!unit.is_finite() || !is_less({}, unit))
    throw Undecided("a rotation close to the best one may have a zero");
  return unit.midpoint();
}

/// Does it make no turns too many, for certain?
bool turns_as_wanted(const TwistPiece& piece, const Rotation& w) {
  const auto turned = turn(w, 0, 1, bits);
  return turned && is_less(absolute(subtract(*turned, piece.turn.enclose(bits), bits)), ball(1));
}

}  // namespace

TwistMinimum twist_minimum(const TwistPiece& piece, long degree, EndRates rates,
                           const LineGuess& guess, const std::optional<LineGuess>& other_guess,
                           long goal) {
  if (!guess.is_interior)
    throw Undecided("no least mean square was found: it decreases as an end of w tends to 0");
  if (!(guess.bend > 0) || !std::isfinite(guess.bend))
    throw Undecided("the mean square of the rates is too flat at its least value");
  // G″ is about 2^−smallness, which all precisions of integrals have to follow.
  const long smallness = std::max(0, 1 - std::ilogb(guess.bend));
  const RotationFamily family = rotation_family(piece, degree, rates, bits);
  const Rational start = exact_rational(guess.parameter);
  const Rotation w = member(family, {start}, bits);
  const long precision = goal + smallness + 10;
  const long working = working_precision(piece, precision);
  const RotationFamily fine = rotation_family(piece, degree, rates, working);
  const RealBall least = mean_square(piece, member(fine, {start}, working), smallness + 24);
  const Rational unit = natural_unit(family, w);

  // G ≥ (2πk)² where a frame makes k turns too many (Cauchy and Schwarz), and with the other sign
  // of γ it makes an odd number more.
  const RealBall one_turn = multiply(ball(2), pi(bits), bits);
  const bool is_other_worse = turns_as_wanted(piece, w) && is_less(least, square_of(one_turn));
  const bool has_one_sign = family.end_factor[1].is_zero();

  RealBall slope = mean_square_slope(piece, fine, start, precision);
  Bend bend(piece, fine, start, smallness);
  const Core core = core_around(bend, start, unit / 32);
  const Rational radius0 = (core.range.b - core.range.a) / 2;
  const RealBall climb =
      lower_end(subtract(multiply(core.bend, ball(radius0), bits), absolute(slope), bits), bits);
  if (!is_less({}, climb)) throw Undecided("the guess is too far from the least value");
  constexpr long most_parts = 256;
  for (long parts = 64;; parts *= 4) {
    try {
      const Branch branch(piece, family, start, parts);
      walk(branch, core.range.a, -1, radius0, least, Climb{bend, climb});
      walk(branch, core.range.b, 1, radius0, least, Climb{bend, climb});
      if (other_guess && !is_other_worse) {
        const Rational other = exact_rational(other_guess->parameter);
        const Branch other_branch(piece, family, other, parts / 4);
        walk(other_branch, other, -1, unit / 4, least);
        walk(other_branch, other, 1, unit / 4, least);
      }
      break;
    } catch (const Undecided&) {
      if (parts == most_parts) throw;
    }
  }

  // |p − p*| ≤ |G′(p)|/min G″ in the core; secants as in Newton's method.
  const Rational wanted = unit * power_of_two(-goal);
  Rational parameter = start;
  RealBall curvature = core.bend;
  for (int step = 0; step < 40 && slope.is_finite(); ++step) {
    if (divide(absolute(slope), core.bend, 53).upper() <= wanted)
      return {parameter, wanted, has_one_sign || is_other_worse || other_guess.has_value()};
    const RealBall here(parameter, precision);
    const RealBall next = subtract(here, divide(slope, curvature, precision), precision);
    const RealBall slope_here = slope;
    parameter = std::clamp(next.midpoint(), core.range.a, core.range.b);
    slope = mean_square_slope(piece, fine, parameter, precision);
    const RealBall run = subtract(RealBall(parameter, precision), here, precision);
    const RealBall secant = divide(subtract(slope, slope_here, precision), run, precision);
    if (is_less({}, secant)) curvature = secant;
  }
  throw Undecided("the precision does not suffice to enclose the best rotation");
}

}  // namespace phrame
