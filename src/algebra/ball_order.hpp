#pragma once
#include <optional>

#include "phrame/algebra/ball.hpp"

namespace phrame::inline v0 {

// What is certain of all numbers in balls: their order, their size and the integers among them.
// Where it is not, as where a ball is not finite, the answer is false, or no value.

/// Is x < y, or x ≤ y, for all x ∈ a, y ∈ b?
bool is_less(const RealBall& a, const RealBall& b);
bool is_at_most(const RealBall& a, const RealBall& b);

/// The greater and the lesser of the two numbers.
RealBall max(const RealBall& a, const RealBall& b, long bits);
RealBall min(const RealBall& a, const RealBall& b, long bits);

/// No number of the ball is less: an exact number next to the least one, or −∞.
RealBall lower_end(const RealBall& a, long bits);
/// No |x| is less: an exact number next to the least one.
RealBall least_size(const RealBall& a, long bits);
/// The radius, exactly.
RealBall radius_of(const RealBall& a);

/// Beyond every exponent of a number ≠ 0 that is computed.
inline constexpr long unbounded_exponent = 1L << 60;
/// An e with |x| < 2^e for all x of the ball; −unbounded_exponent for 0, unbounded_exponent where
/// there is none.
long exponent_above(const RealBall& a);
/// An e with |x| ≥ 2^e for all x of the ball; −unbounded_exponent where 0 is one.
long exponent_below(const RealBall& a);

bool contains_integer(const RealBall& a);
/// The integer in the ball, where it has one and no more.
std::optional<Integer> unique_integer(const RealBall& a);
/// ⌈x⌉, where it is the same for all x of the ball.
std::optional<Integer> unique_ceiling(const RealBall& a, long bits);

}  // namespace phrame
