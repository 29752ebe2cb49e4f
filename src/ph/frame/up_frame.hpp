#pragma once
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame::inline v0 {

/// The frame of a fixed vector v along a curve with unit tangent e₁, e₂ = v × e₁/|v × e₁| and e₃ =
/// e₁ × e₂: the angle of f in (e₂, e₃), in [−π, π]. All of that where f is not told from −e₂ or
/// from a vector along the tangent, and where v is not told from one.
RealBall angle_to_up(const Vector<Rational>& f, const Vector<Rational>& v,
                     const Vector<RealBall>& e1, long bits);

/// Guesses of v for frames whose f₂ is along v × e₁ or across it, without a promise: by simple
/// numbers first, then by as many digits as doubles have. None where f₂ and f₃ = e₁ × f₂ do not
/// change much.
std::vector<Vector<Rational>> guessed_up_vectors(const std::vector<GivenFrame>& frames,
                                                 const std::vector<FrameDeviation>& deviations);

}  // namespace phrame
