#pragma once
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "phrame/algebra/flint.hpp"

namespace phrame {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Always in lowest terms with a positive denominator.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// The longest number text that parse_rational accepts, in characters.
inline constexpr std::size_t max_number_length = 100'000;
/// The largest |exponent| it accepts: decimal for "1e9", binary for "0x1p9".
inline constexpr long max_number_exponent = 100'000;

/// The exact value of "3/7", "-2", "0.9515", "1e-3", ".5" or the hexadecimal "0x1.8p-3".
/// Throws InputError (no place, the reason quotes the text) on anything else: "1/0", "nan", "".
Rational parse_rational(std::string_view text);

/// The exact dyadic value of a double. Throws DomainError for NaN and infinities.
Rational exact_rational(double x);

/// "3/7", "-2".
std::string to_string(const Rational& x);

/// `text` as a one-line message can carry it: cut to `limit` bytes, control characters shown as
/// '?'.
std::string abbreviated(std::string_view text, std::size_t limit = 40);

/// √x ≥ 0 where it is rational; no value where it is not, or x < 0.
std::optional<Rational> square_root(const Rational& x);

/// Between Boost's and FLINT's rationals.
void assign(fmpq_t target, const Rational& source);
Rational to_rational(const fmpq_t source);
Rational to_rational(const fmpz_t source);

}  // namespace phrame
