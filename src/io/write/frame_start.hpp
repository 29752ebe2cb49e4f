#pragma once
#include "phrame/io/write/json_text.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

/// How f₂(0) of a LeastRotation is found: "the least rotation that takes the x axis to e₁ takes the
/// y axis to f₂(0), which is then turned about e₁ by pi/4"; in plain letters for sources.
std::string to_sentence(const LeastRotation& start, bool is_plain = false);

/// Adds "start": "least rotation" and "start_turn", or "start_normal"; nothing for an angle to the
/// reference frame, which is "theta0".
void add_start(JsonOutput& json, const FrameStart& start);

}  // namespace phrame
