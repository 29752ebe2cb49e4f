#pragma once
#include <functional>
#include <memory>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

/// A function F that is continuous and strictly increasing on [0, 1], by enclosures that become as
/// narrow as one asks. The slope may be 0 at points, and its enclosure on a wide ball may be any.
struct IncreasingFunction {
  /// A ball around F(t) for a point t of [0, 1], a ball without a radius.
  std::function<RealBall(const RealBall& t, long bits)> value;
  /// A ball that contains F′ on the ball t, which may reach beyond [0, 1]; or one that is not
  /// finite.
  std::function<RealBall(const RealBall& t, long bits)> slope;
};

/// A first ball around the t ∈ [0, 1] with F(t) = y: a narrow one, proved by Newton's method, where
/// the guess is a good one; else all of [0, 1]. Precondition: F(0) ≤ y ≤ F(1).
RealBall enclose_preimage(const IncreasingFunction& F, const Rational& y, double guess);

/// About that t, by Newton's steps in doubles between bounds, from `start` on; a guess.
double guess_preimage(const IncreasingFunction& F, const Rational& y, double start = 0.5);

/// Narrows a ball that contains the t with F(t) = y to a radius ≤ 2^−bits: interval Newton steps,
/// t ∈ m − (F(m) − y)/F′(T), and bisection where they do not help, as at a zero of F′.
/// Throws Undecided where 64·bits + 65536 bits of precision are not enough.
RealBall narrow_preimage(const IncreasingFunction& F, const Rational& y, RealBall around,
                         long bits);

/// The t ∈ [0, 1] with F(t) = y, from the two above. It keeps the narrowest ball it was asked for,
/// so that neither it nor a copy is for concurrent use.
Real preimage(std::shared_ptr<const IncreasingFunction> F, const Rational& y, double guess);

/// The x ∈ [lower, upper] with F(x) = 0 of an F that is increasing there and a function of x, not
/// of [0, 1]. Precondition: F(lower) ≤ 0 ≤ F(upper).
Real zero_between(const Rational& lower, const Rational& upper, const IncreasingFunction& F);

/// t ∈ [0, 1], exact where it is next to a fraction with a denominator of up to 32 bits for which
/// is_t() is true.
Real recognized(const Real& t, const std::function<bool(const Rational& r)>& is_t);

}  // namespace phrame
