#include "phrame/ph/twist/frame_angle_error.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {
namespace {

RealBall greatest_angle(const RationalFunction& rate, long bits) {
  // At the end, or where e′ = 0. Between the middle of an interval around a zero of e′ and the zero
  // |e| changes by less than the greatest |e′| there times the width.
  RealBall most = absolute(quadrature(rate, 0, 1, bits + 8));
  for (const Interval& found : isolate_real_roots(rate.numerator(), open_interval(0, 1))) {
    const Interval zero = narrowed(rate.numerator(), found, power_of_two(-bits));
    const Rational middle = (*zero.lower + *zero.upper) / 2;
    const RealBall around = hull(*zero.lower, *zero.upper, 2 * bits);
    const RealBall change = multiply(RealBall(*zero.upper - *zero.lower, bits),
                                     absolute(evaluate(rate, around, 2 * bits)), bits);
    const RealBall there = absolute(quadrature(rate, 0, middle, bits + 8));
    most = max(most, widened(there, change), bits + 8);
  }
  return most;
}

}  // namespace

FrameAngleError frame_angle_error(const QuaternionPolynomial& preimage, const Polynomial& a,
                                  const Polynomial& b) {
  const Polynomial turn = a * differentiate(b) - differentiate(a) * b;
  const Polynomial twice_h = Rational(2) * twist_numerator(preimage);
  const RationalFunction rate = RationalFunction(twice_h, sigma(preimage)) -
                                RationalFunction(Rational(2) * turn, a * a + b * b);
  if (rate.is_zero()) return {Real(Rational(0)), Real(Rational(0))};
  return {Real([rate](long bits) { return greatest_angle(rate, bits); }),
          Real([rate](long bits) { return quadrature(rate, 0, 1, bits + 8); })};
}

}  // namespace phrame
