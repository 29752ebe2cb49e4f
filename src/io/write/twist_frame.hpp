#pragma once
#include <string>

#include "phrame/answer/twist_frame.hpp"

namespace phrame {

std::string to_text(const TwistFrameAnswer& answer);

}  // namespace phrame
