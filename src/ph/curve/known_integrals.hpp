#pragma once
#include <memory>
#include <mutex>

#include "phrame/ph/curve/taylor_parts.hpp"

namespace phrame::inline v0 {

/// What was found of the last integrals ∫₀ᵗ y dt along one curve by formulas, kept for all copies
/// of the curve; any thread may ask. The curve is always the same.
class KnownIntegrals {
 public:
  /// One of them, of y or −y: of that with the sign 1.
  class Integral;

  KnownIntegrals();  ///< of a curve of which nothing is known yet
  KnownIntegrals(const KnownIntegrals&) = delete;
  KnownIntegrals& operator=(const KnownIntegrals&) = delete;
  ~KnownIntegrals();

  /// The parts on which y is analytic.
  std::shared_ptr<const TaylorParts> parts(const ExpressionCurve& curve, const CurveIntegrand& y);
  /// Finds the parts of these now, and the integrals when the first of them is asked for, all on
  /// one walk along the curve.
  void find_together(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands);
  /// The integral of y, which may be asked as long as it is held.
  std::shared_ptr<Integral> integral(const ExpressionCurve& curve, const CurveIntegrand& y);
  /// A ball with a radius of about 2^−bits around it up to t ∈ [0, 1].
  RealBall enclose(const ExpressionCurve& curve, Integral& f, const Rational& t, long bits);

 private:
  struct Piece;
  class Rules;

  void search(const ExpressionCurve& curve, const std::vector<CurveIntegrand>& integrands);
  std::shared_ptr<Integral> find(CurveIntegrand y) const;
  void add_next(const ExpressionCurve& curve, const std::vector<Integral*>& of);
  void walk(const ExpressionCurve& curve, const std::vector<std::shared_ptr<Integral>>& all,
            long bits);
  void refine(const ExpressionCurve& curve, Integral& f, long bits);
  RealBall value(const ExpressionCurve& curve, Integral& f, const Rational& t);
  RealBall value(const ExpressionCurve& curve, Integral& f, const Rational& t, long least_bits);

  std::mutex lock_;
  std::unique_ptr<Rules> rules_;
  std::vector<std::shared_ptr<Integral>> integrals_;  ///< first the length
  std::vector<std::shared_ptr<Integral>> together_;   ///< which the first of them will find
};

}  // namespace phrame
