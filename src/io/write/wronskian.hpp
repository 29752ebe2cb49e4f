#pragma once
#include <string>
#include <utility>
#include <vector>

#include "phrame/answer/wronskian.hpp"

namespace phrame {

/// "one", "torsion-curvature", "speed".
const std::vector<std::pair<std::string, FrameWeight>>& frame_weights();

std::string to_text(const WronskianAnswer& answer);   ///< for reading, Unicode
std::string to_json(const WronskianAnswer& answer);   ///< wronskian/1
std::string to_latex(const WronskianAnswer& answer);  ///< for amsmath and amssymb

}  // namespace phrame
