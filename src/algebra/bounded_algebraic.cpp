// With D the denominator, H the size and N the number of conjugates of x, and P ∈ ℤ[t] of degree e,
// y = Dᵉ·P(x) is an algebraic integer. Its conjugates are numbers Dᵉ·P(x′), at most N of them, and
// none is larger than M = max(1, Dᵉ·P̂(H)), P̂ with the absolute values of the coefficients. If y is
// not 0 their product is an integer that is not 0, and |y| ≥ M^(1−N). So
//   |P(x)| < D^(−e)·M^(1−N)  proves  P(x) = 0.
//
// The guess: in the lattice of the vectors (p₀, …, p_e, Σ pₖ·round(2ᵇ·xᵏ)) those of polynomials
// with P(x) = 0 are short, and for large b all others are long [Lenstra, Lenstra, Lovász 1982]. The
// primitive polynomial of x divides ∏ (Dt − Dx′) with integer coefficients ≤ (2·D·max(1, H))ᵉ.
#include "phrame/algebra/bounded_algebraic.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/lattice.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long most_bits = 1L << 18;
constexpr long most_lattice_bits = 4000;

/// log₂ x rounded up, about, for x > 0; 0 for x ≤ 1.
long magnitude_bits(const Rational& x) { return x <= 1 ? 0 : binary_exponent(x) + 2; }

Polynomial with_absolute_values(const Polynomial& p) {
  std::vector<Rational> list = p.coefficients();
  for (Rational& c : list) c = abs(c);
  return Polynomial(list);
}

/// A ball of a radius ≤ 2^−bits.
RealBall narrow(const BoundedAlgebraic& x, long bits) {
  for (long precision = bits + 16;; precision += precision / 2) {
    RealBall ball = x.enclose(precision);
    if (mag_cmp_2exp_si(arb_radref(ball.raw()), -bits) <= 0) return ball;
  }
}

/// A polynomial of a degree ≤ e that is small at x for its coefficients.
Polynomial guess(const BoundedAlgebraic& x, long e) {
  const long height = e * (1 + magnitude_bits(Rational(x.denominator)) + magnitude_bits(x.size));
  const long bits = std::min(most_lattice_bits, (e + 1) * (height + e) + 64);
  const long precision = bits + 64 + e * magnitude_bits(x.size + 1);
  const RealBall ball = narrow(x, precision);
  IntegerRows lattice;
  RealBall power(1, precision);
  for (long k = 0; k <= e; ++k) {
    std::vector<Integer> row(static_cast<std::size_t>(e + 2));
    row[static_cast<std::size_t>(k)] = 1;
    RealBall scaled;
    arb_mul_2exp_si(scaled.raw(), power.raw(), bits);
    arf_get_fmpz(row.back().raw(), arb_midref(scaled.raw()), ARF_RND_NEAR);
    lattice.push_back(std::move(row));
    power = multiply(power, ball, precision);
  }
  std::vector<Integer> shortest = reduced_basis(lattice).front();
  shortest.pop_back();
  std::vector<Rational> coefficients(shortest.begin(), shortest.end());
  return Polynomial(coefficients);
}

/// The root x of p, in an interval that is short to write.
RealAlgebraic located(const Polynomial& p, const BoundedAlgebraic& x) {
  const std::vector<RealRoot> roots = real_roots(p, real_line());
  for (long bits = 64;; bits *= 2) {
    const RealBall ball = narrow(x, bits);
    const RealAlgebraic* found = nullptr;
    long overlaps = 0;
    for (const RealRoot& root : roots)
      if (enclose(root.at, bits).overlaps(ball)) {
        found = &root.at;
        ++overlaps;
      }
    if (overlaps == 1) return *found;
  }
}

}  // namespace

BoundedAlgebraic bounded(const RealAlgebraic& x) {
  const Polynomial& p = x.polynomial();
  Rational largest = 0;  // Cauchy's bound of the roots
  for (long k = 0; k < p.degree(); ++k)
    largest = std::max(largest, Rational(abs(p.coefficient(k) / p.leading_coefficient())));
  return {[x](long bits) { return phrame::enclose(x, bits); }, numerator(p.leading_coefficient()),
          largest + 1, p.degree()};
}

BoundedAlgebraic operator+(const BoundedAlgebraic& x, const BoundedAlgebraic& y) {
  const bool is_small = x.conjugates <= many_conjugates / y.conjugates;
  return {[x, y](long bits) { return add(x.enclose(bits + 2), y.enclose(bits + 2), bits + 2); },
          lcm(x.denominator, y.denominator), x.size + y.size,
          is_small ? x.conjugates * y.conjugates : many_conjugates};
}

std::optional<bool> is_root(const Polynomial& p, const BoundedAlgebraic& x) {
  if (p.is_zero()) throw DomainError("is_root: the zero polynomial");
  const Polynomial q = primitive_part(p);
  const long to_integer = q.degree() * magnitude_bits(Rational(x.denominator));
  const long height = magnitude_bits(with_absolute_values(q)(x.size));
  const long each = to_integer + height;
  const bool is_short = each == 0 || x.conjugates < most_bits / each;
  // Not 0, the value is at least 2^−proof: the product of its conjugates, times a power of the
  // denominator, is an integer.
  const long proof = is_short ? to_integer + (x.conjugates - 1) * each : 0;
  for (long bits = 128 + height;; bits *= 2) {
    const RealBall value = evaluate(q, narrow(x, bits), bits + height);
    if (!value.contains_zero()) return false;
    flint::Mag largest;
    arb_get_mag(largest.get(), value.raw());
    if (is_short && mag_cmp_2exp_si(largest.get(), -proof) < 0) return true;
    if (bits > most_bits + height) return std::nullopt;
  }
}

std::optional<RealAlgebraic> recognized(const BoundedAlgebraic& x, long largest_degree) {
  const std::optional<bool> is_zero = is_root({0, 1}, x);
  if (!is_zero) return std::nullopt;
  if (*is_zero) return RealAlgebraic(0);
  const long top = std::min(largest_degree, x.conjugates);
  for (long e = std::min(2L, top);; e = std::min(2 * e, top)) {
    const Polynomial p = guess(x, e);
    if (!p.is_constant())
      for (const auto& [base, exponent] : factor(p).factors)
        if (is_root(base, x) == true) return located(base, x);
    if (e == top) return std::nullopt;
  }
}

}  // namespace phrame
