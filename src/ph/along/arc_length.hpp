#pragma once
#include <memory>
#include <optional>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

struct IncreasingFunction;

/// ∫₀ᵗ fσ: the arc length from 0 to t > 0 where f ≥ 0 between them, exact.
PHRAME_API Polynomial arc_length(const Curve& curve);
/// ∫ |f|σ from a to b, a ≤ b; no value where f changes sign between them.
PHRAME_API std::optional<Rational> arc_length(const Curve& curve, const Rational& a,
                                              const Rational& b);

/// Does f keep its sign on [0, 1]? Then it has an ArcLength.
PHRAME_API bool has_polynomial_length(const Curve& curve);

/// The arc length s(t) = ∫₀ᵗ |f|σ of the segment [0, 1], a strictly increasing polynomial, and its
/// inverse [Farouki 2008].
class PHRAME_API ArcLength {
 public:
  /// Throws DomainError where f changes sign on [0, 1], since |f|σ is then no polynomial.
  explicit ArcLength(const Curve& curve);

  const Polynomial& polynomial() const { return length_; }  ///< s(t)
  const Rational& total() const { return total_; }          ///< s(1)

  /// The t ∈ [0, 1] with s(t) = s, exact where it is rational, else algebraic: its correct rounding
  /// ends. An s beyond s(1) that rounds to the same double is s(1): is_rounded(). Throws
  /// DomainError for another s outside [0, s(1)]. Cost: two or three values of s and σ and, where t
  /// is asked for beyond the first 60 bits, interval Newton steps.
  Real parameter(const Rational& s) const;

  /// The same as a root of its irreducible polynomial, at which a frame can be evaluated exactly.
  /// Cost: the factorization of s(t) − s.
  RealAlgebraic algebraic_parameter(const Rational& s) const;

 private:
  void require_on_curve(const Rational& s) const;
  double guess(const Rational& s) const;

  Polynomial length_;
  Rational total_;
  std::vector<double> scaled_;  ///< the coefficients of s(t)/s(1), for a guess
  std::shared_ptr<const IncreasingFunction> function_;
};

}  // namespace phrame
