#include "phrame/algebra/ball.hpp"

#include <memory>
#include <ostream>

namespace phrame::inline v0 {
namespace {

Rational exact_value(const arf_t x) {
  Rational value;
  arf_get_fmpq(value.raw(), x);
  return value;
}

}  // namespace

RealBall::RealBall(const Rational& x, long bits) { arb_set_fmpq(raw(), x.raw(), bits); }

RealBall RealBall::unknown() {
  RealBall x;
  arb_indeterminate(x.raw());
  return x;
}

Rational RealBall::lower() const { return midpoint() - radius(); }

Rational RealBall::upper() const { return midpoint() + radius(); }

Rational RealBall::midpoint() const { return exact_value(arb_midref(raw())); }

Rational RealBall::radius() const {
  Rational value;
  mag_get_fmpq(value.raw(), arb_radref(raw()));
  return value;
}

bool RealBall::contains(const Rational& x) const { return arb_contains_fmpq(raw(), x.raw()) != 0; }

bool RealBall::is_accurate(long bits) const {
  flint::Mag allowed;
  arb_get_mag_lower(allowed.get(), raw());
  if (mag_cmp_2exp_si(allowed.get(), 0) < 0) mag_one(allowed.get());
  mag_mul_2exp_si(allowed.get(), allowed.get(), -bits);
  return is_finite() && mag_cmp(arb_radref(raw()), allowed.get()) <= 0;
}

int sign(const RealBall& a) {
  return arb_is_positive(a.raw()) != 0 ? 1 : arb_is_negative(a.raw()) != 0 ? -1 : 0;
}

RealBall absolute(const RealBall& a) {
  RealBall size;
  arb_abs(size.raw(), a.raw());
  return size;
}

double approximate(const RealBall& a) { return arf_get_d(arb_midref(a.raw()), ARF_RND_NEAR); }

double upper_double(const RealBall& a) {
  flint::Arb upper;
  arb_get_ubound_arf(arb_midref(upper.get()), a.raw(), 64);
  return arf_get_d(arb_midref(upper.get()), ARF_RND_CEIL);
}

RealBall hull(const Rational& a, const Rational& b, long bits) {
  return hull(RealBall(a, bits), RealBall(b, bits), bits);
}

RealBall hull(const RealBall& a, const RealBall& b, long bits) {
  RealBall c;
  arb_union(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

RealBall add(const RealBall& a, const RealBall& b, long bits) {
  RealBall c;
  arb_add(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

RealBall subtract(const RealBall& a, const RealBall& b, long bits) {
  RealBall c;
  arb_sub(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

RealBall multiply(const RealBall& a, const RealBall& b, long bits) {
  RealBall c;
  arb_mul(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

RealBall divide(const RealBall& a, const RealBall& b, long bits) {
  RealBall c;
  arb_div(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

RealBall add_product(RealBall sum, const RealBall& a, const RealBall& b, long bits) {
  arb_addmul(sum.raw(), a.raw(), b.raw(), bits);
  return sum;
}

RealBall sqrt(const RealBall& a, long bits) {
  RealBall c;
  arb_sqrt(c.raw(), a.raw(), bits);
  return c;
}

RealBall pow(const RealBall& a, long k, long bits) {
  RealBall c;
  arb_pow_ui(c.raw(), a.raw(), static_cast<ulong>(k), bits);
  return c;
}

RealBall sqrt_of_nonnegative(const RealBall& a, long bits) {
  RealBall c;
  arb_sqrtpos(c.raw(), a.raw(), bits);
  return c;
}

RealBall times_power_of_two(RealBall a, long k) {
  arb_mul_2exp_si(a.raw(), a.raw(), k);
  return a;
}

RealBall exact_sum(double a, double b) {
  RealBall sum;
  flint::Arf other;
  arf_set_d(arb_midref(sum.raw()), a);
  arf_set_d(other.get(), b);
  arb_add_arf(sum.raw(), sum.raw(), other.get(), ARF_PREC_EXACT);
  return sum;
}

RealBall widened(RealBall a, const RealBall& by) {
  arb_add_error(a.raw(), by.raw());
  return a;
}

RealBall widened(RealBall a, double by) {
  flint::Mag radius;
  mag_set_d(radius.get(), by);
  arb_add_error_mag(a.raw(), radius.get());
  return a;
}

RealBall argument(const Rational& x, const Rational& y, long bits) {
  RealBall angle;
  arb_atan2(angle.raw(), RealBall(y, bits).raw(), RealBall(x, bits).raw(), bits);
  return angle;
}

RealBall pi(long bits) {
  RealBall c;
  arb_const_pi(c.raw(), bits);
  return c;
}

CosSin cos_sin(const RealBall& angle, long bits) {
  CosSin result;
  arb_sin_cos(result.sin.raw(), result.cos.raw(), angle.raw(), bits);
  return result;
}

ComplexBall::ComplexBall(const RealBall& re, const RealBall& im) {
  acb_set_arb_arb(raw(), re.raw(), im.raw());
}

ComplexBall ComplexBall::unknown() {
  ComplexBall z;
  acb_indeterminate(z.raw());
  return z;
}

ComplexBall ComplexBall::midpoint() const {
  ComplexBall middle;
  acb_get_mid(middle.raw(), raw());
  return middle;
}

RealBall ComplexBall::re() const {
  RealBall part;
  acb_get_real(part.raw(), raw());
  return part;
}

RealBall ComplexBall::im() const {
  RealBall part;
  acb_get_imag(part.raw(), raw());
  return part;
}

ComplexBall conjugate(const ComplexBall& z) {
  ComplexBall c;
  acb_conj(c.raw(), z.raw());
  return c;
}

RealBall absolute(const ComplexBall& z, long bits) {
  RealBall size;
  acb_abs(size.raw(), z.raw(), bits);
  return size;
}

ComplexBall add(const ComplexBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_add(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

ComplexBall subtract(const ComplexBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_sub(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

ComplexBall multiply(const ComplexBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_mul(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

ComplexBall multiply(const RealBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_mul_arb(c.raw(), b.raw(), a.raw(), bits);
  return c;
}

RealBall argument(const ComplexBall& z, long bits) {
  RealBall angle;
  acb_arg(angle.raw(), z.raw(), bits);
  return angle;
}

RealBall argument_about_pi(const ComplexBall& z, long bits) {
  ComplexBall opposite;
  acb_neg(opposite.raw(), z.raw());
  return add(pi(bits), argument(opposite, bits), bits);
}

ComplexBall evaluate(const Polynomial& p, const ComplexBall& z, long bits) {
  flint::FmpzPoly numerator;
  fmpq_poly_get_numerator(numerator.get(), p.raw());
  ComplexBall value;
  arb_fmpz_poly_evaluate_acb(value.raw(), numerator.get(), z.raw(), bits);
  acb_div_fmpz(value.raw(), value.raw(), fmpq_poly_denref(p.raw()), bits);
  return value;
}

RealBall evaluate(const Polynomial& p, const RealBall& x, long bits) {
  flint::FmpzPoly numerator;
  fmpq_poly_get_numerator(numerator.get(), p.raw());
  RealBall value;
  arb_fmpz_poly_evaluate_arb(value.raw(), numerator.get(), x.raw(), bits);
  arb_div_fmpz(value.raw(), value.raw(), fmpq_poly_denref(p.raw()), bits);
  return value;
}

RealBall evaluate(const RationalFunction& f, const RealBall& x, long bits) {
  return divide(evaluate(f.numerator(), x, bits), evaluate(f.denominator(), x, bits), bits);
}

ComplexBall divide(const ComplexBall& a, const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_div(c.raw(), a.raw(), b.raw(), bits);
  return c;
}

ComplexBall inverse(const ComplexBall& b, long bits) {
  ComplexBall c;
  acb_inv(c.raw(), b.raw(), bits);
  return c;
}

std::string to_string(const RealBall& a, long digits) {
  if (a.contains_zero()) return "0";
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(a.raw(), digits, ARB_STR_NO_RADIUS),
                                                    flint_free);
  return text.get();
}

std::ostream& operator<<(std::ostream& out, const RealBall& a) {
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(a.raw(), 15, 0), flint_free);
  return out << text.get();
}

std::ostream& operator<<(std::ostream& out, const ComplexBall& z) {
  return out << z.re() << " + " << z.im() << "*i";
}

}  // namespace phrame
