#include "phrame/ph/along/frame_angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {

FrameAngle angle_of(const GaussianRational& z) {
  if (z.re == 0 && z.im == 0) throw DomainError("angle_of: 0 has no direction");
  if (z.re > 0 || (z.re == 0 && z.im > 0)) return {0, 0, z};
  return {z.im >= 0 && z.re < 0 ? 1 : -1, 0, {-z.re, -z.im}};
}

std::optional<Rational> over_pi(const FrameAngle& angle) {
  // A number e^{ia} with rational a ≠ 0 is transcendental (Lindemann), and the only roots of unity
  // z/|z| with z ∈ ℚ(i) are those of order 8 (Niven).
  if (angle.radians != 0) return std::nullopt;
  const auto& [re, im] = angle.direction;
  if (im == 0) return angle.half_turns;
  if (re == 0) return angle.half_turns + Rational(1, 2);
  if (re == abs(im)) return angle.half_turns + Rational(im > 0 ? 1 : -1, 4);
  return std::nullopt;
}

FrameAngle difference(const FrameAngle& b, const FrameAngle& a) {
  // The two arguments are in (−π/2, π/2], so that their difference is principal.
  FrameAngle angle = angle_of(b.direction * conjugate(a.direction));
  angle.half_turns += b.half_turns - a.half_turns;
  angle.radians = b.radians - a.radians;
  return angle;
}

FrameAngle operator+(const FrameAngle& a, const FrameAngle& b) {
  // Here, too, the sum of the two arguments is principal.
  FrameAngle sum = angle_of(a.direction * b.direction);
  sum.half_turns += a.half_turns + b.half_turns;
  sum.radians = a.radians + b.radians;
  return sum;
}

GaussianPolynomial path_to(const GaussianRational& z) {
  if (z.im == 0) return {{1}, {}};
  return {Polynomial{1, z.re - 1}, Polynomial{0, z.im}};
}

// By Niven, as above: where the multiple of π has another denominator, e^{iπ·half_turns} is not
// z/|z| for a z ∈ ℚ(i).
std::optional<GaussianRational> direction_of(const FrameAngle& angle) {
  const Rational eighths = 4 * angle.half_turns;
  if (angle.radians != 0 || denominator(eighths) != 1) return std::nullopt;
  GaussianRational z = angle.direction;
  const Integer turns = floor(eighths / 8);
  for (Rational k = eighths - Rational(8 * turns); k > 0; k -= 1) z = z * GaussianRational{1, 1};
  return z;
}

// π·half_turns + arg z = −i·log of an algebraic number is 0 or transcendental (Lindemann).
Real to_real(const FrameAngle& angle) {
  const auto& [half_turns, radians, z] = angle;
  if (over_pi({half_turns, 0, z}) == Rational(0)) return radians;
  // Whole turns in half_turns may cancel radians, or nearly.
  const auto size = [](const Rational& x) {
    return x == 0 ? 0 : std::max(0L, binary_exponent(abs(x)));
  };
  const long guard = 8 + std::max(size(half_turns), size(radians));
  const auto enclosure = [angle, guard](long bits) {
    const auto& [times_pi, in_radians, direction] = angle;
    const long more = bits + guard;
    return add(
        add(multiply(RealBall(times_pi, more), pi(more), more), RealBall(in_radians, more), more),
        argument(direction.re, direction.im, more), more);
  };
  const auto rest = [angle] {
    const auto& [re, im] = angle.direction;
    return AlgebraicAngle(angle.half_turns) + AlgebraicAngle::argument(re, im, 1);
  };
  return {enclosure,
          {true, bits_of(half_turns) + bits_of(radians) + bits_of(z.re) + bits_of(z.im),
           std::make_shared<const AngleForm>(AngleForm{radians, rest})}};
}

AngleTerms terms(const FrameAngle& angle) {
  const auto& [half_turns, radians, z] = angle;
  if (const auto p = over_pi({half_turns, 0, z})) return {{*p, radians}, std::nullopt};
  if (abs(half_turns) == 1)
    if (const GaussianRational turned{-z.re, -z.im}; angle_of(turned).half_turns == half_turns)
      return {radians, primitive_multiple(turned)};
  return {{half_turns, radians}, primitive_multiple(z)};
}

std::string to_string(const FrameAngle& angle) {
  const auto [plain, z] = terms(angle);
  if (!z) return to_string(plain);
  const std::string argument = fmt::format("atan2({}, {})", z->im.str(), z->re.str());
  return plain == Angle() ? argument : to_string(plain) + " + " + argument;
}

std::ostream& operator<<(std::ostream& out, const FrameAngle& angle) {
  return out << to_string(angle);
}

}  // namespace phrame
