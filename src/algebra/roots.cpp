#include "phrame/algebra/roots.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

struct AcbVector {
  acb_ptr data;
  slong length;
  explicit AcbVector(slong n) : data(_acb_vec_init(n)), length(n) {}
  ~AcbVector() { _acb_vec_clear(data, length); }
  AcbVector(const AcbVector&) = delete;
  AcbVector& operator=(const AcbVector&) = delete;
};

/// One interval Newton step. The mean value form p(m) = (m − z)·w holds with w in the convex hull
/// of p′(Z); a rectangle is convex, so z ∈ m − p(m)/p′(Z) whenever z ∈ Z.
void newton_step(acb_t z, const fmpz_poly_t p, const fmpz_poly_t derivative, slong bits) {
  ComplexBall middle;
  ComplexBall value;
  ComplexBall slope;
  acb_get_mid(middle.raw(), z);
  arb_fmpz_poly_evaluate_acb(value.raw(), p, middle.raw(), bits);
  arb_fmpz_poly_evaluate_acb(slope.raw(), derivative, z, bits);
  acb_div(value.raw(), value.raw(), slope.raw(), bits);
  acb_sub(middle.raw(), middle.raw(), value.raw(), bits);
  // The new ball is kept only if it is narrower: an enclosure never becomes worse.
  if (acb_is_finite(middle.raw()) != 0 && acb_rel_error_bits(middle.raw()) < acb_rel_error_bits(z))
    acb_swap(z, middle.raw());
}

void refine_root(acb_t z, const fmpz_poly_t p, const fmpz_poly_t derivative, slong bits) {
  // Evaluating p loses about the size of its coefficients; more is added while steps stall.
  slong guard = 32 + 2 * std::abs(fmpz_poly_max_bits(p));
  for (int stalled = 0; acb_rel_accuracy_bits(z) < bits && stalled < 8;) {
    const slong before = acb_rel_accuracy_bits(z);
    newton_step(z, p, derivative, std::min(bits, 2 * std::max<slong>(before, 32)) + guard);
    if (acb_rel_accuracy_bits(z) <= before + before / 4) {
      ++stalled;
      guard *= 2;
    }
  }
}

}  // namespace

Roots isolate_roots(const Polynomial& p, long bits) {
  if (p.is_constant()) throw DomainError("isolate_roots: the polynomial is constant");
  if (!is_squarefree(p)) throw DomainError("isolate_roots: the polynomial has a repeated root");
  const flint::FmpzPoly f = integer_primitive_part(p);
  const AcbVector found(fmpz_poly_degree(f.get()));
  arb_fmpz_poly_complex_roots(found.data, f.get(), 0, bits);
  Roots roots;
  for (slong k = 0; k < found.length; ++k) {
    acb_srcptr z = found.data + k;
    if (arb_is_zero(acb_imagref(z)) != 0) {
      roots.real.emplace_back();
      acb_get_real(roots.real.back().raw(), z);
    } else if (arb_is_positive(acb_imagref(z)) != 0) {
      roots.upper.emplace_back();
      acb_set(roots.upper.back().raw(), z);
    }
  }
  if (static_cast<slong>(roots.real.size() + 2 * roots.upper.size()) != found.length)
    throw Undecided("isolate_roots: the enclosures found do not come in conjugate pairs");
  std::sort(roots.real.begin(), roots.real.end(), [](const RealBall& a, const RealBall& b) {
    return arb_lt(a.raw(), b.raw()) != 0;
  });
  return roots;
}

void refine(const Polynomial& p, Roots& roots, long bits) {
  const flint::FmpzPoly f = integer_primitive_part(p);
  flint::FmpzPoly derivative;
  fmpz_poly_derivative(derivative.get(), f.get());
  for (RealBall& x : roots.real) {
    ComplexBall z(x, RealBall());
    refine_root(z.raw(), f.get(), derivative.get(), bits);
    x = z.re();
  }
  for (ComplexBall& z : roots.upper) refine_root(z.raw(), f.get(), derivative.get(), bits);
}

}  // namespace phrame
