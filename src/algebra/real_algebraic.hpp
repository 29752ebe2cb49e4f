#pragma once
#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A real algebraic number: the one root of an irreducible polynomial in an interval. A rational
/// number r is the root of the primitive multiple of t − r in the point [r, r]; the interval of any
/// other is open, with rational ends. Equality and order are decided by algebra.
class PHRAME_API RealAlgebraic {
 public:
  /// A rational number.
  RealAlgebraic(const Rational& r = 0);  // NOLINT(google-explicit-constructor)

  /// Its minimal polynomial, with coprime integer coefficients and a positive leading one.
  const Polynomial& polynomial() const { return polynomial_; }
  const Interval& interval() const {
    return interval_;
  }  ///< it contains no other root of polynomial()
  /// Is it rational?
  bool is_rational() const { return polynomial_.degree() == 1; }
  /// The number, where it is rational.
  std::optional<Rational> rational() const;

  friend PHRAME_API RealAlgebraic real_root(const Polynomial& p, const Interval& interval);
  friend PHRAME_API std::vector<struct RealRoot> real_roots(const Polynomial& p,
                                                            const Interval& interval);

 private:
  RealAlgebraic(Polynomial p, Interval isolating)
      : polynomial_(std::move(p)), interval_(std::move(isolating)) {}

  Polynomial polynomial_;
  Interval interval_;
};

/// The one real root of p in the interval, whatever its multiplicity. Throws DomainError where
/// there are none or several, saying how many, and for p = 0. Cost: the factorization of p.
PHRAME_API RealAlgebraic real_root(const Polynomial& p, const Interval& interval);

/// @{ Order and equality, decided exactly.
PHRAME_API std::strong_ordering compare(const RealAlgebraic& a, const Rational& r);
PHRAME_API std::strong_ordering compare(const RealAlgebraic& a, const RealAlgebraic& b);
inline bool operator==(const RealAlgebraic& a, const RealAlgebraic& b) {
  return compare(a, b) == 0;
}
inline std::strong_ordering operator<=>(const RealAlgebraic& a, const RealAlgebraic& b) {
  return compare(a, b);
}
/// @}

/// A root of a polynomial with its multiplicity.
struct RealRoot {
  RealAlgebraic at;  ///< the root
  long order;        ///< its multiplicity, ≥ 1; the polynomial changes sign where it is odd
  friend bool operator==(const RealRoot&, const RealRoot&) = default;
};

/// The distinct real roots of p in the interval, ascending. Throws DomainError for p = 0. Cost: the
/// factorization of p where there are any.
PHRAME_API std::vector<RealRoot> real_roots(const Polynomial& p, const Interval& interval);

/// The value of t, a root of p ≠ 0 in [a, b], where it is rational; no value where it is not. No
/// polynomial is factored: t is enclosed to about as many bits as the leading coefficient has.
/// Precondition: p has no other root in [a, b].
PHRAME_API std::optional<Rational> rational_root(const Polynomial& p, const Rational& a,
                                                 const Rational& b, const Real& t);

/// −1, 0 or 1: the sign of q(a).
PHRAME_API int sign_at(const Polynomial& q, const RealAlgebraic& a);
/// Is q(a) = 0? By a division, where sign_at() tries balls first: for numbers that mostly are
/// roots.
PHRAME_API bool is_root(const Polynomial& q, const RealAlgebraic& a);

/// A ball around a with a radius ≤ 2^−bits · max(1, |a|).
PHRAME_API RealBall enclose(const RealAlgebraic& a, long bits);

/// Where something is, for messages: "t = 1/2" or "t ≈ 0.584803547642"; long fractions are
/// abbreviated.
PHRAME_API std::string place_text(std::string_view letter, const RealAlgebraic& a);

/// The bits of the greatest coefficient of its polynomial, times the degree.
PHRAME_API long bits_of(const RealAlgebraic& a);

/// The number as a Real, of which rounding always ends: an irrational number is never half way
/// between two numbers with finitely many digits.
PHRAME_API Real to_real(const RealAlgebraic& a);

/// Writes "1/2", "root of t^2 - 2 in (1, 2)".
PHRAME_API std::ostream& operator<<(std::ostream& out, const RealAlgebraic& a);

}  // namespace phrame
