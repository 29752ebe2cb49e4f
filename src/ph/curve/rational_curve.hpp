#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// A polynomial or rational curve r = X/W on [0, 1], whatever its hodograph:
///   r′ = p·H/W²,  X′W − XW′ = p·H,
/// with a direction H of integer coefficients without a common factor. Where H is a polynomial
/// vector without a common root it has no zero, so that e₁ = H/|H| is defined for all t, through
/// cusps, too. As for PH curves, e₁ is r′/|r′| where p > 0 and −r′/|r′| where p < 0.
class PHRAME_API RationalCurve {
 public:
  /// The lowest terms of X/W, with coprime integers for the coefficients of W > 0. H has the sign
  /// for which p > 0 for small t > 0. Throws DomainError where W has a zero in [0, 1] that does not
  /// cancel, and for a single point.
  explicit RationalCurve(const Vector<Polynomial>& numerator, const Polynomial& weight = {1});

  /// X, which of a polynomial curve is ∫ p·H, found anew.
  Vector<Polynomial> numerator() const;
  const Polynomial& weight() const { return weight_; }                ///< W > 0 on [0, 1]
  const Vector<Polynomial>& direction() const { return direction_; }  ///< H
  const Polynomial& multiplier() const { return multiplier_; }        ///< p

  /// The same curve with −H and −p, whose e₁ is reversed.
  RationalCurve turned_over() const;

  friend bool operator==(const RationalCurve&, const RationalCurve&) = default;
  friend PHRAME_API Vector<Rational> point(const RationalCurve& curve, const Rational& t);

 private:
  Vector<Polynomial> numerator_;  ///< where W = 1 only X(0): a spline has thousands of curves
  Polynomial weight_;
  Vector<Polynomial> direction_;
  Polynomial multiplier_;
};

/// The greatest degree of X₁, X₂, X₃ and W.
PHRAME_API long degree(const RationalCurve& curve);
/// H × H′, along the binormal; 0 for a straight line.
PHRAME_API Vector<Polynomial> binormal(const RationalCurve& curve);
/// r(t). Throws DomainError where W(t) = 0, so outside [0, 1].
PHRAME_API Vector<Rational> point(const RationalCurve& curve, const Rational& t);

/// W²·r′ = p·H; r′ of a polynomial one, W = 1.
PHRAME_API Vector<Polynomial> hodograph(const RationalCurve& curve);

/// The Bézier curve Σ wₖ Pₖ Bₖ/Σ wₖ Bₖ, with weights 1 where none are given. Throws DomainError for
/// no points, another number of weights, and as RationalCurve.
PHRAME_API RationalCurve bezier_curve(const std::vector<Vector<Rational>>& points,
                                      const std::vector<Rational>& weights = {});

}  // namespace phrame
