#include "phrame/algebra/rational.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/error_free.hpp"
#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {

Rational::Rational(const Integer& n, const Integer& d) {
  if (d == 0) throw DomainError(fmt::format("division of {} by 0", abbreviated(n.str())));
  fmpq_set_fmpz_frac(raw(), n.raw(), d.raw());
}

std::string Rational::str() const {
  const Integer d = denominator(*this);
  return d == 1 ? numerator(*this).str() : numerator(*this).str() + "/" + d.str();
}

Rational::operator double() const {
  // The quotient of two doubles is the nearest one.
  constexpr long largest = 1L << 53;
  const fmpz n = *fmpq_numref(raw());
  const fmpz d = *fmpq_denref(raw());
  if (!COEFF_IS_MPZ(n) && !COEFF_IS_MPZ(d) && std::abs(n) <= largest && d <= largest)
    return rounding_to_nearest([&] { return static_cast<double>(n) / static_cast<double>(d); });
  flint::Mpq x;
  fmpq_get_mpq(x.get(), raw());
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  mpfr_set_q(rounded, x.get(), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

Rational& Rational::operator/=(const Rational& x) {
  if (x == 0) throw DomainError(fmt::format("division of {} by 0", abbreviated(str())));
  fmpq_div(raw(), raw(), x.raw());
  return *this;
}

std::ostream& operator<<(std::ostream& out, const Rational& x) { return out << x.str(); }

Integer floor(const Rational& x) { return floor_quotient(numerator(x), denominator(x)); }

Rational simplest_between(const Rational& a, const Rational& b) {
  return result_of<Rational>(fmpq_simplest_between, a.raw(), b.raw());
}

namespace {

// A hand-written scanner: GMP's own accepts blanks inside numbers, Boost's rejects decimals.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool done() const { return rest_.empty(); }

  bool take(char lower_case) {
    if (rest_.empty() || std::tolower(static_cast<unsigned char>(rest_.front())) != lower_case)
      return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view digits(bool hexadecimal) {
    std::size_t n = 0;
    while (n < rest_.size() && is_digit(rest_[n], hexadecimal)) ++n;
    const auto taken = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return taken;
  }

  bool negative_sign() {
    if (take('-')) return true;
    take('+');
    return false;
  }

  /// A signed decimal integer within the exponent limit.
  std::optional<long> exponent() {
    const bool negative = negative_sign();
    const auto text = digits(false);
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value > max_number_exponent)
      return std::nullopt;
    return negative ? -value : value;
  }

 private:
  static bool is_digit(char c, bool hexadecimal) {
    const auto u = static_cast<unsigned char>(c);
    return hexadecimal ? std::isxdigit(u) != 0 : std::isdigit(u) != 0;
  }

  std::string_view rest_;
};

/// "-12": most numbers are such.
std::optional<long> short_integer(std::string_view text) {
  constexpr std::size_t most_characters = 18;
  long value = 0;
  if (text.empty() || text.size() > most_characters) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Rational> scan(std::string_view text) {
  if (const auto value = short_integer(text)) return *value;
  Scanner in(text);
  const bool negative = in.negative_sign();
  bool hexadecimal = false;
  if (text.find_first_of("xX") != std::string_view::npos) {
    if (!in.take('0') || !in.take('x')) return std::nullopt;
    hexadecimal = true;
  }
  std::string digits(in.digits(hexadecimal));
  Rational value;
  if (!digits.empty() && in.take('/')) {
    const std::string below(in.digits(false));
    if (below.empty() || hexadecimal) return std::nullopt;
    const Integer denominator = Integer(below);
    if (denominator == 0) return std::nullopt;
    value = Rational(Integer(digits), denominator);
  } else {
    long fraction_digits = 0;
    if (in.take('.')) {
      const auto fraction = in.digits(hexadecimal);
      digits += fraction;
      fraction_digits = static_cast<long>(fraction.size());
    }
    if (digits.empty()) return std::nullopt;
    long exponent = 0;
    if (in.take(hexadecimal ? 'p' : 'e')) {
      const auto given = in.exponent();
      if (!given) return std::nullopt;
      exponent = *given;
    }
    exponent -= hexadecimal ? 4 * fraction_digits : fraction_digits;
    const Integer base = hexadecimal ? 2 : 10;
    value = Integer(digits, hexadecimal ? 16 : 10);
    if (exponent >= 0)
      value *= pow(base, static_cast<unsigned long>(exponent));
    else
      value /= pow(base, static_cast<unsigned long>(-exponent));
  }
  if (!in.done()) return std::nullopt;
  return negative ? -value : value;
}

}  // namespace

std::string abbreviated(std::string_view text, std::size_t limit) {
  std::string shown(text.substr(0, limit));
  const auto continues_a_character = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  while (!shown.empty() && continues_a_character(shown.size())) shown.pop_back();
  for (char& c : shown)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '?';
  return text.size() <= limit ? shown : fmt::format("{}… ({} characters)", shown, text.size());
}

Rational parse_rational(std::string_view text) {
  if (text.size() > max_number_length)
    throw InputError(fmt::format("the number {} is longer than {} characters", abbreviated(text),
                                 max_number_length));
  if (auto value = scan(text)) return *std::move(value);
  if (text.find("/0") != std::string_view::npos &&
      text.find_first_not_of("+-0123456789/") == std::string_view::npos)
    throw InputError(fmt::format("\"{}\" divides by zero", abbreviated(text)));
  throw InputError(fmt::format(
      "\"{}\" is not a number: expected something like 3/7, -2, 0.9515, 1e-3 or 0x1.8p-3 "
      "(exponents up to {})",
      abbreviated(text), max_number_exponent));
}

Rational exact_rational(double x) {
  if (!std::isfinite(x))
    throw DomainError(fmt::format("exact_rational: {} is not a real number", x));
  int exponent = 0;
  const auto significand = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(exponent - 53));
  return exponent >= 53 ? Rational(Integer(significand) * power) : Rational(significand, power);
}

std::string to_string(const Rational& x) { return x.str(); }

std::optional<Rational> square_root(const Rational& x) {
  if (x < 0) return std::nullopt;
  const Rational root(sqrt(numerator(x)), sqrt(denominator(x)));
  return root * root == x ? std::optional(root) : std::nullopt;
}

}  // namespace phrame
