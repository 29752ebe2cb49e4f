#pragma once
#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

/// The frames of one curve at algebraic t, as Frames has them at rational t. Components of the
/// Euler–Rodrigues and of the Frenet frame are exact where they are rational, else irrational.
/// Those of the rotation-minimizing frame are exact where it is the Euler–Rodrigues frame and where
/// both its vectors e₂, e₃ have the component 0; the correct rounding of others ends unless they
/// lie half way between two results, which is then undecided.
class AlgebraicFrames {
 public:
  /// Cost: the antiderivative of θ.
  explicit AlgebraicFrames(const Curve& curve);

  /// (A i A*, A j A*, A k A*)/σ at t.
  Frame<Real> euler_rodrigues(const AlgebraicPoint& t) const;
  /// Throws DomainError for a straight line and at an inflection.
  Frame<Real> frenet(const AlgebraicPoint& t) const;
  /// θ(t) of RmfAngle relative to the Euler–Rodrigues frame; exact where it is 0 everywhere.
  Real angle(const AlgebraicPoint& t) const;
  /// Equal to the Euler–Rodrigues frame at t = 0.
  Frame<Real> rotation_minimizing(const AlgebraicPoint& t) const;

 private:
  Frame<Polynomial> numerators_;  ///< σ times the Euler–Rodrigues frame
  Polynomial sigma_;
  GaussianPolynomial bend_;
  bool is_rotation_minimizing_;  ///< is the Euler–Rodrigues frame?
  Evaluator twist_;              ///< of θ
};

}  // namespace phrame
