#pragma once
#include "phrame/ph/curve/disc_function.hpp"
#include "phrame/ph/curve/expression_curve.hpp"

namespace phrame::inline v0 {

/// A function at one point, where only its value matters: what a DiscFunction is on a disc.
struct PointValue {
  RealBall value;
  long bits = 0;  ///< of what is computed
};

/// @{ The sum, difference and product.
PointValue operator+(const PointValue& a, const PointValue& b);
PointValue operator-(const PointValue& a, const PointValue& b);
PointValue operator*(const PointValue& a, const PointValue& b);
/// @}
/// @{ c, with the bits of `like`.
PointValue constant_like(const PointValue& like, const Rational& c);
PointValue constant_like(const PointValue& like, const RealBall& c);
/// @}

/// A factor of such products, with its root where several need it.
struct PointFactor {
  PointFactor() = default;
  PointFactor(PointValue of) : base(std::move(of)) {}  // NOLINT(google-explicit-constructor)

  PointValue base;
  std::optional<RealBall> root;  ///< √base
};

/// A DiscProduct at one point.
using PointProduct = ProductOfRoots<PointValue, PointFactor>;
/// Its value; not finite where a factor with k < 0 is not kept from 0.
RealBall value(const PointProduct& product);

/// A curve at a point, or on all of a ball, by z, t = middle + half·z: what a CurveJet is around
/// it.
class CurvePoint {
 public:
  using Product = PointProduct;  ///< what an integrand is there

  CurvePoint(const ExpressionCurve& curve, const RealBall& t, const Rational& half, long bits);

  const Vector<PointValue>& first() const { return derivatives_[0]; }   ///< r′
  const Vector<PointValue>& second() const { return derivatives_[1]; }  ///< r″
  const Vector<PointValue>& third() const { return derivatives_[2]; }   ///< r‴
  const PointFactor& square() const { return square_; }                 ///< σ = r′·r′
  const Vector<PointValue>& bend() const { return bend_; }              ///< r′ × r″
  const PointFactor& bend_square() const { return bend_square_; }       ///< ρ = |r′ × r″|²
  const PointValue& volume() const { return volume_; }                  ///< det(r′, r″, r‴)
  PointValue inverse_speed() const;                                     ///< 1/|r′|
  const PointValue& parameter() const { return parameter_; }            ///< t

 private:
  PointValue parameter_;
  std::array<Vector<PointValue>, 3> derivatives_;
  PointFactor square_;
  Vector<PointValue> bend_;
  PointFactor bend_square_;
  PointValue volume_;
};

}  // namespace phrame
