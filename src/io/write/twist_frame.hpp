#pragma once
#include <string>

#include "phrame/answer/twist_frame.hpp"
#include "phrame/io/write/field.hpp"

namespace phrame::inline v0 {

/// A number with its relation: "= 0", "≈ 0.5".
Value compared_value(const Decimal& x);

std::string to_text(const TwistFrameAnswer& answer);
std::string to_latex(const TwistFrameAnswer& answer);
/// The pieces, in JSON only, and what holds of all of them.
Fields fields(const TwistFrameAnswer& answer);

}  // namespace phrame
