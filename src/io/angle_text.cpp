#include "phrame/io/angle_text.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// "", "-", "31", "5/8*": what stands before π.
Rational factor(std::string_view text) {
  const bool is_product = text.ends_with('*');
  if (is_product) text.remove_suffix(1);
  if (!is_product && (text.empty() || text == "+")) return 1;
  if (!is_product && (text == "-" || text == "−")) return -1;
  return parse_rational(text);
}

/// "" or "/40": what stands behind it.
Rational divisor(std::string_view text) {
  if (text.empty()) return 1;
  if (text.front() != '/') throw InputError("it may be followed by a divisor only");
  const Rational d = parse_rational(text.substr(1));
  if (d == 0) throw InputError("the divisor is 0");
  return d;
}

}  // namespace

FrameAngle parse_angle(std::string_view text) {
  for (const std::string_view name : {"pi", "π"}) {
    const std::size_t at = text.find(name);
    if (at == std::string_view::npos) continue;
    try {
      return {factor(text.substr(0, at)) / divisor(text.substr(at + name.size())), 0};
    } catch (const InputError&) {
      throw InputError("\"" + abbreviated(text) +
                       "\" is not an angle such as pi/8, -31pi/40, 5/8*pi or 0.3927");
    }
  }
  return {0, parse_rational(text)};
}

}  // namespace phrame
