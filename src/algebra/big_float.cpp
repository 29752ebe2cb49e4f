#include "phrame/algebra/big_float.hpp"

#include <algorithm>

namespace phrame::inline v0 {

BigFloat::BigFloat(const Rational& x, long bits) : bits_(bits) {
  arf_set_fmpq(raw(), x.raw(), bits, ARF_RND_NEAR);
}

BigFloat::BigFloat(const RealBall& x, long bits) : bits_(bits) {
  arf_set_round(raw(), arb_midref(x.raw()), bits, ARF_RND_NEAR);
}

Integer BigFloat::scaled(long k) const {
  BigFloat y;
  Integer whole;
  arf_mul_2exp_si(y.raw(), raw(), k);
  arf_get_fmpz(whole.raw(), y.raw(), ARF_RND_NEAR);
  return whole;
}

BigFloat operator+(const BigFloat& a, const BigFloat& b) {
  BigFloat c;
  c.bits_ = std::max(a.bits_, b.bits_);
  arf_add(c.raw(), a.raw(), b.raw(), c.bits_, ARF_RND_NEAR);
  return c;
}

BigFloat operator-(const BigFloat& a, const BigFloat& b) {
  BigFloat c;
  c.bits_ = std::max(a.bits_, b.bits_);
  arf_sub(c.raw(), a.raw(), b.raw(), c.bits_, ARF_RND_NEAR);
  return c;
}

BigFloat operator-(const BigFloat& a) {
  BigFloat c;
  c.bits_ = a.bits_;
  arf_neg(c.raw(), a.raw());
  return c;
}

BigFloat operator*(const BigFloat& a, const BigFloat& b) {
  BigFloat c;
  c.bits_ = std::max(a.bits_, b.bits_);
  arf_mul(c.raw(), a.raw(), b.raw(), c.bits_, ARF_RND_NEAR);
  return c;
}

BigFloat operator/(const BigFloat& a, const BigFloat& b) {
  BigFloat c;
  c.bits_ = std::max(a.bits_, b.bits_);
  arf_div(c.raw(), a.raw(), b.raw(), c.bits_, ARF_RND_NEAR);
  return c;
}

BigFloat sqrt(const BigFloat& a) {
  BigFloat c;
  c.bits_ = a.bits_;
  arf_sqrt(c.raw(), a.raw(), c.bits_, ARF_RND_NEAR);
  return c;
}

}  // namespace phrame
