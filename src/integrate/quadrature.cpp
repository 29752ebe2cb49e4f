// acb_calc_integrate needs narrow enclosures of f on discs far from the path, to know how near it
// is analytic. Horner's rule gives wide ones: on a disc p is taken from its Taylor polynomial at
// the middle, |p(m + δ) − p(m)| ≤ Σ |cₖ|·|δ|ᵏ, which is nearly the best.
#include "phrame/integrate/quadrature.hpp"

namespace phrame {
namespace {

/// Is z as small as points are at this precision? A disc next to a pole is not, however small:
/// there Horner's rule gives a ball that is much larger than the distance to the pole squared.
bool is_point(const ComplexBall& z, long precision) {
  return acb_rel_accuracy_bits(z.raw()) > precision / 2;
}

struct Integrand {
  const AnalyticFunction& f;
};

int integrand(acb_ptr result, const acb_t t, void* function, slong, slong precision) {
  ComplexBall z;
  acb_set(z.raw(), t);
  acb_set(result, static_cast<const Integrand*>(function)->f(z, precision).raw());
  return 0;
}

RealBall integrate(const AnalyticFunction& f, const RealBall& a, const RealBall& b, long bits,
                   long precision, long most_points) {
  Integrand function{f};
  flint::Mag tolerance;
  mag_set_ui_2exp_si(tolerance.get(), 1, -bits);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = most_points;
  ComplexBall value;
  acb_calc_integrate(value.raw(), integrand, &function, ComplexBall(a, {}).raw(),
                     ComplexBall(b, {}).raw(), bits, tolerance.get(), options, precision);
  return value.re();
}

}  // namespace

namespace {

/// The greatest |z − middle|.
flint::Mag radius_of(const ComplexBall& z) {
  flint::Mag radius;
  mag_hypot(radius.get(), arb_radref(acb_realref(z.raw())), arb_radref(acb_imagref(z.raw())));
  return radius;
}

/// Σ |cₖ|·radiusᵏ, k > 0.
flint::Mag variation(const std::vector<flint::Mag>& sizes, const flint::Mag& radius) {
  flint::Mag sum;
  for (std::size_t k = sizes.size(); k-- > 1;) {
    mag_add(sum.get(), sum.get(), sizes[k].get());
    mag_mul(sum.get(), sum.get(), radius.get());
  }
  return sum;
}

ComplexBall widened(ComplexBall value, const flint::Mag& by) {
  arb_add_error_mag(acb_realref(value.raw()), by.get());
  arb_add_error_mag(acb_imagref(value.raw()), by.get());
  return value;
}

ComplexBall value_at_point(const BallPolynomial& p, const ComplexBall& z, long bits) {
  ComplexBall value;
  if (arb_is_zero(acb_imagref(z.raw())) != 0) {  // as nodes are
    arb_poly_evaluate(acb_realref(value.raw()), p.raw(), acb_realref(z.raw()), bits);
    return value;
  }
  arb_poly_evaluate_acb(value.raw(), p.raw(), z.raw(), bits);
  return value;
}

}  // namespace

ComplexBall evaluate(const BallPolynomial& p, const ComplexBall& z, long bits) {
  if (is_point(z, bits)) return value_at_point(p, z, bits);
  ComplexBall middle;
  acb_get_mid(middle.raw(), z.raw());
  flint::AcbPoly taylor;
  acb_poly_set_arb_poly(taylor.get(), p.raw());
  acb_poly_taylor_shift(taylor.get(), taylor.get(), middle.raw(), bits);
  std::vector<flint::Mag> sizes(static_cast<std::size_t>(acb_poly_length(taylor.get())));
  for (std::size_t k = 1; k < sizes.size(); ++k)
    acb_get_mag(sizes[k].get(), acb_poly_get_coeff_ptr(taylor.get(), static_cast<slong>(k)));
  ComplexBall value;
  acb_poly_get_coeff_acb(value.raw(), taylor.get(), 0);
  return widened(std::move(value), variation(sizes, radius_of(z)));
}

ComplexBall IntegrandPolynomial::operator()(const ComplexBall& z, long bits) const {
  if (is_point(z, bits)) return value_at_point(p_, z, bits);
  const arf_srcptr middle = arb_midref(acb_realref(z.raw()));
  const double key = arf_get_d(middle, ARF_RND_NEAR);
  const bool is_key = arf_cmp_d(middle, key) == 0;
  if (!is_key || arf_is_zero(arb_midref(acb_imagref(z.raw()))) == 0) return evaluate(p_, z, bits);
  Taylor& known = at_[key];
  if (known.bits < bits) {
    RealBall at;
    arb_set_arf(at.raw(), middle);
    flint::ArbPoly taylor;
    arb_poly_taylor_shift(taylor.get(), p_.raw(), at.raw(), bits);
    known.sizes.resize(static_cast<std::size_t>(arb_poly_length(taylor.get())));
    for (std::size_t k = 1; k < known.sizes.size(); ++k)
      arb_get_mag(known.sizes[k].get(),
                  arb_poly_get_coeff_ptr(taylor.get(), static_cast<slong>(k)));
    arb_poly_get_coeff_arb(known.value.raw(), taylor.get(), 0);
    known.bits = bits;
  }
  return widened(ComplexBall(known.value, RealBall()), variation(known.sizes, radius_of(z)));
}

namespace {

/// Is d = p(z) so inexact because more precision is needed, and not because z is a large ball?
bool lacks_precision(const IntegrandPolynomial& p, const ComplexBall& z, const ComplexBall& d,
                     long bits, long precision) {
  if (is_point(z, precision)) return acb_rel_accuracy_bits(d.raw()) < bits;
  constexpr long few = 16;
  if (acb_rel_accuracy_bits(d.raw()) >= few) return false;
  ComplexBall middle;
  acb_get_mid(middle.raw(), z.raw());
  return acb_rel_accuracy_bits(p(middle, precision).raw()) < few;
}

}  // namespace

// Next to a pole the denominator is small, so that it loses its digits, and the points those of
// their distance to the pole. Once that is seen, the values that are still asked for are infinite,
// which costs little, and all begins anew.
RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b, long bits,
                    long most_points) {
  constexpr long most_precision = 1 << 14;
  for (long more = 64;; more *= 4) {
    const slong precision = bits + more;
    const IntegrandPolynomial numerator(BallPolynomial(f.numerator(), precision));
    const IntegrandPolynomial denominator(BallPolynomial(f.denominator(), precision));
    bool is_imprecise = false;
    const auto quotient = [&](const ComplexBall& z, long working) {
      ComplexBall value;
      acb_indeterminate(value.raw());
      if (is_imprecise) return value;
      --most_points;
      const ComplexBall d = denominator(z, working);
      is_imprecise = lacks_precision(denominator, z, d, bits, working);
      return is_imprecise ? value : divide(numerator(z, working), d, working);
    };
    RealBall value = integrate(quotient, RealBall(a, precision), RealBall(b, precision), bits,
                               precision, most_points);
    if (!is_imprecise || most_points <= 0 || more >= most_precision) return value;
  }
}

RealBall quadrature(const AnalyticFunction& f, long bits, long more, long most_points) {
  const slong precision = bits + 64 + more;
  return integrate(f, RealBall(0, precision), RealBall(1, precision), bits, precision, most_points);
}

}  // namespace phrame
