#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "phrame/algebra/shared.hpp"
#include "phrame/ph/smooth/disc_function.hpp"
#include "phrame/ph/smooth/formula_domain.hpp"

namespace phrame {

/// r′, r″ and r‴ of a curve around a point, by z, t = middle + half·z.
struct CurveJet {
  Vector<DiscFunction> first;   ///< r′
  Vector<DiscFunction> second;  ///< r″
  Vector<DiscFunction> third;   ///< r‴
  RealBall middle{};            ///< the t with z = 0
  Rational half = 1;            ///< the length by z = 1
  /// A number that |r′·r′| is not less than on |z| ≤ 8, where it is > 0; of a jet with bounds, and
  /// while its curve lives.
  std::function<RealBall()> least_square{};
};

/// t, and 1/|r′|, on that disc; the bound of the second is not finite where r′·r′ is not seen to
/// have no zero on it, and 0 in a jet without bounds.
DiscFunction parameter_of(const CurveJet& jet);
DiscFunction inverse_speed(const CurveJet& jet);

/// By z, t = middle + half·z, to so many coefficients; no value where r is not seen to be analytic
/// on |z| ≤ 8.
std::optional<CurveJet> curve_jet(const ExpressionCurve& curve, const Rational& middle,
                                  const Rational& half, long length, long bits);

/// What is integrated, for any parameter: y dt does not depend on it.
using CurveIntegrand = std::function<DiscProduct(const CurveJet&)>;

/// A part of [0, 1] of the parameter on which an integrand y is analytic, and on the disc of four
/// times its size, where |y| ≤ bound with z = ±1 at the ends.
struct TaylorPart {
  Rational lower;
  Rational upper;
  RealBall bound;
  bool is_gap = false;  ///< is |y| ≤ bound on the part all that is known?
};

/// [0, 1] in parts, by halving; or where that ends, at 2^−40 or with too many.
struct TaylorParts {
  std::vector<TaylorPart> parts;
  std::optional<NarrowPart> fault;
};
TaylorParts taylor_parts(const ExpressionCurve& curve, const CurveIntegrand& integrand);
/// The same of a y that is continuous where a factor with an exponent > 0 has a zero, as √ρ is:
/// around these there are gaps, over each of which |∫ y| < 2^−bits.
TaylorParts taylor_parts_with_gaps(const ExpressionCurve& curve, const CurveIntegrand& integrand,
                                   long bits);

/// The parts for ∫ |r′| dt. Throws as the constructor of the curve, whose proof that is.
std::vector<TaylorPart> regular_parts(const ExpressionCurve& curve);

/// t ↦ ∫₀ᵗ y dt of an analytic integrand along an expression curve, by Taylor polynomials on parts,
/// whose error is bounded by Cauchy's estimate. What is computed for one t is kept for others. Any
/// thread may ask; copies share what is known.
class ExpressionIntegral {
 public:
  /// The parts must be those of this integrand.
  ExpressionIntegral(const ExpressionCurve& curve, CurveIntegrand integrand,
                     std::vector<TaylorPart> parts);
  /// By parts with gaps, the smaller the more bits. enclose() throws Undecided where there are too
  /// many.
  ExpressionIntegral(const ExpressionCurve& curve, CurveIntegrand integrand);

  /// A ball with a radius of about 2^−bits, t ∈ [0, 1].
  RealBall enclose(const Rational& t, long bits) const;
  /// The same for all t of [0, 1] in a ball, at least one.
  RealBall enclose(const RealBall& t, long bits) const;
  /// y on the ball t.
  RealBall rate(const RealBall& t, long bits) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
