#include "phrame/ph/curve/segment.hpp"

#include "phrame/algebra/shared.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

struct PhSegment::State {
  Curve curve;
  Lazy<RationalCurve> by_positions{};
  Lazy<QuaternionPolynomial> primitive{};
  Lazy<GaussianPolynomial> bend{};
};

PhSegment::PhSegment(Curve curve) : state_(new State{std::move(curve)}) {}

const Curve& PhSegment::curve() const { return state_->curve; }

const RationalCurve& PhSegment::by_positions() const {
  return state_->by_positions.get([this] {
    const RationalCurve curve(numerator(this->curve()), this->curve().weight());
    return sign_after_zero(this->curve().multiplier()) < 0 ? curve.turned_over() : curve;
  });
}

const QuaternionPolynomial& PhSegment::primitive_preimage() const {
  return state_->primitive.get([this] { return without_real_content(curve().preimage()); });
}

const GaussianPolynomial& PhSegment::bend() const {
  return state_->bend.get([this] { return bend_numerator(primitive_preimage()); });
}

const Curve* ph_curve(const Segment& segment) {
  const auto* ph = std::get_if<PhSegment>(&segment);
  return ph == nullptr ? nullptr : &ph->curve();
}

const RationalCurve* rational_curve(const Segment& segment) {
  if (const auto* ph = std::get_if<PhSegment>(&segment)) return &ph->by_positions();
  return std::get_if<RationalCurve>(&segment);
}

namespace {

/// The multiplier of a polynomial or rational curve; null of formulas, which have no cusps.
const Polynomial* multiplier_of(const Segment& segment) {
  if (const Curve* ph = ph_curve(segment)) return &ph->multiplier();
  const auto* curve = std::get_if<RationalCurve>(&segment);
  return curve == nullptr ? nullptr : &curve->multiplier();
}

}  // namespace

int orientation(const Segment& segment) {
  const Polynomial* f = multiplier_of(segment);
  return f != nullptr ? sign_after_zero(*f) : std::get<ExpressionCurve>(segment).orientation();
}

int end_orientation(const Segment& segment) {
  const Polynomial* f = multiplier_of(segment);
  return f != nullptr ? sign_before_one(*f) : orientation(segment);
}

Segment turned_over(const Segment& segment) {
  return std::visit([](const auto& curve) -> Segment { return curve.turned_over(); }, segment);
}

}  // namespace phrame
