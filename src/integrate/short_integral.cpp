// With t = a + 2^E·v let f = vᵐ·N(v)/D(v), and let E be so small that on |v| ≤ 1
//   Σ_{k ≥ 1} |D_k| ≤ |D_0|/2, so that |D| ≥ |D_0|/2.
// Then N/D = Σ q_k vᵏ with |q_k| ≤ 2·Σ|N_k|/|D_0| =: B [Cauchy], and for |w| ≤ 1/2
//   ∫₀ʷ vᵐN/D dv = Σ_{k < K} q_k w^{k+m+1}/(k + m + 1) + R,  |R| ≤ 2B·|w|^{K+m+1}/(K + m + 1).
// All terms are small together with w, so that nothing is lost where the integral is small.
#include "phrame/integrate/short_integral.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long least_gain = 4;   // bits that a term gives
constexpr long most_terms = 64;  // of the series

long floor_quotient(long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The greatest E, `largest` at most, with |d_k|·2^{Ek} ≤ 2^{−k−1}·|d_0| for all k ≥ 1.
long radius_exponent(const BallPolynomial& d, long largest) {
  const long middle = exponent_below(d.coefficient(0));
  long e = largest;
  for (long k = 1; k <= d.degree_bound(); ++k) {
    const long size = exponent_above(d.coefficient(k));
    if (size != -unbounded_exponent) e = std::min(e, floor_quotient(middle - size - k - 1, k));
  }
  return e;
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
    return shifted(q, enclose(a, bits), bits);
  }
};

/// The integral, at a precision and with a number of terms that may not be enough.
struct Series {
  RealBall sum;
  RealBall sizes;      ///< of its terms, added up
  RealBall remainder;  ///< a bound of the terms left out
};

Series series(const Shifted& f, const BallPolynomial& around_a, const RealBall& h, long e,
              long terms, long bits) {
  const BallPolynomial n = stretched(f.around_a(f.numerator, bits), e);
  const BallPolynomial d = stretched(around_a, e);
  RealBall bound;
  for (long k = 0; k <= n.degree_bound(); ++k) bound = add(bound, absolute(n.coefficient(k)), bits);
  bound = divide(bound, absolute(d.coefficient(0)), bits);
  const BallPolynomial q = divide_series(n, d, terms, bits);

  const RealBall w = times_power_of_two(h, -e);
  // w^{k+m+1}·2^{E(m+1)}
  RealBall power = times_power_of_two(pow(w, f.zeros + 1, bits), e * (f.zeros + 1));
  Series result;
  for (long k = 0; k < terms; ++k) {
    const RealBall term =
        divide(multiply(q.coefficient(k), power, bits), RealBall(k + f.zeros + 1, bits), bits);
    result.sum = add(result.sum, term, bits);
    result.sizes = add(result.sizes, absolute(term), bits);
    power = multiply(power, w, bits);
  }
  const RealBall quarter =
      divide(multiply(bound, absolute(power), bits), RealBall(terms + f.zeros + 1, bits), bits);
  result.remainder = times_power_of_two(quarter, 2);
  result.sum = widened(std::move(result.sum), result.remainder);
  return result;
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
  const RealBall one(1, bits);
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
    const RealBall radius = radius_of(found.sum);
    const auto is_below = [&](const RealBall& x) {
      return is_at_most(radius, times_power_of_two(absolute(x), -bits));
    };
    const bool is_fine =
        found.sum.is_finite() && (is_below(found.sum) || (is_below(found.sizes) && is_below(one)));
    if (is_fine) return found.sum;
    // Half the radius and more is what was left out, or it is rounding.
    if (is_less(times_power_of_two(found.remainder, 1), radius))
      precision *= 2;
    else
      terms += terms / 2 + 2;
  }
  return std::nullopt;
}

}  // namespace phrame
