#include "phrame/ph/along/reduced_angle.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// The whole k with x ∈ (2k − 1, 2k + 1].
Integer nearest_turns(const Rational& x) { return -floor((1 - x) / 2); }

/// The same, if it is the same for the whole ball.
std::optional<Integer> whole_turns(const RealBall& x, long bits) {
  const RealBall shifted = divide(add(x, RealBall(-1, bits), bits), RealBall(2, bits), bits);
  return unique_ceiling(shifted, bits);
}

Real less_turns(const Real& x, const Integer& turns) {
  return turns == 0 ? x : x + whole_turn(-turns);
}

}  // namespace

FrameAngle reduced(const FrameAngle& angle) {
  FrameAngle rest = angle;
  rest.half_turns -= Rational(2 * nearest_turns(angle.half_turns));
  if (const auto half_turns = over_pi(rest)) {
    rest.half_turns -= Rational(2 * nearest_turns(*half_turns));
    return rest;
  }
  // Irrational over π, so that a ball that is narrow enough holds no odd multiple of π.
  const Real x = to_real(rest);
  for (long bits = 64;; bits *= 2)
    if (const auto turns = whole_turns(divide(x.enclose(bits), pi(bits), bits), bits)) {
      rest.half_turns -= Rational(2 * *turns);
      return rest;
    }
}

Real whole_turn(const Integer& k) { return to_real(Angle(Rational(2 * k), 0)); }

ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi,
                     long most_bits) {
  // Few bits nearly always tell it from a multiple of π.
  bool was_asked = false;
  for (long bits = 80;; bits = std::min(most_bits, bits == 80 ? 512 : 4 * bits)) {
    const RealBall y = divide(x.enclose(bits), pi(bits), bits);
    const bool is_near = contains_integer(y);
    if (is_near && bits > 80 && !was_asked && unique_integer(y)) {
      was_asked = true;
      const auto known = over_pi();
      if (known && denominator(*known) == 1) {
        const Integer n(numerator(*known));
        if (n % 2 == 0) return {Rational(0), n / 2, std::nullopt};
        return {to_real(Angle(1, 0)), (n - 1) / 2, Rational(0)};
      }
    }
    if (!is_near || was_asked)
      if (const auto turns = whole_turns(y, bits))
        return {less_turns(x, *turns), *turns, std::nullopt};
    if (bits < most_bits) continue;
    const auto n = unique_integer(y);
    if (!n)
      throw Undecided(fmt::format(
          "{} bits of precision do not tell an angle from an odd multiple of pi", bits));
    const RealBall apart = subtract(y, RealBall(Rational(*n), bits), bits);
    const Integer turns = (*n - 1) / 2;
    return {less_turns(x, turns), turns, Rational(4 * absolute(apart).upper())};
  }
}

ReducedAngle reduced(const Real& x) {
  return reduced(
      x, [&x] { return over_pi(x); }, 256);
}

RealBall reduced(const RealBall& x, long bits) {
  const RealBall turn = multiply(RealBall(2, bits), pi(bits), bits);
  const Integer whole = floor(divide(x, turn, bits).midpoint() + Rational(1, 2));
  return subtract(x, multiply(RealBall(Rational(whole), bits), turn, bits), bits);
}

}  // namespace phrame
