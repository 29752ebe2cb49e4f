#include "phrame/io/write/exact_form.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/ph/curve/hodograph_fraction.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

std::string exact_form(const HodographFraction& hodograph, const Vector<Rational>& start) {
  const auto& [derivative, over] = hodograph;
  std::string text;
  const auto add = [&text](const char* name, const auto& numbers) {
    text += name;
    for (const Rational& x : numbers) text += " " + to_string(x);
    text += "\n";
  };
  constexpr std::array names{"dx", "dy", "dz"};
  for (std::size_t k = 0; k < names.size(); ++k) add(names[k], derivative[k].coefficients());
  if (!over.is_constant()) add("over", over.coefficients());
  add("start", start);
  return text;
}

}  // namespace

std::string exact_form(const Curve& curve) {
  return exact_form(hodograph_fraction(curve), curve.start());
}

std::string exact_form(const FormulaSegment& curve) {
  std::string text;
  const auto add = [&text](const char* key, const Formula& f) {
    text += fmt::format("{} {}\n", key, full_text(f, "s"));
  };
  add("x", curve.position[0]);
  add("y", curve.position[1]);
  add("z", curve.position[2]);
  add("from", curve.from);
  add("to", curve.to);
  return text;
}

std::string exact_form(const Vector<Polynomial>& position, const Polynomial& weight) {
  return exact_form(hodograph_fraction(position, weight), 1 / weight(0) * evaluate(position, 0));
}

}  // namespace phrame
