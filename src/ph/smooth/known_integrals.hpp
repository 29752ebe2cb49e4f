#pragma once
#include <memory>
#include <mutex>

#include "phrame/ph/smooth/taylor_parts.hpp"

namespace phrame {

/// What was found of integrals ∫₀ᵗ y dt along one curve by formulas, kept for all copies of the
/// curve; any thread may ask. The curve is always the same.
class KnownIntegrals {
 public:
  KnownIntegrals();
  KnownIntegrals(const KnownIntegrals&) = delete;
  KnownIntegrals& operator=(const KnownIntegrals&) = delete;
  ~KnownIntegrals();

  /// The parts on which y is analytic.
  std::shared_ptr<const TaylorParts> parts(const ExpressionCurve& curve, const CurveIntegrand& y);
  /// Finds the parts of these now, and the integrals when the first of them is asked for, all on
  /// one walk along the curve.
  void find_together(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands);
  /// A ball with a radius of about 2^−bits around the integral up to t ∈ [0, 1].
  RealBall enclose(const ExpressionCurve& curve, const CurveIntegrand& y, const Rational& t,
                   long bits);

 private:
  struct Piece;
  class Rules;
  class Integral;
  void search(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands);
  Integral* find(CurveIntegrand y) const;
  Integral& searched(const ExpressionCurve& curve, const CurveIntegrand& y);
  void add_next_part(const ExpressionCurve& curve, const std::vector<Integral*>& of);
  void walk_together(const ExpressionCurve& curve, long bits);
  void refine(const ExpressionCurve& curve, Integral& f, long bits);

  RealBall value(const ExpressionCurve& curve, Integral& f, const Rational& t);

  std::mutex lock_;
  std::unique_ptr<Rules> rules_;
  std::vector<std::unique_ptr<Integral>> integrals_;  ///< first the length
  std::vector<Integral*> together_;                   ///< which the first of them will find
};

}  // namespace phrame
