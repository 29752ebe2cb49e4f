#pragma once
#include <optional>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// Why the integral of a rate θ′ from 0 to t is exactly 0: θ′(t − τ) = −θ′(τ), or with a shift δ >
/// 0 θ′(τ + δ) = −θ′(τ), t being a multiple of 2δ.
struct Antisymmetry {
  std::optional<Rational> shift;                                               ///< δ
  friend bool operator==(const Antisymmetry&, const Antisymmetry&) = default;  ///< by value
};

}  // namespace phrame
