#pragma once
#include <memory>

#include "phrame/algebra/polynomial.hpp"
#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// N/(D√S) with polynomials over ℚ.
struct RootQuotient {
  Polynomial numerator;          ///< N
  Polynomial denominator = {1};  ///< D
  Polynomial radicand = {1};     ///< S
};

/// F(t) = ∫₀ᵗ N/(D√S) for t in [0, 1], where S > 0 and D has no zero there: to any number of
/// digits, by Taylor polynomials on parts, found once for all t and proved by what they leave over
/// in the equations of 1/√S and of the quotient (unit_series()); F(1) to 17 digits or some more by
/// Gauss's rule, where that is proved to do (near_integral()). Copies are cheap and share them; any
/// thread may ask. To move one is to copy it.
class TaylorIntegral {
 public:
  /// Factors that cancel are no matter. Throws DomainError where a zero of D or S is left in [0,
  /// 1], or S < 0.
  explicit TaylorIntegral(const RootQuotient& f);
  TaylorIntegral(const TaylorIntegral&) = default;
  TaylorIntegral& operator=(const TaylorIntegral&) = default;
  ~TaylorIntegral() = default;

  /// In lowest terms, D > 0 on [0, 1] and S squarefree.
  const RootQuotient& integrand() const;
  /// A ball around F(t) with a radius of about 2^−bits times ∫₀¹ |N/(D√S)|. Throws DomainError for
  /// t outside [0, 1], Undecided where the parts would be shorter than 2^−4096 or their Taylor
  /// series do not do.
  RealBall enclose(const Rational& t, long bits) const;
  /// The same for all t of [0, 1] in a ball, at least one.
  RealBall enclose(const RealBall& t, long bits) const;
  /// F(t), exact where F is a polynomial over ℚ. Throws DomainError for t outside [0, 1].
  Real value(const Rational& t) const;
  /// N/(D√S) on the ball t.
  RealBall rate(const RealBall& t, long bits) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace phrame
