#pragma once
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// How the ERF turns about the tangent on [0, 1]: by ω₁ = 2h/(fσ²) per arc length, up to the sign
/// of f. Cusps are left out.
struct ErfTurning {
  std::vector<RealRoot> zeros;    ///< of h/σ: the turning is reversed at those of odd order
  std::vector<RealRoot> extrema;  ///< of ω₁: for f = 1 the odd zeros of σh′ − 2σ′h
  bool is_monotone;               ///< it is reversed nowhere in (0, 1)
};
/// Decided exactly. Cost: the factorization of h and of the numerator of ω₁′.
PHRAME_API ErfTurning erf_turning(const Curve& curve);

}  // namespace phrame
