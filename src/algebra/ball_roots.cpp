#include "phrame/algebra/ball_roots.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"

namespace phrame::inline v0 {
namespace {

/// The roots of the polynomial in the middle, as coefficients: each in its own scale, which the
/// iteration from a circle would need many steps for. None where they are not single ones.
flint::AcbPoly guesses(const BallPolynomial& p, long bits) {
  std::vector<Rational> middle;
  for (long k = 0; k <= p.degree_bound(); ++k) middle.push_back(p.coefficient(k).midpoint());
  flint::AcbPoly list;
  long count = 0;
  const auto append = [&](const ComplexBall& z) {
    acb_poly_set_coeff_acb(list.get(), count++, z.midpoint().raw());
  };
  try {
    const Roots roots = isolate_roots(Polynomial(middle), bits);
    acb_poly_fit_length(list.get(), p.degree_bound());
    for (const RealBall& x : roots.real) append(ComplexBall(x, {}));
    for (const ComplexBall& z : roots.upper) {
      append(z);
      append(conjugate(z));
    }
  } catch (const DomainError&) {
    count = 0;
  }
  if (count != p.degree_bound()) return {};
  return list;
}

}  // namespace

BallRoots ball_roots(const BallPolynomial& p, long bits) {
  const long degree = p.degree_bound();
  flint::AcbPoly complex;
  acb_poly_set_arb_poly(complex.get(), p.raw());
  flint::AcbPoly roots;  // as coefficients
  acb_poly_fit_length(roots.get(), degree);
  acb_ptr const list = roots.get()->coeffs;
  flint::AcbPoly first = guesses(p, bits);
  acb_ptr const start = acb_poly_length(first.get()) == 0 ? nullptr : first.get()->coeffs;
  const long isolated = acb_poly_find_roots(list, complex.get(), start, 0, bits);
  const bool are_isolated =
      isolated == degree && acb_poly_validate_real_roots(list, complex.get(), bits) != 0;
  BallRoots found{{}, are_isolated};
  for (long k = 0; k < degree; ++k) {
    ComplexBall root;
    acb_set(root.raw(), list + k);
    if (are_isolated && root.im().contains_zero()) root = ComplexBall(root.re(), {});
    found.all.push_back(root);
  }
  return found;
}

}  // namespace phrame
