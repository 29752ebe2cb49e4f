#include "phrame/algebra/angle.hpp"

#include <ostream>

#include "phrame/algebra/algebraic_angle.hpp"

namespace phrame::inline v0 {

Real to_real(const Angle& angle) {
  if (angle.half_turns == 0) return angle.radians;
  const auto enclosure = [angle](long bits) {
    const long more = bits + 8;
    return add(multiply(RealBall(angle.half_turns, more), pi(more), more),
               RealBall(angle.radians, more), more);
  };
  const auto rest = [half_turns = angle.half_turns] { return AlgebraicAngle(half_turns); };
  return {enclosure,
          {true, bits_of(angle.half_turns) + bits_of(angle.radians),
           std::make_shared<const AngleForm>(AngleForm{angle.radians, rest})}};
}

std::string to_string(const Angle& angle) {
  const auto& [half_turns, radians] = angle;
  if (half_turns == 0) return to_string(radians);
  const Integer n(abs(numerator(half_turns)));
  const Integer d(denominator(half_turns));
  const std::string multiple =
      (n == 1 ? "" : to_string(Rational(n))) + "pi" + (d == 1 ? "" : "/" + to_string(Rational(d)));
  if (radians == 0) return (half_turns < 0 ? "-" : "") + multiple;
  return to_string(radians) + (half_turns < 0 ? " - " : " + ") + multiple;
}

std::ostream& operator<<(std::ostream& out, const Angle& angle) { return out << to_string(angle); }

}  // namespace phrame
