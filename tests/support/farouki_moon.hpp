#pragma once
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "phrame/ph/curve/curve.hpp"
#include "support/data.hpp"

namespace phrame::inline v0::test {

/// tests/data/farouki-moon-2018.json: what is known of the examples "example1", "example2" and
/// "example3" of [Farouki, Moon 2018].
inline const nlohmann::json& farouki_moon() {
  static const auto data = [] {
    std::ifstream file(test::data("/farouki-moon-2018.json"));
    return nlohmann::json::parse(file);
  }();
  return data;
}

inline Rational number(const nlohmann::json& text) {
  return parse_rational(text.get<std::string>());
}

/// The curve with the Bernstein coefficients A₀, A₁, … of its preimage under the key A.
inline Curve curve_of(const nlohmann::json& example) {
  std::array<std::vector<Rational>, 4> lists;
  for (const auto& a : example["A"])
    for (std::size_t k = 0; k < 4; ++k) lists[k].push_back(number(a[k]));
  return Curve({from_bernstein(lists[0]), from_bernstein(lists[1]), from_bernstein(lists[2]),
                from_bernstein(lists[3])});
}

}  // namespace phrame::test
