#pragma once
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"

namespace phrame::inline v0::test {

/// ∫κ² ds to 26 bits, or infinite.
inline double energy_of(const Curve& curve) {
  const auto energy = proved_energy(curve);
  return energy ? round_to_double(energy->midpoint()) : HUGE_VAL;
}

}  // namespace phrame::test
