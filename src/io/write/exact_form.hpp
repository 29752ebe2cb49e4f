#pragma once
#include <string>

#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// A curve as a text that depends on nothing but the curve, r′ and r(0): docs/certificate.md. Two
/// curves are equal, whatever their preimages, where these are.
std::string exact_form(const Curve& curve);

}  // namespace phrame
