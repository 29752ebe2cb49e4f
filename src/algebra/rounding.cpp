#include "phrame/algebra/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/error_free.hpp"
#include "phrame/algebra/fixed_point.hpp"

namespace phrame::inline v0 {

Rational power_of_two(long k) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(k));
  return k >= 0 ? Rational(power) : Rational(1) / Rational(power);
}

Rational power_of_ten(long k) {
  const Integer power = pow(Integer(10), static_cast<unsigned long>(std::abs(k)));
  return k >= 0 ? Rational(power) : Rational(1) / Rational(power);
}

long binary_exponent(const Rational& x) {
  return bit_length(numerator(x)) - bit_length(denominator(x));
}

long decimal_exponent(const Rational& x) {
  auto e =
      static_cast<long>(std::floor(static_cast<double>(binary_exponent(x)) * std::log10(2.0))) - 1;
  while (power_of_ten(e + 1) <= x) ++e;
  return e;
}

namespace {

/// What both ends of the ball round to, where that is the same; `round` maps an exact number to the
/// result.
template <class Round>
auto common(const RealBall& ball, Round round) -> std::optional<decltype(round(Rational()))> {
  auto low = round(ball.lower());
  if (low == round(ball.upper())) return low;
  return std::nullopt;
}

/// The common rounding of both ends of ever narrower balls. `bits` is the relative precision that
/// the result needs; `of_ball` maps a ball to its common rounding.
template <class OfBall>
auto ziv(const Real& x, long bits, PrecisionLimit limit, OfBall of_ball) {
  const Real::Origin origin = x.origin();
  const long end = origin.is_irrational ? std::numeric_limits<long>::max()
                                        : limit.factor * (bits + origin.bits) + limit.offset;
  for (long precision = bits + 16;;) {
    const RealBall ball = x.enclose(precision);
    if (ball.is_finite())
      if (auto rounded = of_ball(ball)) return *std::move(rounded);
    if (precision >= end)
      throw Undecided(
          fmt::format("correct rounding to {} bits: the number cannot be told from a "
                      "boundary between two results with {} bits of precision",
                      bits, precision));
    // One step brings a number far from 1 to the relative accuracy needed, then half more a step.
    const long missing = ball.contains_zero() ? precision : bits + 16 - ball.accuracy_bits();
    precision = std::min(end, std::max(precision + precision / 2, precision + missing));
  }
}

/// |x| rounded to an integer, half to even.
Integer nearest_integer(const Rational& x) {
  const Integer below = numerator(x) / denominator(x);
  const Rational rest = x - Rational(below);
  const Rational half(1, 2);
  const bool up = rest > half || (rest == half && below % 2 != 0);
  return up ? Integer(below + 1) : below;
}

struct Digits {
  bool negative = false;
  std::string digits;  ///< empty for 0
  long exponent = 0;   ///< of the first digit
  friend bool operator==(const Digits&, const Digits&) = default;
};

Digits round_digits(const Rational& x, long count) {
  if (x == 0) return {};
  const Rational size = abs(x);
  Digits result{x < 0, {}, decimal_exponent(size)};
  result.digits = nearest_integer(size * power_of_ten(count - 1 - result.exponent)).str();
  if (static_cast<long>(result.digits.size()) > count) {  // 9.99… became 10.0…
    result.digits.pop_back();
    ++result.exponent;
  }
  return result;
}

Rational exact_value(const Digits& d) {
  if (d.digits.empty()) return 0;
  const Rational size = Rational(Integer(d.digits)) *
                        power_of_ten(d.exponent + 1 - static_cast<long>(d.digits.size()));
  return d.negative ? Rational(-size) : size;
}

/// Positional where that needs few zeros, else scientific.
std::string text_of(const Digits& d) {
  if (d.digits.empty()) return "0";
  const auto count = static_cast<long>(d.digits.size());
  const auto sign = d.negative ? "-" : "";
  if (d.exponent < -5 || d.exponent >= count)
    return fmt::format("{}{}{}{}e{}", sign, d.digits.substr(0, 1), count > 1 ? "." : "",
                       d.digits.substr(1), d.exponent);
  if (d.exponent < 0)
    return fmt::format("{}0.{}{}", sign,
                       std::string(static_cast<std::size_t>(-d.exponent - 1), '0'), d.digits);
  const auto whole = static_cast<std::size_t>(d.exponent + 1);
  return fmt::format("{}{}{}{}", sign, d.digits.substr(0, whole),
                     whole < d.digits.size() ? "." : "", d.digits.substr(whole));
}

/// f/2^shift·10^−places for 0 < f ≤ 2^shift, with two digits, rounded up: n·10^exponent. Below 10
/// n tells that f is too small.
struct TwoDigits {
  ulong n = 0;
  long exponent = 0;
  friend bool operator==(const TwoDigits&, const TwoDigits&) = default;

  TwoDigits(const fmpz_t f, long shift, long places) {
    constexpr long most_steps = 12;
    flint::Fmpz scaled;
    flint::Fmpz below;
    fmpz_set(scaled.get(), f);
    for (long k = 1; k <= most_steps && n < 10; ++k) {
      fmpz_mul_ui(scaled.get(), scaled.get(), 10);
      fmpz_fdiv_q_2exp(below.get(), scaled.get(), static_cast<ulong>(shift));
      n = fmpz_get_ui(below.get());
      exponent = -places - k;
    }
    if (n < 10) return;
    if (fmpz_val2(scaled.get()) < static_cast<ulong>(shift)) ++n;
    if (n == 100) {
      n = 10;
      ++exponent;
    }
  }
  std::string text() const { return fmt::format("{}.{}e{}", n / 10, n % 10, exponent + 1); }
};

/// What round_to_decimal() says of a number in x, whichever enclosures it has; by integers of a few
/// words. The ball of 128 bits that an enclosure may be is in x, widened by 2^−110. No value where
/// that is not decided, and for many digits and numbers of unusual size.
std::optional<Decimal> decided_decimal(RealBall x, long digits) {
  constexpr long most_digits = 18;
  const double size = std::abs(approximate(x));
  if (digits > most_digits || !x.is_finite() || !(size > 1e-20 && size < 1e15)) return std::nullopt;
  arb_add_error_2exp_si(x.raw(), std::max(0, std::ilogb(size) + 1) - 110);
  flint::Fmpz low;
  flint::Fmpz high;
  flint::Fmpz exponent_of_two;
  arb_get_interval_fmpz_2exp(low.get(), high.get(), exponent_of_two.get(), x.raw());
  const bool negative = fmpz_sgn(low.get()) < 0;
  if (negative) {
    fmpz_swap(low.get(), high.get());
    fmpz_neg(low.get(), low.get());
    fmpz_neg(high.get(), high.get());
  }
  const long shift = -fmpz_get_si(exponent_of_two.get());
  const auto exponent = static_cast<long>(std::floor(std::log10(size)));
  const long places = digits - 1 - exponent;
  if (fmpz_sgn(low.get()) <= 0 || shift < 1 || places < 0) return std::nullopt;

  // In units of the last place, times 2^shift; by one unit of that wider, so that no end is a tie.
  flint::Fmpz scale;
  fmpz_ui_pow_ui(scale.get(), 10, static_cast<ulong>(places));
  fmpz_mul(low.get(), low.get(), scale.get());
  fmpz_mul(high.get(), high.get(), scale.get());
  fmpz_sub_ui(low.get(), low.get(), 1);
  fmpz_add_ui(high.get(), high.get(), 1);
  const auto nearest = [shift](const fmpz_t end) {
    flint::Fmpz n;
    fmpz_one(n.get());
    fmpz_mul_2exp(n.get(), n.get(), static_cast<ulong>(shift - 1));
    fmpz_add(n.get(), n.get(), end);
    fmpz_fdiv_q_2exp(n.get(), n.get(), static_cast<ulong>(shift));
    return n;
  };
  flint::Fmpz n = nearest(low.get());
  const std::string text = Integer(n.get()).str();
  if (fmpz_equal(n.get(), nearest(high.get()).get()) == 0) return std::nullopt;
  // At a power of ten the guess of the exponent does not tell on which side the number is.
  if (static_cast<long>(text.size()) != digits ||
      std::all_of(text.begin() + 1, text.end(), [](char c) { return c == '0'; }))
    return std::nullopt;

  fmpz_mul_2exp(n.get(), n.get(), static_cast<ulong>(shift));
  fmpz_sub(low.get(), n.get(), low.get());
  fmpz_sub(high.get(), n.get(), high.get());
  if (fmpz_sgn(low.get()) != fmpz_sgn(high.get()) || fmpz_is_zero(low.get()) != 0)
    return std::nullopt;
  fmpz_abs(low.get(), low.get());
  fmpz_abs(high.get(), high.get());
  const TwoDigits error(low.get(), shift, places);
  if (!(error == TwoDigits(high.get(), shift, places)) || error.n < 10) return std::nullopt;
  return Decimal{text_of({negative, text, exponent}), error.text()};
}

/// The nearest double, gradual underflow included: MPFR with the exponent range of a double
/// (MPFR manual, mpfr_subnormalize).
double nearest_double(const Rational& x) {
  if (const auto near = static_cast<double>(x); x == 0 || std::isnormal(near)) return near;
  const mpfr_exp_t emin = mpfr_get_emin();
  const mpfr_exp_t emax = mpfr_get_emax();
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  flint::Mpq exact;
  fmpq_get_mpq(exact.get(), x.raw());
  int inexact = mpfr_set_q(value, exact.get(), MPFR_RNDN);
  inexact = mpfr_subnormalize(value, inexact, MPFR_RNDN);
  const double result = mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  mpfr_set_emin(emin);
  mpfr_set_emax(emax);
  return result == 0 ? 0.0 : result;  // one zero, the positive one
}

}  // namespace

std::optional<double> common_double(const RealBall& x) {
  flint::Arb low;  // its middle, and that of high
  flint::Arb high;
  arb_get_interval_arf(arb_midref(low.get()), arb_midref(high.get()), x.raw(), ARF_PREC_EXACT);
  const double rounded = arf_get_d(arb_midref(low.get()), ARF_RND_NEAR);
  if (rounded != arf_get_d(arb_midref(high.get()), ARF_RND_NEAR)) return std::nullopt;
  return rounded == 0 ? 0.0 : rounded;
}

double round_to_double(const Real& x, PrecisionLimit limit) {
  if (x.exact()) return nearest_double(*x.exact());
  if (x.quick())
    if (const auto rounded = common_double(*x.quick())) return *rounded;
  return ziv(x, 53, limit, [](const RealBall& ball) { return common_double(ball); });
}

namespace {

// n − high·d is a double where high = fl(n/d): n and high·d agree in their leading bits.
NearNumber near_quotient(double n, double d) {
  const double high = n / d;
  const DoubleDouble product = two_product(split_factor(high), split_factor(d));
  const double low = ((n - product.high) - product.low) / d;
  return {{high, low}, std::abs(low) * 0x1p-52};
}

}  // namespace

NearNumber near_number(const Rational& x) {
  constexpr long largest = 1L << 53;
  const fmpz n = *fmpq_numref(x.raw());
  const fmpz d = *fmpq_denref(x.raw());
  if (!COEFF_IS_MPZ(n) && !COEFF_IS_MPZ(d) && std::abs(n) <= largest && d <= largest)
    return rounding_to_nearest(
        [&] { return near_quotient(static_cast<double>(n), static_cast<double>(d)); });
  const double high = nearest_double(x);
  if (!std::isfinite(high)) return {{high, 0}, std::numeric_limits<double>::infinity()};
  const double low = nearest_double(Rational(x - exact_rational(high)));
  return {{high, low}, std::abs(low) * 0x1p-52 + 0x1p-1073};
}

void round_to_mpfr(mpfr_t target, const Real& x, PrecisionLimit limit) {
  const auto bits = static_cast<long>(mpfr_get_prec(target));
  // A significand of so many bits is a rational number.
  const auto round = [&](const Rational& exact) {
    flint::Mpq value;
    fmpq_get_mpq(value.get(), exact.raw());
    mpfr_set_q(target, value.get(), MPFR_RNDN);
    mpfr_get_q(value.get(), target);
    Rational rounded;
    fmpq_set_mpq(rounded.raw(), value.get());
    return rounded;
  };
  if (x.exact())
    round(*x.exact());
  else
    round(ziv(x, bits, limit, [&](const RealBall& ball) { return common(ball, round); }));
}

Decimal round_to_decimal(const Real& x, long digits, PrecisionLimit limit) {
  if (digits < 1)
    throw DomainError(
        fmt::format("round_to_decimal: {} digits are asked for, at least 1 is needed", digits));
  const auto bits = static_cast<long>(std::ceil(static_cast<double>(digits) * std::log2(10.0)));
  const auto round = [digits](const Rational& exact) { return round_digits(exact, digits); };
  if (x.exact()) {
    const Digits rounded = round(*x.exact());
    return {text_of(rounded), upper_bound_text(abs(exact_value(rounded) - *x.exact()))};
  }
  if (x.quick())
    if (auto decided = decided_decimal(*x.quick(), digits)) return *std::move(decided);
  RealBall last;
  const Digits rounded = ziv(x, bits, limit, [&](const RealBall& ball) {
    last = ball;
    return common(ball, round);
  });
  const Rational value = exact_value(rounded);
  const auto error = std::max<Rational>(abs(value - last.lower()), abs(value - last.upper()));
  return {text_of(rounded), upper_bound_text(error)};
}

namespace {

std::string bound_text(const Rational& x, long digits, bool up) {
  if (x == 0) return "0";
  long e = decimal_exponent(x);
  const Rational scaled = x * power_of_ten(digits - 1 - e);
  Integer n = numerator(scaled) / denominator(scaled);
  if (up && Rational(n) < scaled) ++n;
  std::string text = n.str();
  if (static_cast<long>(text.size()) > digits) {  // 99.5 became 100
    text.pop_back();
    ++e;
  }
  const bool is_positional = digits > 2 && e >= -3 && e < digits - 1;
  if (is_positional && e >= 0) return text.insert(static_cast<std::size_t>(e) + 1, ".");
  if (is_positional) return "0." + std::string(static_cast<std::size_t>(-e - 1), '0') + text;
  if (digits > 1) text.insert(1, ".");
  return fmt::format("{}e{}", text, e);
}

}  // namespace

std::string upper_bound_text(const Rational& x, long digits) { return bound_text(x, digits, true); }
std::string lower_bound_text(const Rational& x, long digits) {
  return bound_text(x, digits, false);
}

std::ostream& operator<<(std::ostream& out, const Decimal& x) { return out << x.value; }

Integer round_to_places(const Real& x, long places, PrecisionLimit limit) {
  const Rational unit = power_of_ten(places);
  const auto nearest = [&unit](const Rational& exact) -> Integer {
    const Integer size = nearest_integer(abs(exact) * unit);
    return exact < 0 ? Integer(-size) : size;
  };
  if (x.exact()) return nearest(*x.exact());
  return ziv(x, 10 * places / 3 + 16, limit,
             [&](const RealBall& ball) { return common(ball, nearest); });
}

std::string fixed_point_text(const Integer& n, long places) {
  std::string digits = (n < 0 ? Integer(-n) : n).str();
  const auto count = static_cast<std::size_t>(places);
  if (digits.size() <= count) digits.insert(0, count + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - count, ".");
  return n < 0 ? "-" + digits : digits;
}

}  // namespace phrame
