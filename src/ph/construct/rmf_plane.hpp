#pragma once
#include <optional>

#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/exact_fit.hpp"

namespace phrame::inline v0 {

// Curves between parallel tangents: every A = Q·(u + sν), u and s real and ν one vector of j and k,
// is plane and has h ≡ 0.

/// A curve from A = λ₀Q to A = ±λ₁Q, not both λ 0.
struct ParallelEnds {
  RationalQuaternion q;
  Rational at_start;  ///< λ₀
  Rational at_end;    ///< λ₁
};

/// The plane quintic r′ = A i A* with these ends that is nearly displaced by so much, of the four
/// that there are that of least energy. Its free numbers are multiples of 2^−places. Where the end
/// is to be met exactly, by a multiplier, it is in a plane with the displacement, and what is
/// across has as many bits more as it is small.
ExactFit plane_between(const ParallelEnds& ends, const Vector<Rational>& displacement, long places,
                       PointRule rule = PointRule::near);

/// The straight line with A = Q, f from λ₀² to λ₁², quadratic, that is nearly displaced by so much
/// in its direction. No value where f would not be positive between its ends.
std::optional<ExactFit> line_between(const ParallelEnds& ends, const Vector<Rational>& displacement,
                                     long places);

}  // namespace phrame
