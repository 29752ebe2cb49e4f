#pragma once
#include <iosfwd>
#include <optional>
#include <string>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// An exact angle of a frame: π·half_turns + radians + arg direction.
struct FrameAngle {
  Rational half_turns;               ///< the multiple of π
  Rational radians;                  ///< what is added to it
  GaussianRational direction{1, 0};  ///< re > 0, or a positive multiple of i

  FrameAngle() = default;  ///< 0
  /// π·times_pi + in_radians + arg z.
  FrameAngle(Rational times_pi, Rational in_radians, GaussianRational z = {1, 0})
      : half_turns(std::move(times_pi)), radians(std::move(in_radians)), direction(std::move(z)) {}
  /// The same angle.
  FrameAngle(const Angle& angle)  // NOLINT(google-explicit-constructor)
      : FrameAngle(angle.half_turns, angle.radians) {}
  /// An angle in radians.
  FrameAngle(Rational in_radians)  // NOLINT(google-explicit-constructor)
      : FrameAngle(0, std::move(in_radians)) {}
  friend bool operator==(const FrameAngle&, const FrameAngle&) = default;
};

/// The principal argument of z ≠ 0, in (−π, π].
PHRAME_API FrameAngle angle_of(const GaussianRational& z);

/// The angle over π where that is rational; no value where it is not: decided exactly.
PHRAME_API std::optional<Rational> over_pi(const FrameAngle& angle);

/// @{ The difference b − a and the sum; whole turns count.
PHRAME_API FrameAngle difference(const FrameAngle& b, const FrameAngle& a);
PHRAME_API FrameAngle operator+(const FrameAngle& a, const FrameAngle& b);
/// @}

/// The polynomial that goes straight from 1 at t = 0 to z at t = 1, not through 0, so that its
/// argument turns by arg z. z is that of a FrameAngle.
PHRAME_API GaussianPolynomial path_to(const GaussianRational& z);

/// z ∈ ℚ(i) whose argument is the angle, up to whole turns; no value where there is none: decided
/// exactly.
PHRAME_API std::optional<GaussianRational> direction_of(const FrameAngle& angle);

/// The angle as a number: exact where it is rational, else known to be irrational. Decided exactly.
PHRAME_API Real to_real(const FrameAngle& angle);

/// The angle at which a frame starts: its value, and the exact angle where that is known.
struct StartAngle {
  std::optional<FrameAngle> exact;  ///< no value where only enclosures are known
  Real value;                       ///< the angle

  StartAngle() : StartAngle(FrameAngle()) {}  ///< 0
  /// @{ This angle.
  StartAngle(const FrameAngle& angle)  // NOLINT(google-explicit-constructor)
      : exact(angle), value(to_real(angle)) {}
  StartAngle(const Angle& angle)  // NOLINT(google-explicit-constructor)
      : StartAngle(FrameAngle(angle)) {}
  StartAngle(const Rational& in_radians)  // NOLINT(google-explicit-constructor)
      : StartAngle(FrameAngle(in_radians)) {}
  StartAngle(Real angle)  // NOLINT(google-explicit-constructor)
      : value(std::move(angle)) {}
  /// @}
};

/// An angle as it is written: the sum of an Angle and, where there is a z, the principal value of
/// arg z.
struct AngleTerms {
  Angle angle;                       ///< π·half_turns + radians
  std::optional<GaussianInteger> z;  ///< the number whose argument is added
};
PHRAME_API AngleTerms terms(const FrameAngle& angle);  ///< as few terms as possible

/// "pi/4", "atan2(4, 3)", "1/3 + atan2(-1, 2)".
PHRAME_API std::string to_string(const FrameAngle& angle);
/// Writes to_string(angle).
PHRAME_API std::ostream& operator<<(std::ostream& out, const FrameAngle& angle);

}  // namespace phrame
