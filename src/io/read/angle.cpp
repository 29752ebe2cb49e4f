#include "phrame/io/read/angle.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

/// "", "-", "31", "5/8*": what stands before π.
Rational factor(std::string_view text) {
  text = trimmed(text);
  const bool is_product = text.ends_with('*');
  if (is_product) text.remove_suffix(1);
  if (!is_product && (text.empty() || text == "+")) return 1;
  if (!is_product && (text == "-" || text == "−")) return -1;
  return parse_number(text);
}

/// "" or "/40": what stands behind it.
Rational divisor(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return 1;
  if (text.front() != '/') throw InputError("it may be followed by a divisor only");
  const Rational d = parse_rational(trimmed(text.substr(1)));
  if (d == 0) throw InputError("the divisor is 0");
  return d;
}

Angle any_angle(std::string_view text) {
  try {
    if (text.find('/') != text.rfind('/')) throw InputError("it divides twice");
    for (const std::string_view name : {"pi", "π"})
      if (const std::size_t at = text.find(name); at != std::string_view::npos)
        return {factor(text.substr(0, at)) / divisor(text.substr(at + name.size())), 0};
    for (const std::string_view name : {"deg", "°"})
      if (text.ends_with(name))
        return {parse_number(text.substr(0, text.size() - name.size())) / 180, 0};
    return parse_number(text);
  } catch (const InputError&) {
    throw InputError("\"" + abbreviated(text) +
                     "\" is not an angle such as pi/8, -31pi/40, 45deg or, in radians, 0.3927");
  }
}

}  // namespace

Angle parse_angle(std::string_view text) {
  text = trimmed(text);
  const Angle angle = any_angle(text);
  refuse_long_number(angle.half_turns, text);
  refuse_long_number(angle.radians, text);
  return angle;
}

}  // namespace phrame
