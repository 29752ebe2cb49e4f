// Horner's rule gives wide enclosures on large discs: there p is taken from its Taylor polynomial
// at the middle, |p(m + δ) − p(m)| ≤ Σ |cₖ|·|δ|ᵏ, which is nearly the best.
#include "phrame/algebra/disc_evaluation.hpp"

namespace phrame::inline v0 {
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

bool is_point(const ComplexBall& z, long precision) { return z.accuracy_bits() > precision / 2; }

ComplexBall evaluate(const BallPolynomial& p, const ComplexBall& z, long bits) {
  if (is_point(z, bits)) return value_at_point(p, z, bits);
  const ComplexBall middle = z.midpoint();
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
    const BallPolynomial taylor = shifted(p_, at, bits);
    known.sizes.resize(static_cast<std::size_t>(taylor.degree_bound() + 1));
    for (std::size_t k = 1; k < known.sizes.size(); ++k)
      arb_get_mag(known.sizes[k].get(),
                  arb_poly_get_coeff_ptr(taylor.raw(), static_cast<slong>(k)));
    known.value = taylor.coefficient(0);
    known.bits = bits;
  }
  return widened(ComplexBall(known.value, RealBall()), variation(known.sizes, radius_of(z)));
}

}  // namespace phrame
