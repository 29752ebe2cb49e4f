#pragma once
#include "phrame/io/write/json_text.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// How f₂(0) of a LeastRotation is found: "the least rotation that takes the x axis to e₁ takes the
/// y axis to f₂(0), which is then turned about e₁ by pi/4"; in plain letters for sources.
std::string to_sentence(const LeastRotation& start, bool is_plain = false);

/// The same of any start, for files of other programs, in ASCII: "f2 at
/// the start is along [0, 0, 1], projected to the normal plane". An angle is to e2 of the frame of
/// v = `up`, or of the Euler–Rodrigues frame.
std::string start_comment(const FrameStart& start, const std::optional<Vector<Rational>>& up);

/// Adds "start": "least rotation" and "start_turn", or "start_normal"; nothing for an angle to the
/// reference frame, which is "theta0".
void add_start(JsonOutput& json, const FrameStart& start);

}  // namespace phrame
