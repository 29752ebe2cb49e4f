#include "phrame/ph/along/feedrate.hpp"

#include <fmt/format.h>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/invariants.hpp"

// |f|σ is a polynomial where f keeps its sign, and the signed curvature of a plane PH curve is
// rational: then V(t), V(κ(t)) and |f|σ/V are rational functions.

namespace phrame::inline v0 {
namespace {

[[noreturn]] void refuse_speed(const char* what, const std::string& place) {
  throw DomainError(fmt::format("feedrate: the speed {} at {}", what, place));
}

/// Is x ≤ end?
bool is_up_to(const RealAlgebraic& x, const Real& end) {
  if (end.exact()) return compare(x, *end.exact()) <= 0;
  for (long bits = 64; bits <= 4096; bits *= 2) {
    const RealBall a = enclose(x, bits);
    const RealBall b = end.enclose(bits);
    if (is_less(a, b)) return true;
    if (is_less(b, a)) return false;
  }
  throw Undecided("feedrate: a zero or pole of the speed is not told from the end of the path");
}

}  // namespace

void require_positive(const RationalFunction& speed, const Real& end,
                      const std::function<std::string(const RealAlgebraic&)>& place_of) {
  if (speed.is_zero()) throw DomainError("feedrate: the speed is 0");
  const Rational beyond = end.exact() ? *end.exact() : end.enclose(64).upper();
  const auto require_no_zero = [&](const Polynomial& p, const char* what) {
    if (p.is_constant()) return;
    for (const RealRoot& root : real_roots(p, closed_interval(0, beyond)))
      if (is_up_to(root.at, end)) refuse_speed(what, place_of(root.at));
  };
  require_no_zero(speed.numerator(), "is 0");
  require_no_zero(speed.denominator(), "is infinite");
  if (speed(0) < 0)
    throw DomainError(
        fmt::format("feedrate: the speed is negative, {}{}", as_written(speed(0)),
                    constant(speed) ? "" : " at " + place_of(RealAlgebraic(Rational(0)))));
}

void require_positive_along(const RationalFunction& speed, const Rational& start) {
  require_positive(speed, Rational(1),
                   [&](const RealAlgebraic& t) { return place_text("t", affine(t, 1, start)); });
}

Rational speed_without_curvature(const RationalFunction& speed) {
  if (speed.denominator()(0) == 0)
    throw DomainError("feedrate: it divides by zero all along a straight line");
  const Rational V = speed(0);
  require_positive(RationalFunction(Polynomial{V}), Rational(0), {});
  return V;
}

RationalFunction speed_along(const Curve& curve, const Feedrate& feedrate, const Rational& start) {
  if (feedrate.of != Feedrate::Of::curvature) return compose(feedrate.speed, Polynomial{start, 1});
  const RationalFunction kappa = signed_curvature(curve);
  if (kappa.is_zero()) return RationalFunction(Polynomial{speed_without_curvature(feedrate.speed)});
  if (const auto c = constant(kappa); c && feedrate.speed.denominator()(*c) == 0)
    throw DomainError("feedrate: it divides by zero all along the curve");
  return compose(feedrate.speed, kappa);
}

RationalFunction travel_time_rate(const Curve& curve, const Feedrate& feedrate,
                                  const Rational& start) {
  const RationalFunction speed = speed_along(curve, feedrate, start);
  require_positive_along(speed, start);
  const Polynomial path = differentiate(ArcLength(curve).polynomial());
  return {path * speed.denominator(), speed.numerator()};
}

}  // namespace phrame
