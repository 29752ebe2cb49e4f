#include "phrame/algebra/as_written.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

constexpr long longest_decimal = 40;

/// The digits of x where it has so few.
std::string finite_decimal(const Rational& x) {
  const Integer scaled = numerator(Rational(x * power_of_ten(longest_decimal)));
  const std::string size = abs(scaled).str();
  const std::string padded =
      std::string(size.size() > longest_decimal ? 0 : longest_decimal + 1 - size.size(), '0') +
      size;
  const std::string whole = padded.substr(0, padded.size() - longest_decimal);
  const std::string rest = padded.substr(padded.size() - longest_decimal);
  return (x < 0 ? "-" : "") + whole + "." + rest.substr(0, rest.find_last_not_of('0') + 1);
}

}  // namespace

std::string as_written(const Rational& x) {
  const Integer d = denominator(x);
  constexpr long short_denominator = 100;
  if (d > short_denominator) {
    if (const double near = round_to_double(x); std::isfinite(near) && exact_rational(near) == x)
      return fmt::format("{}", near);  // the shortest that is read as this double
    if (denominator(Rational(x * power_of_ten(longest_decimal))) == 1)
      return abbreviated(finite_decimal(x));
  }
  return abbreviated(x.str());
}

bool is_rounded(const Rational& x, const Real& end) {
  return round_to_double(x) == round_to_double(end);
}

}  // namespace phrame
