#include "phrame/algebra/as_written.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long longest_decimal = 40;

/// The digits of x where it has so few: "0.0001", and "1e-9" where there were more zeros.
std::string finite_decimal(const Rational& x) {
  const std::string sign = x < 0 ? "-" : "";
  const Integer scaled = numerator(Rational(abs(x) * power_of_ten(longest_decimal)));
  std::string digits = scaled.str();
  const long below = longest_decimal - static_cast<long>(digits.size());  // zeros after the point
  if (below > 3) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.size() > 1) digits.insert(1, ".");
    return fmt::format("{}{}e-{}", sign, digits, below + 1);
  }
  if (below >= 0) digits.insert(0, static_cast<std::size_t>(below) + 1, '0');
  digits.insert(digits.size() - static_cast<std::size_t>(longest_decimal), ".");
  return sign + digits.substr(0, digits.find_last_not_of('0') + 1);
}

/// The shortest text that is read as this double.
std::string shortest(double x) {
  std::string text = fmt::format("{}", x);
  if (const auto e = text.find("e-0"); e != std::string::npos) text.erase(e + 2, 1);
  return text;
}

}  // namespace

std::string as_written(const Rational& x) {
  const Integer d = denominator(x);
  constexpr long short_denominator = 100;
  if (d > short_denominator) {
    if (const double near = round_to_double(x); std::isfinite(near) && exact_rational(near) == x)
      return shortest(near);
    if (denominator(Rational(x * power_of_ten(longest_decimal))) == 1)
      return abbreviated(finite_decimal(x));
  }
  return abbreviated(x.str());
}

bool is_rounded(const Rational& x, const Real& end) {
  const double near = round_to_double(x);
  return std::isnormal(near) && near == round_to_double(end);
}

}  // namespace phrame
