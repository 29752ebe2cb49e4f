#include "phrame/algebra/increasing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"

// By the mean value theorem F(m) − F(t) = (m − t)·w with w ∈ F′(T) for m, t ∈ T, so that the step
// N = m − (F(m) − y)/F′(T) holds every t ∈ T with F(t) = y. If N lies in the interior of T there is
// one: F′(T) does not contain 0, and F − y has different signs at the ends of T. A slope that is
// positive on T makes F increasing on [0, 1] ∪ T, so the t found is the one looked for.

namespace phrame::inline v0 {
namespace {

/// The points of a ball that are in [0, 1]. A ball has a rounded radius, so that it may be wider,
/// and beyond [0, 1] F need not increase, nor even be defined.
struct Bounds {
  flint::Arf low;
  flint::Arf high;
};

Bounds bounds(const RealBall& x, long bits) {
  Bounds b;
  arb_get_lbound_arf(b.low.get(), x.raw(), bits);
  arb_get_ubound_arf(b.high.get(), x.raw(), bits);
  if (arf_sgn(b.low.get()) < 0) arf_zero(b.low.get());
  if (arf_cmp_si(b.high.get(), 1) > 0) arf_one(b.high.get());
  return b;
}

/// The point low + (high − low)·eighths/8, without a radius.
RealBall point_between(const Bounds& b, long eighths) {
  RealBall m;
  arf_sub(arb_midref(m.raw()), b.high.get(), b.low.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_mul_si(arb_midref(m.raw()), arb_midref(m.raw()), eighths, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_mul_2exp_si(arb_midref(m.raw()), arb_midref(m.raw()), -3);
  arf_add(arb_midref(m.raw()), arb_midref(m.raw()), b.low.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  return m;
}

/// The point of [0, 1] that is nearest to the middle of x.
RealBall point_near(const RealBall& x) {
  RealBall m;
  arb_get_mid_arb(m.raw(), x.raw());
  arb_set_round(m.raw(), m.raw(), 64);
  arb_get_mid_arb(m.raw(), m.raw());
  if (arb_is_negative(m.raw()) != 0) arb_zero(m.raw());
  if (arf_cmp_si(arb_midref(m.raw()), 1) > 0) arb_one(m.raw());
  return m;
}

/// m − (F(m) − y)/F′(around); not finite where F′ may be 0 or negative there.
RealBall newton_step(const IncreasingFunction& F, const Rational& y, const RealBall& m,
                     const RealBall& around, long bits) {
  const RealBall slope = F.slope(around, bits);
  RealBall step;
  arb_indeterminate(step.raw());
  if (arb_is_positive(slope.raw()) == 0) return step;
  step = divide(subtract(F.value(m, bits), RealBall(y, bits), bits), slope, bits);
  return subtract(m, step, bits);
}

/// The part of x on the side of m, an exact point of x, where F = y; no value where the sign of
/// F(m) − y is not seen.
std::optional<RealBall> cut_at(const IncreasingFunction& F, const Rational& y, const Bounds& x,
                               const RealBall& m, long bits) {
  const RealBall value = subtract(F.value(m, bits), RealBall(y, bits), bits);
  if (!value.is_finite() || value.contains_zero()) return std::nullopt;
  RealBall part;
  if (arb_is_positive(value.raw()) != 0)
    arb_set_interval_arf(part.raw(), x.low.get(), arb_midref(m.raw()), bits);
  else
    arb_set_interval_arf(part.raw(), arb_midref(m.raw()), x.high.get(), bits);
  return part;
}

/// Cut at the middle or, should that be the very t with F(t) = y, beside it.
std::optional<RealBall> bisected(const IncreasingFunction& F, const Rational& y, const RealBall& x,
                                 long bits) {
  const Bounds b = bounds(x, bits);
  if (auto half = cut_at(F, y, b, point_between(b, 4), bits)) return half;
  return cut_at(F, y, b, point_between(b, 5), bits);
}

bool is_wider(const RealBall& x, const RealBall& y, long factor_bits) {
  flint::Mag scaled;
  mag_mul_2exp_si(scaled.get(), arb_radref(y.raw()), factor_bits);
  return mag_cmp(arb_radref(x.raw()), scaled.get()) > 0;
}

}  // namespace

RealBall enclose_preimage(const IncreasingFunction& F, const Rational& y, double guess) {
  constexpr long bits = 96;
  constexpr long radius_bits = 30;  // wide enough for a guess, narrow enough for a steady slope
  RealBall start;
  arb_set_d(start.raw(), guess);
  RealBall point = point_near(start);
  for (int attempt = 0; attempt < 8; ++attempt) {
    RealBall around = point;
    arb_add_error_2exp_si(around.raw(), -radius_bits);
    const RealBall next = newton_step(F, y, point, around, bits);
    if (!next.is_finite()) break;
    if (arb_contains_interior(around.raw(), next.raw()) != 0) return next;
    point = point_near(next);
  }
  RealBall unit(Rational(1, 2), bits);
  arb_add_error_2exp_si(unit.raw(), -1);
  return unit;
}

double guess_preimage(const IncreasingFunction& F, const Rational& y, double start) {
  constexpr long bits = 64;
  double low = 0;
  double high = 1;
  double t = start;
  for (int step = 0; step < 60 && high - low > 0x1p-50; ++step) {
    const RealBall at = exact_sum(t, 0);
    const RealBall excess = subtract(F.value(at, bits), RealBall(y, bits), bits);
    (sign(excess) > 0 ? high : low) = t;
    const double next = t - approximate(divide(excess, F.slope(at, bits), bits));
    if (next == t) break;
    t = next > low && next < high ? next : (low + high) / 2;
  }
  return t;
}

RealBall narrow_preimage(const IncreasingFunction& F, const Rational& y, RealBall around,
                         long bits) {
  const long end = 64 * bits + 65536;
  long guard = 32;
  while (mag_cmp_2exp_si(arb_radref(around.raw()), -bits) > 0) {
    const auto reached = static_cast<long>(-mag_get_d_log2_approx(arb_radref(around.raw())));
    const long precision = std::min(2 * std::max(reached, 16L), bits) + guard;
    RealBall next =
        newton_step(F, y, point_between(bounds(around, precision), 4), around, precision);
    if (next.is_finite() &&
        arb_intersection(next.raw(), next.raw(), around.raw(), precision) != 0 &&
        is_wider(around, next, 2)) {
      around = std::move(next);
      continue;
    }
    auto part = bisected(F, y, around, precision);
    if (part && is_wider(around, *part, 0)) {
      around = std::move(*part);
      continue;
    }
    guard *= 2;
    if (precision > end)
      throw Undecided(fmt::format(
          "inverse of an increasing function: {} bits of precision do not give {} bits of it", end,
          bits));
  }
  return around;
}

Real preimage(std::shared_ptr<const IncreasingFunction> F, const Rational& y, double guess) {
  const auto narrowest = std::make_shared<RealBall>(enclose_preimage(*F, y, guess));
  return Real([F = std::move(F), y, narrowest](long bits) {
    return *narrowest = narrow_preimage(*F, y, *narrowest, bits);
  });
}

Real zero_between(const Rational& lower, const Rational& upper, const IncreasingFunction& F) {
  const Rational width = upper - lower;
  const auto place = [lower, width](const RealBall& u, long bits) {
    return add_product(RealBall(lower, bits), RealBall(width, bits), u, bits);
  };
  const auto of_u = std::make_shared<const IncreasingFunction>(IncreasingFunction{
      [value = F.value, place](const RealBall& u, long bits) {
        return value(place(u, bits), bits);
      },
      [slope = F.slope, place, width](const RealBall& u, long bits) {
        return multiply(RealBall(width, bits), slope(place(u, bits), bits), bits);
      }});
  return cached(Real(lower) + Real(width) * preimage(of_u, 0, guess_preimage(*of_u, 0)));
}

Real recognized(const Real& t, const std::function<bool(const Rational&)>& is_t) {
  const RealBall around = t.enclose(72);
  const Rational r = simplest_between(around.lower(), around.upper());
  return denominator(r) >> 32 == 0 && r >= 0 && r <= 1 && is_t(r) ? Real(r) : t;
}

}  // namespace phrame
