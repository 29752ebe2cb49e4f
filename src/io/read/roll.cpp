#include "phrame/io/read/roll.hpp"

#include <string>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/angle.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {

Roll parse_roll(std::string_view text) {
  if (text.find(',') != std::string_view::npos) {
    std::vector<Angle> angles;
    for (std::size_t at = 0; at <= text.size();) {
      const auto end = std::min(text.find(',', at), text.size());
      angles.push_back(parse_angle(trimmed(text.substr(at, end - at))));
      at = end + 1;
    }
    return Roll(angles);
  }
  try {
    const Angle angle = parse_angle(text);
    return Roll::Piece{RationalFunction(Polynomial{angle.half_turns}),
                       RationalFunction(Polynomial{angle.radians})};
  } catch (const InputError&) {
    // It is no constant, or what follows tells why it is none.
  }
  const bool are_degrees = text.ends_with("deg");
  const std::string formula(trimmed(are_degrees ? text.substr(0, text.size() - 3) : text));
  const RationalFunction f = parse_expression(formula, "t").value;
  if (!are_degrees) return Roll::Piece{RationalFunction(), f};
  return Roll::Piece{RationalFunction(Polynomial{Rational(1, 180)}) * f, RationalFunction()};
}

}  // namespace phrame
