#include "phrame/algebra/grid_quotient.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/unit_recurrence.hpp"

namespace phrame::inline v0 {
namespace {

/// About √x, with so many bits, for x > 0.
Rational root_near(const Rational& x, long bits) {
  const long shift = bits - binary_exponent(x) / 2;
  return Rational(sqrt(floor(x * power_of_two(2 * shift)))) * power_of_two(-shift);
}

/// Σ factor·series[k]·zᵏ/2^Q, rounded.
GridPolynomial on_grid(const std::vector<Integer>& series, long Q, const Rational& factor,
                       long bits) {
  GridPolynomial p{{}, std::max(bits, 0L)};
  const Rational unit = factor * power_of_two(p.bits - Q);
  for (const Integer& c : series) p.terms.push_back(floor(unit * Rational(c) + Rational(1, 2)));
  while (!p.terms.empty() && p.terms.back() == 0) p.terms.pop_back();
  return p;
}

}  // namespace

std::optional<GridQuotient> grid_quotient(const Polynomial& numerator,
                                          const Polynomial& denominator, const Polynomial& radicand,
                                          long bits) {
  const bool is_zero = numerator.is_zero();
  const UnitQuotient f = unit_quotient(is_zero ? Polynomial{1} : numerator, denominator, radicand);
  // The rate is factor·y, and the root w/√S(0).
  const Rational at_zero(Integer(f.denominator.get()->coeffs));
  const Rational rational_part = f.factor * power_of_two(unit_exponent(f.numerator)) / at_zero;
  const Rational squared =
      rational_part * rational_part / Rational(Integer(f.radicand.get()->coeffs));
  constexpr long least_bits = 8;
  const long relative =
      is_zero ? least_bits : std::max(least_bits, bits + binary_exponent(squared) / 2 + 4);
  const long count = relative * 2 / 3 + 2 + radicand.degree();
  const long more = bit_length(Integer(count)) + 4;
  const long Q = relative + more + 16;
  const long most_bits = Q + 64;
  RootRecurrence<Integer> root(f, Q, most_bits);
  QuotientRecurrence<Integer> quotient(f, most_bits);
  quotient.step(root.w());
  for (long k = 0; k < count; ++k) {
    root.step();
    quotient.step(root.w());
    if (bit_length(root.w().c.back()) > most_bits) return std::nullopt;  // these series diverge
  }
  const Rational size = root_near(radicand.coefficient(0), Q);
  GridQuotient found;
  found.root = on_grid(root.w().c, Q, 1 / size, relative + more + binary_exponent(size));
  if (!is_zero)
    found.rate = on_grid(quotient.y().c, Q, Rational(rational_part.sign()) * root_near(squared, Q),
                         bits + more);
  return found;
}

}  // namespace phrame
