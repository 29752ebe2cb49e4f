#pragma once
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "support/data.hpp"
#include "support/refusal.hpp"

// The reference values of tests/data, and how a printed decimal is compared with them: exactly.
namespace phrame::inline v0::test {

using Json = nlohmann::json;

inline std::string read_data(const std::string& name) {
  std::ifstream file(data("/" + name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  REQUIRE_FALSE(text.str().empty());
  return text.str();
}

/// Why it is not read as a path; empty where it is.
inline std::string refusal(std::string_view text, const FileReading& reading = {}) {
  return test::refusal_of([&] { read_any_path(text, {}, reading); });
}

inline const Json& farouki_2003() {
  static const Json data = Json::parse(read_data("farouki-2003.json"));
  return data;
}

inline NamedCurve farouki_quintic() {
  const Json curve = {{"phrame", "curve/1"},
                      {"name", "quintic"},
                      {"basis", "bernstein"},
                      {"preimage", farouki_2003()["quintic"]["bernstein"]}};
  return read_curve(curve.dump());
}

/// A = (t + i)(t + j) = t² + ti + tj + k: σ = (t² + 1)², h = 1 − t², so θ = −2t/(t² + 1) to the
/// ERF.
inline NamedCurve rational_angle_curve() {
  return {"rational angle",
          Curve({Polynomial{0, 0, 1}, Polynomial{0, 1}, Polynomial{0, 1}, Polynomial{1}})};
}

/// The curve through the origin along the x axis, A = 1.
inline NamedCurve straight_line() {
  return {"line", Curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial()})};
}

inline Rational rational(const Json& text) { return parse_rational(text.get<std::string>()); }

inline Polynomial polynomial(const Json& ascending) {
  std::vector<Rational> coefficients;
  for (const Json& c : ascending) coefficients.push_back(rational(c));
  return Polynomial(coefficients);
}

inline RationalFunction rational_function(const Json& f) {
  return {polynomial(f["numerator"]), polynomial(f["denominator"])};
}

/// The significant digits of "-0.00120e-7": 3.
inline std::size_t digit_count(const std::string& decimal) {
  std::string digits;
  for (const char c : decimal.substr(0, decimal.find('e')))
    if (c != '-' && c != '.' && !(digits.empty() && c == '0')) digits += c;
  return digits.size();
}

/// The unit of the last of `digits` significant digits of x ≠ 0.
inline Rational last_place(const Rational& x, long digits) {
  long e = 0;
  while (power_of_ten(e) > abs(x)) --e;
  while (power_of_ten(e + 1) <= abs(x)) ++e;
  return power_of_ten(e + 1 - digits);
}

/// `value` has `digits` significant digits and is the truth rounded to them; `radius` bounds the
/// error and is not wasteful. The truth has `known` correct digits.
inline void check_rounded(const std::string& value, const std::string& radius,
                          const std::string& truth, long digits, long known) {
  CAPTURE(value);
  CAPTURE(radius);
  CAPTURE(truth);
  const Rational x = parse_rational(truth);
  if (x == 0) {
    CHECK(value == "0");
    CHECK(radius == "0");
    return;
  }
  CHECK(digit_count(value) == static_cast<std::size_t>(digits));
  const Rational error = abs(parse_rational(value) - x);
  const Rational doubt = last_place(x, known);
  const Rational unit = last_place(x, digits);
  CHECK(error <= unit / 2 + doubt);
  CHECK(error <= parse_rational(radius) + doubt);
  CHECK(parse_rational(radius) <= unit);
}

}  // namespace phrame::test
