#pragma once
#include <string>

#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// A curve/1 file that read_curve reads as the same curve, in the power basis.
std::string write_curve(const NamedCurve& named);

}  // namespace phrame
