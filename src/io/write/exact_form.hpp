#pragma once
#include <string>

#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// A curve as a text that depends on nothing but the curve, r′ and r(0): docs/certificate.md. Two
/// curves are equal, whatever their preimages, where these are.
std::string exact_form(const Curve& curve);
/// The same of r = X/W, W(0) ≠ 0, that is not a single point.
std::string exact_form(const Vector<Polynomial>& position, const Polynomial& weight);

}  // namespace phrame
