#include "phrame/ph/frame/frame_angle.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {

FrameAngle angle_of(const GaussianRational& z) {
  if (z.re == 0 && z.im == 0) throw DomainError("angle_of: 0 has no direction");
  if (z.re > 0 || (z.re == 0 && z.im > 0)) return {0, 0, z};
  return {z.im >= 0 && z.re < 0 ? 1 : -1, 0, {-z.re, -z.im}};
}

FrameAngle angle_of(const Vector<Rational>& v, const Frame<Rational>& frame) {
  const GaussianRational z{dot(v, frame.e2), dot(v, frame.e3)};
  if (z.re == 0 && z.im == 0)
    throw DomainError("the vector " + abbreviated(v) + " has no part in the normal plane");
  return angle_of(z);
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

Real to_real(const FrameAngle& angle) {
  if (angle.half_turns == 0 && angle.direction.im == 0) return angle.radians;
  // Whole turns in half_turns may cancel radians, or nearly.
  const auto size = [](const Rational& x) {
    return x == 0 ? 0 : std::max(0L, binary_exponent(abs(x)));
  };
  const long guard = 8 + std::max(size(angle.half_turns), size(angle.radians));
  const auto enclosure = [angle, guard](long bits) {
    const auto& [half_turns, radians, z] = angle;
    const long more = bits + guard;
    return add(
        add(multiply(RealBall(half_turns, more), pi(more), more), RealBall(radians, more), more),
        argument(z.re, z.im, more), more);
  };
  const auto& [half_turns, radians, z] = angle;
  return {enclosure,
          {false, bits_of(half_turns) + bits_of(radians) + bits_of(z.re) + bits_of(z.im)}};
}

}  // namespace phrame
