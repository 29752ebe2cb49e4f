#include "phrame/algebra/roots.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/ehrlich_aberth.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/root_guess.hpp"

namespace phrame::inline v0 {
namespace {

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

/// Newton steps until z has `bits` correct bits or they no longer help.
void refine_root(acb_t z, const fmpz_poly_t p, const fmpz_poly_t derivative, slong bits) {
  // Cancellation in p(m) loses bits, rarely more than the coefficients have; the guard that makes
  // up for it is found by trying.
  slong guard = 32;
  const slong largest_guard = 64 + 4 * std::abs(fmpz_poly_max_bits(p)) + fmpz_poly_degree(p);
  while (acb_rel_accuracy_bits(z) < bits && guard <= largest_guard) {
    const slong before = std::max<slong>(acb_rel_accuracy_bits(z), 0);
    newton_step(z, p, derivative, std::min(bits, 2 * std::max<slong>(before, 32)) + guard);
    if (acb_rel_accuracy_bits(z) <= before + before / 4) guard *= 2;
  }
}

/// Sorted into real roots and those above the real axis, from left to right.
Roots collect(const std::vector<ComplexBall>& found) {
  Roots roots;
  for (const ComplexBall& z : found) {
    if (arb_is_zero(acb_imagref(z.raw())) != 0)
      roots.real.push_back(z.re());
    else if (arb_is_positive(acb_imagref(z.raw())) != 0)
      roots.upper.push_back(z);
  }
  if (roots.real.size() + 2 * roots.upper.size() != found.size())
    throw Undecided("isolate_roots: the enclosures found do not come in conjugate pairs");
  std::sort(roots.real.begin(), roots.real.end(),
            [](const RealBall& a, const RealBall& b) { return arb_lt(a.raw(), b.raw()) != 0; });
  // Only for the eye: real parts that agree to single precision count as equal.
  const auto place = [](const ComplexBall& z) {
    return std::pair(static_cast<float>(approximate(z.re())), approximate(z.im()));
  };
  std::sort(roots.upper.begin(), roots.upper.end(),
            [&](const ComplexBall& a, const ComplexBall& b) { return place(a) < place(b); });
  return roots;
}

/// (−b ± √(b² − 4ac))/2a. However near the two are, no search is needed, and they cannot cancel
/// more than the digits that the coefficients have.
std::vector<ComplexBall> solve_quadratic(const flint::FmpzPoly& f, slong bits) {
  const auto coefficient = [&](slong k) { return fmpz_poly_get_coeff_ptr(f.get(), k); };
  const slong precision = bits + 32 + 2 * std::abs(fmpz_poly_max_bits(f.get()));
  flint::Fmpz discriminant;
  fmpz_mul(discriminant.get(), coefficient(2), coefficient(0));
  fmpz_mul_si(discriminant.get(), discriminant.get(), -4);
  fmpz_addmul(discriminant.get(), coefficient(1), coefficient(1));
  ComplexBall root;
  acb_set_fmpz(root.raw(), discriminant.get());
  acb_sqrt(root.raw(), root.raw(), precision);
  std::vector<ComplexBall> found{root, root};
  acb_neg(found[0].raw(), root.raw());
  for (ComplexBall& z : found) {
    acb_sub_fmpz(z.raw(), z.raw(), coefficient(1), precision);
    acb_div_fmpz(z.raw(), z.raw(), coefficient(2), precision);
    acb_mul_2exp_si(z.raw(), z.raw(), -1);
  }
  return found;
}

/// From approximations on, which a quadratic does not need.
Roots certified(const flint::FmpzPoly& f, std::vector<ComplexBall> points, slong bits) {
  if (fmpz_poly_degree(f.get()) == 2) return collect(solve_quadratic(f, bits));
  const auto found = enclose_roots(f, std::move(points), bits);
  if (found.empty()) throw Undecided("isolate_roots: the roots could not be told apart");
  return collect(found);
}

}  // namespace

Roots isolate_roots(const Polynomial& p, long bits) {
  if (p.is_constant()) throw DomainError("isolate_roots: the polynomial is constant");
  if (!is_squarefree(p)) throw DomainError("isolate_roots: the polynomial has a repeated root");
  const flint::FmpzPoly f = integer_primitive_part(p);
  if (p.degree() == 2) return certified(f, {}, bits);
  Roots roots = certified(f, guess_roots(f).points, 0);
  refine(p, roots, bits);
  return roots;
}

bool has_no_clear_root(const Polynomial& p) {
  return p.degree() > 2 && guess_roots(integer_primitive_part(p)).vague == p.degree();
}

bool refine(const Polynomial& p, RealBall& root, long bits) {
  const flint::FmpzPoly f = integer_primitive_part(p);
  flint::FmpzPoly derivative;
  fmpz_poly_derivative(derivative.get(), f.get());
  ComplexBall z(root, RealBall());
  refine_root(z.raw(), f.get(), derivative.get(), bits);
  root = z.re();
  return acb_rel_accuracy_bits(z.raw()) >= bits;
}

void refine(const Polynomial& p, Roots& roots, long bits) {
  const flint::FmpzPoly f = integer_primitive_part(p);
  flint::FmpzPoly derivative;
  fmpz_poly_derivative(derivative.get(), f.get());
  slong reached = bits;
  for (RealBall& x : roots.real) {
    ComplexBall z(x, RealBall());
    refine_root(z.raw(), f.get(), derivative.get(), bits);
    reached = std::min(reached, acb_rel_accuracy_bits(z.raw()));
    x = z.re();
  }
  for (ComplexBall& z : roots.upper) {
    refine_root(z.raw(), f.get(), derivative.get(), bits);
    reached = std::min(reached, acb_rel_accuracy_bits(z.raw()));
  }
  if (reached >= bits) return;
  // Newton's step does nothing for a ball so wide that p′ has a zero in it, as in a cluster.
  std::vector<ComplexBall> points;
  const auto add_point = [&](const ComplexBall& z) {
    acb_get_mid(points.emplace_back().raw(), z.raw());
  };
  for (const RealBall& x : roots.real) add_point({x, {}});
  for (const ComplexBall& z : roots.upper) {
    add_point(z);
    add_point(conjugate(z));
  }
  roots = certified(f, std::move(points), bits);
}

}  // namespace phrame
