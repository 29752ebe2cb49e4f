#pragma once
#include <array>
#include <functional>
#include <optional>

#include "phrame/ph/curve/disc_function.hpp"
#include "phrame/ph/curve/expression_curve.hpp"

namespace phrame::inline v0 {

/// |r′|, |r″| and |r‴| on |z| ≤ 8, component by component.
using DiscBounds = std::array<Vector<RealBall>, 3>;
/// By z, t = middle + half·z; no value where r is not seen to be analytic there.
std::optional<DiscBounds> bounds_on_disc(const ExpressionCurve& curve, const Rational& middle,
                                         const Rational& half);

/// A curve around a point, by z, t = middle + half·z, and what integrands along it are made of:
/// each is found once, when it is first asked for, for all integrands and all copies.
class CurveJet {
 public:
  using Product = DiscProduct;  ///< what an integrand is around it

  /// The first coefficients, without bounds.
  CurveJet(const ExpressionCurve& curve, const RealBall& middle, const Rational& half, long length,
           long bits);
  /// The same with bounds, which are those of this disc. The curve has to outlive it.
  CurveJet(const ExpressionCurve& curve, const Rational& middle, const Rational& half,
           const DiscBounds& bounds, long length, long bits);

  const RealBall& middle() const { return middle_; }  ///< the t with z = 0
  const Rational& half() const { return half_; }      ///< the length by z = 1
  const Vector<DiscFunction>& first() const;          ///< r′
  const Vector<DiscFunction>& second() const;         ///< r″
  const Vector<DiscFunction>& third() const;          ///< r‴
  const DiscFactor& square() const;                   ///< σ = r′·r′
  const Vector<DiscFunction>& bend() const;           ///< r′ × r″
  const DiscFactor& bend_square() const;              ///< ρ = |r′ × r″|²
  const DiscFunction& volume() const;                 ///< det(r′, r″, r‴)
  /// 1/|r′|; its bound is not finite where r′·r′ is not seen to have no zero on the disc, and 0 in
  /// a jet without bounds.
  DiscFunction inverse_speed() const;
  DiscFunction parameter() const;  ///< t

 private:
  const Vector<DiscFunction>& derivative(std::size_t order) const;

  Vector<BallPolynomial> r_;
  RealBall middle_;
  Rational half_;
  long length_;
  long bits_;
  DiscBounds bounds_{};
  std::function<RealBall()> least_square_{};  ///< what |r′·r′| is not less than, where that is > 0
  std::array<Lazy<Vector<DiscFunction>>, 3> derivatives_;
  Lazy<DiscFactor> square_;
  Lazy<Vector<DiscFunction>> bend_;
  Lazy<DiscFactor> bend_square_;
  Lazy<DiscFunction> volume_;
};

/// No value where r is not seen to be analytic on |z| ≤ 8.
std::optional<CurveJet> curve_jet(const ExpressionCurve& curve, const Rational& middle,
                                  const Rational& half, long length, long bits);

}  // namespace phrame
