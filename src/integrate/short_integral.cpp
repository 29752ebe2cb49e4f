// With t = a + 2^E·v let f = vᵐ·N(v)/D(v), and let E be so small that on |v| ≤ 1
//   Σ_{k ≥ 1} |D_k| ≤ |D_0|/2, so that |D| ≥ |D_0|/2.
// Then N/D = Σ q_k vᵏ with |q_k| ≤ 2·Σ|N_k|/|D_0| =: B [Cauchy], and for |w| ≤ 1/2
//   ∫₀ʷ vᵐN/D dv = Σ_{k < K} q_k w^{k+m+1}/(k + m + 1) + R,  |R| ≤ 2B·|w|^{K+m+1}/(K + m + 1).
// All terms are small together with w, so that nothing is lost where the integral is small.
#include "phrame/integrate/short_integral.hpp"

#include <algorithm>
#include <limits>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/real.hpp"

namespace phrame {
namespace {

constexpr long least_gain = 4;   // bits that a term gives
constexpr long most_terms = 64;  // of the series
constexpr long smallest = std::numeric_limits<long>::min() / 8;

/// An e with |x| < 2^e for all x of the ball; `smallest` for 0.
long exponent_above(const RealBall& x) {
  flint::Mag size;
  arb_get_mag(size.get(), x.raw());
  if (mag_is_inf(size.get()) != 0) return -smallest;
  return mag_is_zero(size.get()) != 0 ? smallest : fmpz_get_si(MAG_EXPREF(size.get()));
}

/// An e with |x| ≥ 2^e for all x of the ball; `smallest` where 0 is one.
long exponent_below(const RealBall& x) {
  flint::Mag size;
  arb_get_mag_lower(size.get(), x.raw());
  return mag_is_zero(size.get()) != 0 ? smallest : fmpz_get_si(MAG_EXPREF(size.get())) - 1;
}

long floor_quotient(long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The greatest E, `largest` at most, with |d_k|·2^{Ek} ≤ 2^{−k−1}·|d_0| for all k ≥ 1.
long radius_exponent(const BallPolynomial& d, long largest) {
  const long middle = exponent_below(d.coefficient(0));
  long e = largest;
  for (long k = 1; k <= d.degree_bound(); ++k) {
    const long size = exponent_above(d.coefficient(k));
    if (size != smallest) e = std::min(e, floor_quotient(middle - size - k - 1, k));
  }
  return e;
}

/// p(2^e·v).
void scale(BallPolynomial& p, long e) {
  for (long k = 0; k <= p.degree_bound(); ++k) {
    arb_struct* c = arb_poly_get_coeff_ptr(p.raw(), k);
    if (c != nullptr) arb_mul_2exp_si(c, c, k * e);
  }
}

/// f near a, with n/d = f/(t − a)^zeros.
struct Shifted {
  Polynomial numerator;
  Polynomial denominator;
  long zeros = 0;
  Endpoint a;

  BallPolynomial around_a(const Polynomial& p, long bits) const {
    BallPolynomial q(p, bits);
    if (a == Endpoint(Rational(0))) return q;
    arb_poly_taylor_shift(q.raw(), q.raw(), enclose(a, bits).raw(), bits);
    return q;
  }
};

/// The integral, at a precision and with a number of terms that may not be enough.
struct Series {
  RealBall sum;
  RealBall sizes;      ///< of its terms, added up
  RealBall remainder;  ///< a bound of the terms left out
};

Series series(const Shifted& f, BallPolynomial d, const RealBall& h, long e, long terms,
              long bits) {
  BallPolynomial n = f.around_a(f.numerator, bits);
  scale(n, e);
  scale(d, e);
  RealBall bound;
  for (long k = 0; k <= n.degree_bound(); ++k) bound = add(bound, absolute(n.coefficient(k)), bits);
  bound = divide(bound, absolute(d.coefficient(0)), bits);
  BallPolynomial q;
  arb_poly_div_series(q.raw(), n.raw(), d.raw(), terms, bits);

  RealBall w = h;
  arb_mul_2exp_si(w.raw(), w.raw(), -e);
  RealBall power;  // w^{k+m+1}·2^{E(m+1)}
  arb_pow_ui(power.raw(), w.raw(), static_cast<ulong>(f.zeros) + 1, bits);
  arb_mul_2exp_si(power.raw(), power.raw(), e * (f.zeros + 1));
  Series result;
  for (long k = 0; k < terms; ++k) {
    const RealBall term =
        divide(multiply(q.coefficient(k), power, bits), RealBall(k + f.zeros + 1, bits), bits);
    result.sum = add(result.sum, term, bits);
    result.sizes = add(result.sizes, absolute(term), bits);
    power = multiply(power, w, bits);
  }
  result.remainder =
      divide(multiply(bound, absolute(power), bits), RealBall(terms + f.zeros + 1, bits), bits);
  arb_mul_2exp_si(result.remainder.raw(), result.remainder.raw(), 2);
  arb_add_error(result.sum.raw(), result.remainder.raw());
  return result;
}

/// Is |x| ≤ 2^−bits·y?
bool is_below(const mag_t x, const RealBall& y, long bits) {
  flint::Mag allowed;
  arb_get_mag_lower(allowed.get(), y.raw());
  mag_mul_2exp_si(allowed.get(), allowed.get(), -bits);
  return mag_cmp(x, allowed.get()) <= 0;
}

RealBall difference(const Endpoint& b, const Endpoint& a, long bits) {
  const auto* s = std::get_if<Rational>(&b);
  const auto* r = std::get_if<Rational>(&a);
  if (s != nullptr && r != nullptr) return RealBall(*s - *r, bits);
  return subtract(enclose(b, bits), enclose(a, bits), bits);
}

/// Are the ends so near to each other that it is worth the shift to a?
bool may_be_near(const Endpoint& a, const Endpoint& b) {
  if (a == Endpoint(Rational(0))) return true;
  constexpr long near = 16;
  constexpr long bits = 64;
  return exponent_above(difference(b, a, bits)) <
         std::max(-near, exponent_above(enclose(a, bits)) - near);
}

}  // namespace

std::optional<RealBall> short_integral(const RationalFunction& f, const Endpoint& a,
                                       const Endpoint& b, long bits) {
  if (f.is_zero() || a == b) return RealBall();
  if (!may_be_near(a, b)) return std::nullopt;
  Shifted at_a{f.numerator(), f.denominator(), 0, a};
  if (const auto* r = std::get_if<Rational>(&a)) {
    if (f.denominator()(*r) == 0) return std::nullopt;
    for (; at_a.numerator(*r) == 0; ++at_a.zeros)
      at_a.numerator = exact_quotient(at_a.numerator, Polynomial{-*r, 1});
  }
  const long end = 64 * bits + 65536 + 4 * (bits_of(a) + bits_of(b)) * (f.numerator().degree() + 1);
  long terms = 0;
  for (long precision = bits + 64; precision <= end;) {
    const RealBall h = difference(b, a, precision);
    const BallPolynomial d = at_a.around_a(at_a.denominator, precision);
    if (h.accuracy_bits() < least_gain || d.coefficient(0).accuracy_bits() < least_gain) {
      precision *= 2;
      continue;
    }
    const long size = exponent_above(h);
    const long e = radius_exponent(d, size + bits + 64);
    if (e - size < least_gain) return std::nullopt;
    if (terms == 0) terms = (bits + 16) / (e - size) + 2;
    if (terms > most_terms) return std::nullopt;
    const Series found = series(at_a, d, h, e, terms, precision);
    const mag_struct* radius = arb_radref(found.sum.raw());
    const bool is_fine =
        found.sum.is_finite() &&
        (is_below(radius, found.sum, bits) ||
         (is_below(radius, found.sizes, bits) && mag_cmp_2exp_si(radius, -bits) <= 0));
    if (is_fine) return found.sum;
    // Half the radius and more is what was left out, or it is rounding.
    flint::Mag left_out;
    arb_get_mag(left_out.get(), found.remainder.raw());
    mag_mul_2exp_si(left_out.get(), left_out.get(), 1);
    if (mag_cmp(left_out.get(), radius) < 0)
      precision *= 2;
    else
      terms += terms / 2 + 2;
  }
  return std::nullopt;
}

}  // namespace phrame
