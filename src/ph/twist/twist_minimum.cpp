#include "phrame/ph/twist/twist_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/twist/twist_branch.hpp"
#include "phrame/ph/twist/twist_error.hpp"

namespace phrame::inline v0 {
namespace {

/// A lower bound of G″ on parameter intervals; −∞ where there is none. Kept, since each attempt of
/// a proof goes over the same intervals.
class Convexity {
 public:
  /// `smallness`: G″ is about 2^−smallness.
  Convexity(const TwistPiece& piece, const RotationFamily& family, const Rational& centre,
            long smallness)
      : convexity_(piece, family, centre, smallness + 8) {}

  RealBall operator()(const ParameterRange& range) {
    constexpr long most_points = 1000;
    const auto [known, is_new] = known_.try_emplace({range.a, range.b});
    if (is_new)
      known->second = lower_end(convexity_(hull(range.a, range.b, twist_proof_bits), most_points),
                                twist_proof_bits);
    return known->second;
  }

 private:
  MeanSquareConvexity convexity_;
  std::map<std::pair<Rational, Rational>, RealBall> known_;
};

/// A range around the least value of G, on which G″ ≥ convexity > 0.
struct Core {
  ParameterRange range;
  RealBall convexity;
};

Core core_around(Convexity& convexity, const Rational& parameter, Rational width) {
  for (int failures = 0; failures < 40; ++failures, width /= 2) {
    const ParameterRange range{parameter - width, parameter + width};
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
/// by TwistBranch, or as long as it must have increased all the way.
void walk(const TwistBranch& branch, const Rational& from, int direction, Rational step,
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
      const RealBall room = multiply(subtract(*limit, twist_ball(a), twist_proof_bits),
                                     twist_ball(direction), twist_proof_bits);
      for (; !is_less(twist_ball(step), room) && steps <= most_steps; ++steps) step /= 2;
    }
    if (steps > most_steps)
      throw Undecided("other rotations are too nearly as good for the proof that one is the best");
    const Rational b = a + direction * step;
    const ParameterRange range{std::min(a, b), std::max(a, b)};
    bool is_shown = branch.is_above(range, least);
    if (is_shown) {
      climb.reset();
    } else if (climb) {
      const RealBall slope =
          add(climb->slope, multiply(climb->convexity(range), twist_ball(step), twist_proof_bits),
              twist_proof_bits);
      is_shown = is_less({}, slope);
      if (is_shown) climb.emplace(Climb{climb->convexity, lower_end(slope, twist_proof_bits)});
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
  const RealBall half = twist_ball(Rational(1, 2));
  const auto size = [&](const Rotation& v) {
    return absolute(
        ComplexBall(evaluate(v.a, half, twist_proof_bits), evaluate(v.b, half, twist_proof_bits)),
        twist_proof_bits);
  };
  const RealBall unit = divide(size(w), size(family.basis[1]), twist_proof_bits);
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
  Candidate result{piece, rotation_family(piece, degree, rates, twist_proof_bits),
                   exact_rational(guess.parameter)};
  result.w = member(result.family, {result.parameter}, twist_proof_bits);
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
  const auto turned = turn(c.w, 0, 1, twist_proof_bits);
  if (!turned) return false;
  const RealBall excess =
      subtract(*turned, c.piece.turn.enclose(twist_proof_bits), twist_proof_bits);
  const RealBall one_turn = multiply(twist_ball(2), pi(twist_proof_bits), twist_proof_bits);
  return is_less(absolute(excess), twist_ball(1)) &&
         is_less(c.mean_square, multiply(one_turn, one_turn, twist_proof_bits));
}

/// Shows that G is greater than that of the candidate outside its core, and on the branch with the
/// other sign of γ if a parameter there is given; on that, with a quarter of the parts.
void show_greater(const Candidate& c, const Core& core, const Climb& climb,
                  const std::optional<Rational>& other_sign, long parts) {
  const TwistBranch branch(c.piece, c.family, c.parameter, parts);
  const Rational step = (core.range.b - core.range.a) / 2;
  walk(branch, core.range.a, -1, step, c.mean_square, climb);
  walk(branch, core.range.b, 1, step, c.mean_square, climb);
  if (!other_sign) return;
  const TwistBranch other(c.piece, c.family, *other_sign, parts / 4);
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
  const RealBall half_width = twist_ball((core.range.b - core.range.a) / 2);
  const RealBall climb = lower_end(subtract(multiply(core.convexity, half_width, twist_proof_bits),
                                            absolute(slope), twist_proof_bits),
                                   twist_proof_bits);
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
