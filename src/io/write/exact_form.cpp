#include "phrame/io/write/exact_form.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

std::string exact_form(const Curve& curve) {
  const Vector<Polynomial> derivative = hodograph(curve);
  constexpr std::array names{"dx", "dy", "dz"};
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += names[k];
    for (const Rational& c : derivative[k].coefficients()) text += " " + to_string(c);
    text += "\n";
  }
  text += "start";
  for (const Rational& x : curve.start()) text += " " + to_string(x);
  return text + "\n";
}

}  // namespace phrame
