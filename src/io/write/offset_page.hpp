#pragma once
#include <string>

#include "phrame/answer/offset_picture.hpp"

namespace phrame::inline v0 {

/// An HTML file with all that it needs, which asks for no other: the path and its offsets, drawn,
/// with marks at cusps, where they meet themselves and where they are cut; lengths and areas; the
/// report. It is made without npm.
std::string to_page(const OffsetAnswer& answer);
/// The same of the axis and its envelope.
std::string to_page(const EnvelopeAnswer& answer);

}  // namespace phrame
