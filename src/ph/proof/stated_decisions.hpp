#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

/// A point of [0, 1] as a certificate states it: the only root of the polynomial in the interval,
/// which is a point for a rational number and else open.
struct StatedPoint {
  Polynomial polynomial;  ///< irreducible where `certify` states it
  Interval interval;      ///< in which it has one root
  long order;             ///< of the point, as RealRoot has it
  friend bool operator==(const StatedPoint&, const StatedPoint&) = default;
};

/// The answers of `classify` as a certificate states them. Where the answer is a witness, none
/// means no.
struct StatedDecisions {
  bool regular;                            ///< is there no cusp?
  std::vector<StatedPoint> cusps;          ///< on [0, 1]
  bool has_inflections;                    ///< has it any on [0, 1]?
  std::vector<StatedPoint> inflections;    ///< on [0, 1]
  std::optional<Vector<Rational>> line;    ///< its direction
  std::optional<Vector<Rational>> normal;  ///< of its plane
  /// The tangent's constant angle to an axis.
  struct Helix {
    Vector<Rational> axis;    ///< not 0
    Rational cosine_squared;  ///< of the angle
    friend bool operator==(const Helix&, const Helix&) = default;
  };
  std::optional<Helix> helix;                        ///< if it is one, and not plane
  std::optional<DoublePh> double_ph;                 ///< if it is one
  bool primitive;                                    ///< is the content constant?
  Polynomial content;                                ///< gcd(x′, y′, z′)
  bool erf_is_rmf;                                   ///< is h = 0?
  std::optional<GaussianPolynomial> rational_frame;  ///< w, θ = 2·arg w + constant
  bool erf_monotone;  ///< does the Euler–Rodrigues frame turn in one sense?
  /// @{ As in ErfTurning.
  std::vector<StatedPoint> zeros_of_h;
  std::vector<StatedPoint> extrema;
  /// @}
  friend bool operator==(const StatedDecisions&, const StatedDecisions&) = default;
};

}  // namespace phrame
