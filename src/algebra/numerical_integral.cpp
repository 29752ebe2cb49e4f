#include "phrame/algebra/numerical_integral.hpp"

namespace phrame::inline v0 {
namespace {

struct Integrand {
  const AnalyticFunction& f;
};

int integrand(acb_ptr result, const acb_t t, void* function, slong, slong precision) {
  ComplexBall z;
  acb_set(z.raw(), t);
  acb_set(result, static_cast<const Integrand*>(function)->f(z, precision).raw());
  return 0;
}

}  // namespace

RealBall numerical_integral(const AnalyticFunction& f, const RealBall& a, const RealBall& b,
                            const IntegralEffort& effort) {
  Integrand function{f};
  flint::Mag tolerance;
  mag_set_ui_2exp_si(tolerance.get(), 1, -effort.bits);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = effort.most_points;
  ComplexBall value;
  acb_calc_integrate(value.raw(), integrand, &function, ComplexBall(a, {}).raw(),
                     ComplexBall(b, {}).raw(), effort.bits, tolerance.get(), options,
                     effort.precision);
  return value.re();
}

ComplexBall integrand_sqrt(const ComplexBall& z, long bits) {
  ComplexBall root;
  acb_sqrt_analytic(root.raw(), z.raw(), 1, bits);
  return root;
}

}  // namespace phrame
