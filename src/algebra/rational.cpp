#include "phrame/algebra/rational.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "phrame/algebra/error.hpp"

namespace phrame {
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

Integer power_of(unsigned base, long exponent) {
  return boost::multiprecision::pow(Integer(base), static_cast<unsigned>(exponent));
}

Integer integer_of(const std::string& digits, int base) {
  Integer value;
  mpz_set_str(value.backend().data(), digits.c_str(), base);
  return value;
}

std::optional<Rational> scan(std::string_view text) {
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
    const Integer denominator = integer_of(below, 10);
    if (denominator == 0) return std::nullopt;
    value = Rational(integer_of(digits, 10), denominator);
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
    const unsigned base = hexadecimal ? 2 : 10;
    value = integer_of(digits, hexadecimal ? 16 : 10);
    if (exponent >= 0)
      value *= Rational(power_of(base, exponent));
    else
      value /= Rational(power_of(base, -exponent));
  }
  if (!in.done()) return std::nullopt;
  return negative ? Rational(-value) : value;
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
  Rational value;
  mpq_set_d(value.backend().data(), x);
  return value;
}

std::string to_string(const Rational& x) { return x.str(); }

std::optional<Rational> square_root(const Rational& x) {
  if (x < 0) return std::nullopt;
  const Integer n = sqrt(Integer(numerator(x)));
  const Integer d = sqrt(Integer(denominator(x)));
  const Rational root(n, d);
  return root * root == x ? std::optional(root) : std::nullopt;
}

void assign(fmpq_t target, const Rational& source) {
  fmpq_set_mpq(target, source.backend().data());
}

Rational to_rational(const fmpq_t source) {
  Rational value;
  fmpq_get_mpq(value.backend().data(), source);
  return value;
}

Rational to_rational(const fmpz_t source) {
  Integer value;
  fmpz_get_mpz(value.backend().data(), source);
  return Rational(value);
}

}  // namespace phrame
