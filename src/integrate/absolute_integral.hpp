#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/integrate/algebraic_integral.hpp"
#include "phrame/integrate/taylor_integral.hpp"

namespace phrame::inline v0 {

/// ∫₀ᵗ |N/(D√S)| for t in [0, 1]: a TaylorIntegral from one change of the sign of N to the next,
/// which are decided by algebra. Copies are cheap and share what was found; any thread may ask.
class AbsoluteIntegral {
 public:
  /// Throws as TaylorIntegral.
  explicit AbsoluteIntegral(const RootQuotient& f);

  /// ∫₀ᵗ N/(D√S), with its signs.
  const TaylorIntegral& integral() const { return integral_; }
  /// In (0, 1), where the sign changes, ascending.
  const std::vector<RealAlgebraic>& sign_changes() const { return changes_; }

  /// The integral up to t, exact where D is constant and algebraic_value() is rational.
  /// Throws DomainError for an exact t outside [0, 1].
  Real value(const Real& t) const;
  /// The same where it is algebraic_integral() and the sign changes at rational t; else no value.
  std::optional<Surd> algebraic_value(const Rational& t) const;
  /// A ball around it, with a radius of about 2^−bits times the whole for an exact t.
  RealBall enclose(const Real& t, long bits) const;

 private:
  RealBall up_to(const Real& t, std::size_t changes_before, long bits) const;

  TaylorIntegral integral_;
  std::vector<RealAlgebraic> changes_;
  std::vector<Real> change_at_;  ///< the same
  int first_sign_ = 0;           ///< of N for small t > 0
  /// Asked for when it is needed.
  Lazy<std::optional<AlgebraicIntegral>> algebraic_;
};

}  // namespace phrame
