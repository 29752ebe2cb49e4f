#pragma once
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/rrmf_quintic.hpp"

namespace phrame::inline v0 {

/// Where an RRMF quintic ends and the next one begins.
struct RrmfJoint {
  IntegerQuaternion a;  ///< A there, up to a positive factor: coprime integers
  Integer modulus;      ///< an odd divisor of |a|² ≥ 1, as a rule the whole of it
  Integer root;         ///< root² ≡ −1 modulo that
};

/// Near the direction of d ≠ 0, within some 2^−bits.
RrmfJoint first_joint(const Vector<Rational>& d, long bits);

/// An RRMF quintic of class I from joint to joint.
struct JoinedRrmf {
  Rational size;  ///< A(0) over that of the joint
  RationalQuaternion a1;
  RationalQuaternion a2;
  RrmfJoint end;
};

/// From `start` on, b and τ off by some 2^−bits of |b| and |b|². |a|² of its end is about
/// 2^(4·bits) whatever that of the start is, so that the numbers of a long spline are as long as
/// those at its beginning. Precondition: last_coefficient(x) ≠ 0.
JoinedRrmf joined_rrmf(const RrmfJoint& start, const RrmfQuintic<Rational>& x, long bits);

}  // namespace phrame
