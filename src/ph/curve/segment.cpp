#include "phrame/ph/curve/segment.hpp"

namespace phrame {

const RationalCurve& PhSegment::by_positions() const {
  return by_positions_.get([this] {
    const RationalCurve curve(position(this->curve()));
    return sign_after_zero(this->curve().multiplier()) < 0 ? curve.turned_over() : curve;
  });
}

const QuaternionPolynomial& PhSegment::primitive_preimage() const {
  return primitive_.get([this] { return without_real_content(curve().preimage()); });
}

const Curve* ph_curve(const Segment& segment) {
  const auto* ph = std::get_if<PhSegment>(&segment);
  return ph == nullptr ? nullptr : &ph->curve();
}

const RationalCurve* rational_curve(const Segment& segment) {
  if (const auto* ph = std::get_if<PhSegment>(&segment)) return &ph->by_positions();
  return std::get_if<RationalCurve>(&segment);
}

int orientation(const Segment& segment) {
  if (const Curve* ph = ph_curve(segment)) return sign_after_zero(ph->multiplier());
  if (const auto* curve = std::get_if<RationalCurve>(&segment))
    return sign_after_zero(curve->multiplier());
  return std::get<ExpressionCurve>(segment).orientation();
}

}  // namespace phrame
