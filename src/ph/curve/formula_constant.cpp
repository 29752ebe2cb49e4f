#include "phrame/ph/curve/formula_constant.hpp"

#include <algorithm>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t most_terms = 8;
/// Of what is divided by, whose conjugates are multiplied.
constexpr std::size_t most_roots_below = 2;
constexpr long most_constant_bits = 2000;
constexpr long most_power = 16;

bool is_short(const Surd& x) {
  if (x.terms().size() > most_terms) return false;
  long bits = 0;
  for (const auto& [d, c] : x.terms()) bits += bit_length(d) + bits_of(c);
  return bits < most_constant_bits;
}

std::optional<FormulaConstant> if_short(FormulaConstant x) {
  if (!is_short(x.plain) || !is_short(x.of_pi)) return std::nullopt;
  return x;
}

std::optional<FormulaConstant> product(const FormulaConstant& x, const FormulaConstant& y) {
  if (!y.of_pi.is_zero()) {
    if (!x.of_pi.is_zero()) return std::nullopt;
    return product(y, x);
  }
  return if_short({x.plain * y.plain, x.of_pi * y.plain});
}

std::optional<FormulaConstant> quotient(const FormulaConstant& x, const FormulaConstant& y) {
  if (std::max(y.plain.count_roots(), y.of_pi.count_roots()) > most_roots_below)
    return std::nullopt;
  const bool are_of_pi = x.plain.is_zero() && y.plain.is_zero();
  if (are_of_pi && !y.of_pi.is_zero()) return if_short({x.of_pi / y.of_pi, {}});
  if (y.plain.is_zero() || !y.of_pi.is_zero()) return std::nullopt;
  return if_short({x.plain / y.plain, x.of_pi / y.plain});
}

std::optional<FormulaConstant> root(const FormulaConstant& x) {
  if (!x.of_pi.is_zero() || !x.plain.is_rational()) return std::nullopt;
  const Rational square = x.plain.rational_part();
  if (square.sign() <= 0) return std::nullopt;
  // √(p/q) = √(pq)/q
  const Integer below(denominator(square));
  return if_short({Surd(0, Rational(1) / Rational(below), Integer(numerator(square)) * below), {}});
}

std::optional<FormulaConstant> whole_power(const FormulaConstant& x, const Rational& exponent) {
  if (denominator(exponent) != 1 || abs(exponent) > most_power || !x.of_pi.is_zero())
    return std::nullopt;
  FormulaConstant power{Surd(1), {}};
  for (long k = static_cast<long>(numerator(abs(exponent))); k > 0; --k) {
    const auto next = product(power, x);
    if (!next) return std::nullopt;
    power = *next;
  }
  return exponent.sign() < 0 ? quotient({Surd(1), {}}, power) : power;
}

/// sin βπ for β of [0, 1/2].
std::optional<Surd> acute_sine(const Rational& beta) {
  const auto part = [](long a, long d, long b, long e, long below) {
    return Surd(0, Rational(a, below), d) + Surd(0, Rational(b, below), e);
  };
  if (beta == 0) return Surd();
  if (beta == Rational(1, 12)) return part(1, 6, -1, 2, 4);
  if (beta == Rational(1, 10)) return part(1, 5, -1, 1, 4);
  if (beta == Rational(1, 6)) return Surd(Rational(1, 2));
  if (beta == Rational(1, 4)) return part(1, 2, 0, 1, 2);
  if (beta == Rational(3, 10)) return part(1, 5, 1, 1, 4);
  if (beta == Rational(1, 3)) return part(1, 3, 0, 1, 2);
  if (beta == Rational(5, 12)) return part(1, 6, 1, 2, 4);
  if (beta == Rational(1, 2)) return Surd(1);
  return std::nullopt;
}

/// sin (angle + quarter·π/2).
std::optional<FormulaConstant> sine(const FormulaConstant& angle, long quarter) {
  if (!angle.plain.is_zero() || !angle.of_pi.is_rational()) return std::nullopt;
  const Rational turns = angle.of_pi.rational_part() + Rational(quarter, 2);
  const Integer half_turns = floor(turns);
  const Rational beta = turns - Rational(half_turns);
  const auto value = acute_sine(beta > Rational(1, 2) ? Rational(1 - beta) : beta);
  if (!value) return std::nullopt;
  return FormulaConstant{half_turns % Integer(2) == 0 ? *value : -*value, {}};
}

std::optional<FormulaConstant> arctangent(const FormulaConstant& x) {
  for (const long twelfths : {0L, 1L, 2L, 3L, 4L, 5L}) {
    const Rational beta(twelfths, 12);
    const Surd tangent = *acute_sine(beta) / *acute_sine(Rational(1, 2) - beta);
    if (x == FormulaConstant{tangent, {}}) return FormulaConstant{{}, Surd(beta)};
    if (x == FormulaConstant{-tangent, {}}) return FormulaConstant{{}, Surd(-beta)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FormulaConstant> apply(const Formula::Step& step, const FormulaConstant& left,
                                     const FormulaConstant& right) {
  switch (step.operation) {
    case Formula::Operation::add:
      return if_short({left.plain + right.plain, left.of_pi + right.of_pi});
    case Formula::Operation::multiply:
      return product(left, right);
    case Formula::Operation::divide:
      return quotient(left, right);
    case Formula::Operation::power:
      return step.number == Rational(1, 2) ? root(left) : whole_power(left, step.number);
    case Formula::Operation::sqrt:
      return root(left);
    case Formula::Operation::sin:
      return sine(left, 0);
    case Formula::Operation::cos:
      return sine(left, 1);
    case Formula::Operation::atan:
      return arctangent(left);
    default:
      return std::nullopt;
  }
}

}  // namespace phrame
