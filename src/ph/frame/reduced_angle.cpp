#include "phrame/ph/frame/reduced_angle.hpp"

#include <fmt/format.h>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// The whole k with x ∈ (2k − 1, 2k + 1].
Integer nearest_turns(const Rational& x) { return -floor((1 - x) / 2); }

/// The same, if it is the same for the whole ball.
std::optional<Integer> whole_turns(const RealBall& x, long bits) {
  const RealBall shifted = divide(add(x, RealBall(-1, bits), bits), RealBall(2, bits), bits);
  return unique_ceiling(shifted, bits);
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

Real whole_turn(const Integer& k) {
  const auto enclosure = [k](long bits) {
    return multiply(RealBall(Rational(2 * k), bits + 8), pi(bits + 8), bits + 8);
  };
  return {enclosure, {k != 0, bits_of(Rational(k))}};
}

ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi) {
  // Few bits nearly always tell it from a multiple of π.
  constexpr long most_bits = 32768;
  bool was_asked = false;
  for (long bits = 80;; bits = bits == 80 ? 512 : 4 * bits) {
    const RealBall y = divide(x.enclose(bits), pi(bits), bits);
    const bool is_near = contains_integer(y);
    if (is_near && bits > 80 && !was_asked && unique_integer(y)) {
      was_asked = true;
      const auto known = over_pi();
      if (known && denominator(*known) == 1) {
        const Integer n(numerator(*known));
        if (n % 2 == 0) return {Rational(0), n / 2};
        return {Real([](long precision) { return pi(precision); }, {true, 0}), (n - 1) / 2};
      }
    }
    if (!is_near || was_asked)
      if (const auto turns = whole_turns(y, bits))
        return {*turns == 0 ? x : x + whole_turn(-*turns), *turns};
    if (bits > most_bits)
      throw Undecided(fmt::format(
          "{} bits of precision do not tell an angle from an odd multiple of pi", bits));
  }
}

RealBall reduced(const RealBall& x, long bits) {
  const RealBall turn = multiply(RealBall(2, bits), pi(bits), bits);
  const Integer whole = floor(divide(x, turn, bits).midpoint() + Rational(1, 2));
  return subtract(x, multiply(RealBall(Rational(whole), bits), turn, bits), bits);
}

}  // namespace phrame
