#pragma once
#include <optional>

#include "phrame/ph/curve/segment.hpp"
#include "phrame/ph/frame/frame_deviation.hpp"

namespace phrame::inline v0 {

/// deviation_from() of a frame at t of a PH curve, with θ there to the Euler–Rodrigues frame, in
/// balls throughout: a tenth of the time. No value where a sign, or that a vector or a cosine is 0,
/// is not told from balls of about so many bits; then it is to be decided exactly.
std::optional<FrameDeviation> near_deviation(const PhSegment& segment, const Rational& t,
                                             const RealBall& theta, int side,
                                             const GivenFrame& frame, long bits);

}  // namespace phrame
