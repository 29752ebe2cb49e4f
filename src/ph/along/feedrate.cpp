#include "phrame/ph/along/feedrate.hpp"

#include <fmt/format.h>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/invariants.hpp"

// s(t) is a polynomial and so is |f|σ, and the signed curvature of a plane curve is rational: then
// V(s(t)), V(t) and V(κ(t)) are rational functions, and so is |f|σ/V.

namespace phrame {
namespace {

/// f(x(t)), where x(t) is what the speed depends on.
RationalFunction along(const RationalFunction& f, const RationalFunction& x) {
  if (const auto c = constant(x); c && f.denominator()(*c) == 0)
    throw DomainError("feedrate: it divides by zero all along the curve");
  return compose(f, x);
}

void require_none_on_curve(const Polynomial& p, const char* what, const SegmentStart& start) {
  if (count_real_roots(p, closed(0, 1)) == 0) return;
  const RealAlgebraic first = real_roots(p, closed(0, 1)).front().at;
  throw DomainError(fmt::format("feedrate: the speed {} at {}", what,
                                place("t", affine(first, 1, start.parameter))));
}

}  // namespace

RationalFunction speed_along(const Curve& curve, const Feedrate& feedrate,
                             const SegmentStart& start) {
  switch (feedrate.of) {
    case Feedrate::Of::arc_length:
      return along(feedrate.speed,
                   RationalFunction(ArcLength(curve).polynomial() + Polynomial{start.arc_length}));
    case Feedrate::Of::curvature:
      return along(feedrate.speed, signed_curvature(curve));
    case Feedrate::Of::parameter:
      break;
  }
  return compose(feedrate.speed, Polynomial{start.parameter, 1});
}

RationalFunction travel_time_rate(const Curve& curve, const Feedrate& feedrate,
                                  const SegmentStart& start) {
  const RationalFunction speed = speed_along(curve, feedrate, start);
  if (speed.is_zero()) throw DomainError("feedrate: the speed is 0");
  require_none_on_curve(speed.numerator(), "is 0", start);
  require_none_on_curve(speed.denominator(), "is infinite", start);
  if (speed(0) < 0)
    throw DomainError(fmt::format("feedrate: the speed is negative, {} at t = {}",
                                  as_written(speed(0)), to_string(start.parameter)));
  const Polynomial path = differentiate(ArcLength(curve).polynomial());
  return {path * speed.denominator(), speed.numerator()};
}

}  // namespace phrame
