#include "phrame/algebra/ball_order.hpp"

#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {

bool is_less(const RealBall& a, const RealBall& b) { return arb_lt(a.raw(), b.raw()) != 0; }

bool is_at_most(const RealBall& a, const RealBall& b) { return arb_le(a.raw(), b.raw()) != 0; }

RealBall max(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_max, a.raw(), b.raw(), bits);
}

RealBall min(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_min, a.raw(), b.raw(), bits);
}

RealBall lower_end(const RealBall& a, long bits) {
  RealBall end;
  arb_get_lbound_arf(arb_midref(end.raw()), a.raw(), bits);
  return end;
}

RealBall least_size(const RealBall& a, long bits) {
  RealBall size;
  arb_get_abs_lbound_arf(arb_midref(size.raw()), a.raw(), bits);
  return size;
}

RealBall radius_of(const RealBall& a) {
  RealBall radius;
  arf_set_mag(arb_midref(radius.raw()), arb_radref(a.raw()));
  return radius;
}

long exponent_above(const RealBall& a) {
  flint::Mag size;
  arb_get_mag(size.get(), a.raw());
  if (mag_is_inf(size.get()) != 0) return unbounded_exponent;
  return mag_is_zero(size.get()) != 0 ? -unbounded_exponent : fmpz_get_si(MAG_EXPREF(size.get()));
}

long exponent_below(const RealBall& a) {
  flint::Mag size;
  arb_get_mag_lower(size.get(), a.raw());
  return mag_is_zero(size.get()) != 0 ? -unbounded_exponent
                                      : fmpz_get_si(MAG_EXPREF(size.get())) - 1;
}

bool contains_integer(const RealBall& a) { return arb_contains_int(a.raw()) != 0; }

std::optional<Integer> unique_integer(const RealBall& a) {
  Integer whole;
  if (arb_get_unique_fmpz(whole.raw(), a.raw()) == 0) return std::nullopt;
  return whole;
}

std::optional<Integer> unique_ceiling(const RealBall& a, long bits) {
  RealBall ceiling;
  arb_ceil(ceiling.raw(), a.raw(), bits);
  return unique_integer(ceiling);
}

}  // namespace phrame
