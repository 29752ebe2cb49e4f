#pragma once
#include <string>

#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// An angle known exactly: π·half_turns + radians, a rational number only where half_turns = 0.
struct Angle {
  Rational half_turns;  ///< the multiple of π
  Rational radians;     ///< what is added to it

  /// That many radians.
  Angle(Rational in_radians = 0)  // NOLINT(google-explicit-constructor)
      : radians(std::move(in_radians)) {}
  /// π·times_pi + in_radians.
  Angle(Rational times_pi, Rational in_radians)
      : half_turns(std::move(times_pi)), radians(std::move(in_radians)) {}
  friend bool operator==(const Angle&, const Angle&) = default;
};

/// The angle as a real number; exact where it is rational.
PHRAME_API Real to_real(const Angle& angle);

/// "1/3", "pi/4", "-31pi/40", "1/3 + pi/4".
PHRAME_API std::string to_string(const Angle& angle);
/// Writes to_string(angle).
PHRAME_API std::ostream& operator<<(std::ostream& out, const Angle& angle);

}  // namespace phrame
