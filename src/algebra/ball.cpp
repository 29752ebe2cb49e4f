#include "phrame/algebra/ball.hpp"

#include <memory>
#include <ostream>

#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {
namespace {

Rational exact_value(const arf_t x) { return result_of<Rational>(arf_get_fmpq, x); }

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

Rational RealBall::radius() const { return result_of<Rational>(mag_get_fmpq, arb_radref(raw())); }

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

RealBall absolute(const RealBall& a) { return result_of<RealBall>(arb_abs, a.raw()); }

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
  return result_of<RealBall>(arb_union, a.raw(), b.raw(), bits);
}

RealBall add(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_add, a.raw(), b.raw(), bits);
}

RealBall subtract(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_sub, a.raw(), b.raw(), bits);
}

RealBall multiply(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_mul, a.raw(), b.raw(), bits);
}

RealBall divide(const RealBall& a, const RealBall& b, long bits) {
  return result_of<RealBall>(arb_div, a.raw(), b.raw(), bits);
}

RealBall add_product(RealBall sum, const RealBall& a, const RealBall& b, long bits) {
  arb_addmul(sum.raw(), a.raw(), b.raw(), bits);
  return sum;
}

RealBall sqrt(const RealBall& a, long bits) { return result_of<RealBall>(arb_sqrt, a.raw(), bits); }

RealBall pow(const RealBall& a, long k, long bits) {
  return result_of<RealBall>(arb_pow_ui, a.raw(), static_cast<ulong>(k), bits);
}

RealBall sqrt_of_nonnegative(const RealBall& a, long bits) {
  return result_of<RealBall>(arb_sqrtpos, a.raw(), bits);
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
  return result_of<RealBall>(arb_atan2, RealBall(y, bits).raw(), RealBall(x, bits).raw(), bits);
}

RealBall pi(long bits) { return result_of<RealBall>(arb_const_pi, bits); }

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

ComplexBall ComplexBall::midpoint() const { return result_of<ComplexBall>(acb_get_mid, raw()); }

RealBall ComplexBall::re() const { return result_of<RealBall>(acb_get_real, raw()); }

RealBall ComplexBall::im() const { return result_of<RealBall>(acb_get_imag, raw()); }

ComplexBall conjugate(const ComplexBall& z) { return result_of<ComplexBall>(acb_conj, z.raw()); }

RealBall absolute(const ComplexBall& z, long bits) {
  return result_of<RealBall>(acb_abs, z.raw(), bits);
}

ComplexBall add(const ComplexBall& a, const ComplexBall& b, long bits) {
  return result_of<ComplexBall>(acb_add, a.raw(), b.raw(), bits);
}

ComplexBall subtract(const ComplexBall& a, const ComplexBall& b, long bits) {
  return result_of<ComplexBall>(acb_sub, a.raw(), b.raw(), bits);
}

ComplexBall multiply(const ComplexBall& a, const ComplexBall& b, long bits) {
  return result_of<ComplexBall>(acb_mul, a.raw(), b.raw(), bits);
}

ComplexBall multiply(const RealBall& a, const ComplexBall& b, long bits) {
  return result_of<ComplexBall>(acb_mul_arb, b.raw(), a.raw(), bits);
}

RealBall argument(const ComplexBall& z, long bits) {
  return result_of<RealBall>(acb_arg, z.raw(), bits);
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
  return result_of<ComplexBall>(acb_div, a.raw(), b.raw(), bits);
}

ComplexBall inverse(const ComplexBall& b, long bits) {
  return result_of<ComplexBall>(acb_inv, b.raw(), bits);
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
