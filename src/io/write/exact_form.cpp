#include "phrame/io/write/exact_form.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/ph/curve/hodograph_fraction.hpp"

namespace phrame::inline v0 {

std::string exact_form(const Curve& curve) {
  const auto& [derivative, over] = hodograph_fraction(curve);
  std::string text;
  const auto add = [&text](const char* name, const auto& numbers) {
    text += name;
    for (const Rational& x : numbers) text += " " + to_string(x);
    text += "\n";
  };
  constexpr std::array names{"dx", "dy", "dz"};
  for (std::size_t k = 0; k < names.size(); ++k) add(names[k], derivative[k].coefficients());
  if (!over.is_constant()) add("over", over.coefficients());
  add("start", curve.start());
  return text;
}

}  // namespace phrame
