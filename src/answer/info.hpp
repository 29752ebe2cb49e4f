#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// What are the length, the twist and the energy of a path?
struct InfoQuery {
  long digits = 17;  ///< of all numbers
};

/// The numbers of a path.
struct InfoAnswer {
  /// A length, exact where it is rational.
  struct Length {
    Real exact;       ///< the number
    Decimal rounded;  ///< where it is irrational
  };
  NamedPath path;               ///< as asked
  Length length;                ///< ∫ |f|σ dt
  std::vector<Length> lengths;  ///< of the segments
  Decimal twist_erf;            ///< ∫ 2h/σ dt, of the continuous Euler–Rodrigues frame
  std::optional<Decimal> bending_energy;  ///< ∫ κ² ds; no value where it is infinite
  std::optional<Decimal> holonomy;        ///< where a spline is closed
  // Of a curve by itself:
  std::vector<RealRoot> cusps;           ///< in [0, 1]
  std::vector<Decimal> erf_inflections;  ///< in (0, 1), where the ERF turns back
  std::vector<Decimal> erf_extrema;      ///< in (0, 1), of its rate about e₁
};

/// Throws Undecided, with the name of what it is, where a number cannot be rounded.
InfoAnswer answer(const NamedPath& path, const InfoQuery& query);

}  // namespace phrame
