#include "phrame/ph/reduced_angle.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// The whole k with x ∈ (2k − 1, 2k + 1], if it is the same for the whole ball.
std::optional<Integer> whole_turns(const RealBall& x, long bits) {
  const RealBall shifted = divide(add(x, RealBall(-1, bits), bits), RealBall(2, bits), bits);
  RealBall ceiling;
  arb_ceil(ceiling.raw(), shifted.raw(), bits);
  flint::Fmpz k;
  if (arb_get_unique_fmpz(k.get(), ceiling.raw()) == 0) return std::nullopt;
  return Integer(k.get());
}

}  // namespace

Real whole_turn(const Integer& k) {
  const auto enclosure = [k](long bits) {
    return multiply(RealBall(Rational(2 * k), bits + 8), pi(bits + 8), bits + 8);
  };
  return {enclosure, {k != 0, bits_of(Rational(k))}};
}

ReducedAngle reduced(const Real& x, const std::function<std::optional<Rational>()>& over_pi) {
  // Few bits nearly always tell it from a multiple of π.
  long bits = 80;
  RealBall y = divide(x.enclose(bits), pi(bits), bits);
  flint::Fmpz nearest;
  if (arb_contains_int(y.raw()) != 0) {
    bits = 512;
    y = divide(x.enclose(bits), pi(bits), bits);
  }
  if (arb_get_unique_fmpz(nearest.get(), y.raw()) != 0) {
    const auto known = over_pi();
    if (known && denominator(*known) == 1) {
      const Integer n(numerator(*known));
      if (n % 2 == 0) return {Rational(0), n / 2};
      return {Real([](long precision) { return pi(precision); }, {true, 0}), (n - 1) / 2};
    }
  }
  const auto turns = whole_turns(y, bits);
  if (!turns)
    throw Undecided(
        fmt::format("{} bits of precision do not tell an angle from an odd multiple of pi", bits));
  return {*turns == 0 ? x : x + whole_turn(-*turns), *turns};
}

}  // namespace phrame
