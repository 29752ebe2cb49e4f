#pragma once
#include <string>

#include "phrame/ph/curve/rational_curve.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// A curve as a text that depends on nothing but the curve, r′ and r(0): docs/certificate.md. Two
/// curves are equal, whatever their preimages, where these are.
std::string exact_form(const Curve& curve);
/// The same of r = X/W, W(0) ≠ 0, that is not a single point.
std::string exact_form(const Vector<Polynomial>& position, const Polynomial& weight);
/// The same of a curve by formulas in canonical form: curves that are equal but for how their
/// formulas are written have others.
std::string exact_form(const FormulaSegment& curve);

}  // namespace phrame
