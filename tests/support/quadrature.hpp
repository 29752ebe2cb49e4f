#pragma once
#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/rational_function.hpp"

namespace phrame::test {

/// ∫ₐᵇ f by Arb's certified quadrature: shares nothing with phrame's integrator.
inline RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b,
                           long bits) {
  const auto integrand = [](acb_ptr result, const acb_t t, void* parameter, slong,
                            slong precision) {
    const auto& g = *static_cast<const RationalFunction*>(parameter);
    ComplexBall z;
    acb_set(z.raw(), t);
    acb_set(result, divide(evaluate(g.numerator(), z, precision),
                           evaluate(g.denominator(), z, precision), precision)
                        .raw());
    return 0;
  };
  ComplexBall value;
  flint::Mag tolerance;
  mag_set_ui_2exp_si(tolerance.get(), 1, -bits);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = 100000;
  RationalFunction parameter = f;
  acb_calc_integrate(value.raw(), integrand, &parameter,
                     ComplexBall(RealBall(a, bits + 64), RealBall()).raw(),
                     ComplexBall(RealBall(b, bits + 64), RealBall()).raw(), bits, tolerance.get(),
                     options, bits + 64);
  return value.re();
}

}  // namespace phrame::test
