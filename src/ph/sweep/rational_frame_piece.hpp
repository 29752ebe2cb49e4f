#pragma once
#include <vector>

#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/frame/rational_frame.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::inline v0 {

/// A rational frame along a part of a path, the Euler–Rodrigues frame of a preimage of its own.
struct RationalFramePiece {
  std::size_t segment;  ///< of the path
  Rational from;        ///< the parameter of the segment at s = 0; it grows in proportion to s
  Rational to;          ///< at s = 1
  QuaternionPolynomial preimage;  ///< in s, without a zero on [0, 1]
};

/// c ∈ ℚ(i) with 2·arg c = arg z, where there is one: where |z| is rational. Requires z ≠ 0.
std::optional<GaussianRational> half_turn_of(const GaussianRational& z);

/// The rotation-minimizing frame of a path, continuous through the joints. Throws DomainError where
/// it is not rational on a segment, saying which, why and where; and where it starts at an angle
/// θ₀ for which e^{iθ₀} is not rational.
std::vector<RationalFramePiece> rational_rmf(const PhPath& path, const FrameStart& start);

/// Where a frame begins and ends: f₂ = cos θ e₂ + sin θ e₃ of the Euler–Rodrigues frame.
struct FrameEnds {
  FrameAngle from;               ///< θ at the start
  std::optional<FrameAngle> to;  ///< θ at the end; none: a closed path, it ends as it starts
};

/// A rational frame of minimal twist, with fractions for the coefficients of its w: multiples of
/// 2^−bits next to them. It is a frame exactly, continuous through the joints; f₂ is as the ends
/// say, exactly where `ends` has rational e^{iθ}, else within 2^(4 − bits). Throws Undecided where
/// the fractions change too much, near a zero of w.
std::vector<RationalFramePiece> rational_mtf(const PhPath& path, const TwistFrame& frame,
                                             const FrameEnds& ends, long bits);

/// Does a path that is closed with its tangent have the same frame at both ends?
bool is_closed(const std::vector<RationalFramePiece>& frames);

}  // namespace phrame
