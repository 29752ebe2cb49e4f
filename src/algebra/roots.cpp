#include "phrame/algebra/roots.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/root_guess.hpp"

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

/// All roots of f, certified from a guess: inclusion discs, disjoint and n in number, after a few
/// steps at that precision. False where the guess is not good enough to be proved.
bool certify(const std::vector<RootGuess>& guess, const AcbVector& found, const flint::FmpzPoly& f,
             slong steps, slong bits) {
  const AcbVector start(found.length);
  for (slong k = 0; k < found.length; ++k) {
    const auto& [z, scale] = guess[static_cast<std::size_t>(k)];
    acb_set_d_d(start.data + k, z.real(), z.imag());
    acb_mul_2exp_si(start.data + k, start.data + k, scale);
  }
  flint::AcbPoly p;
  acb_poly_set_fmpz_poly(p.get(), f.get(), bits);
  if (acb_poly_find_roots(found.data, p.get(), start.data, steps, bits) != found.length ||
      acb_poly_validate_real_roots(found.data, p.get(), bits) == 0)
    return false;
  // It is validated that a ball which meets the real axis is the ball of a real root.
  for (slong k = 0; k < found.length; ++k)
    if (arb_contains_zero(acb_imagref(found.data + k)) != 0) arb_zero(acb_imagref(found.data + k));
  return true;
}

/// Values of f lose about a bit or two for every two degrees, so the precision grows with n.
bool certify_guess(const AcbVector& found, const flint::FmpzPoly& f) {
  const auto guess = guess_roots(f);
  if (static_cast<slong>(guess.size()) != found.length) return false;
  const slong bits = 128 + found.length / 2;
  return certify(guess, found, f, 1, bits) || certify(guess, found, f, 3, 2 * bits);
}

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

/// Sorted into real roots and those above the real axis, from left to right. Real roots are exactly
/// real in `found`.
Roots collect(const AcbVector& found) {
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
void solve_quadratic(const AcbVector& found, const flint::FmpzPoly& f, slong bits) {
  const auto coefficient = [&](slong k) { return fmpz_poly_get_coeff_ptr(f.get(), k); };
  const slong precision = bits + 32 + 2 * std::abs(fmpz_poly_max_bits(f.get()));
  flint::Fmpz discriminant;
  fmpz_mul(discriminant.get(), coefficient(2), coefficient(0));
  fmpz_mul_si(discriminant.get(), discriminant.get(), -4);
  fmpz_addmul(discriminant.get(), coefficient(1), coefficient(1));
  ComplexBall root;
  acb_set_fmpz(root.raw(), discriminant.get());
  acb_sqrt(root.raw(), root.raw(), precision);
  for (slong k = 0; k < 2; ++k) {
    acb_ptr z = found.data + k;
    if (k == 0) acb_neg(z, root.raw());
    if (k == 1) acb_set(z, root.raw());
    acb_sub_fmpz(z, z, coefficient(1), precision);
    acb_div_fmpz(z, z, coefficient(2), precision);
    acb_mul_2exp_si(z, z, -1);
  }
}

/// Without a guess.
Roots search_roots(const flint::FmpzPoly& f, slong bits) {
  const AcbVector found(fmpz_poly_degree(f.get()));
  if (found.length == 2)
    solve_quadratic(found, f, bits);
  else
    arb_fmpz_poly_complex_roots(found.data, f.get(), 0, bits);
  return collect(found);
}

}  // namespace

Roots isolate_roots(const Polynomial& p, long bits) {
  if (p.is_constant()) throw DomainError("isolate_roots: the polynomial is constant");
  if (!is_squarefree(p)) throw DomainError("isolate_roots: the polynomial has a repeated root");
  const flint::FmpzPoly f = integer_primitive_part(p);
  const AcbVector found(fmpz_poly_degree(f.get()));
  if (!certify_guess(found, f)) return search_roots(f, bits);
  Roots roots = collect(found);
  refine(p, roots, bits);
  return roots;
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
  // Newton's step does nothing for a ball so wide that p′ has a zero in it, as in a cluster.
  if (reached < bits) roots = search_roots(f, bits);
}

}  // namespace phrame
