#pragma once
#include <optional>
#include <string>

#include "phrame/algebra/polynomial.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A part of the real line. A missing end is infinite (and open).
struct Interval {
  std::optional<Rational> lower;  ///< none for −∞
  std::optional<Rational> upper;  ///< none for ∞
  bool lower_closed = true;       ///< does the lower end belong to it?
  bool upper_closed = true;       ///< does the upper end?

  friend bool operator==(const Interval&, const Interval&) = default;
};

inline Interval real_line() { return {}; }  ///< (−∞, ∞)
/// [a, b].
inline Interval closed_interval(Rational a, Rational b) { return {std::move(a), std::move(b)}; }
/// (a, b).
inline Interval open_interval(Rational a, Rational b) {
  return {std::move(a), std::move(b), false, false};
}

/// "[0, 1]", "(-1/2, ∞)".
PHRAME_API std::string to_string(const Interval& interval);
/// Writes to_string(interval).
PHRAME_API std::ostream& operator<<(std::ostream& out, const Interval& interval);

/// The number of distinct real roots of p in the interval, by Descartes' rule of signs on ever
/// smaller parts until each has 0 or 1 sign changes, and by Sturm's theorem where roots are close
/// together. An interval with lower > upper is empty. Throws DomainError for p = 0.
PHRAME_API long count_real_roots(const Polynomial& p, const Interval& interval);

/// Disjoint intervals in ascending order, one for each distinct real root of p in the given one.
/// Each is either a single rational point, the root itself, or open, with no root at its ends and a
/// change of sign of the squarefree part between them. Throws DomainError for p = 0.
PHRAME_API std::vector<Interval> isolate_real_roots(const Polynomial& p, const Interval& interval);

/// The same isolating interval of p, with finite ends, bisected until it is no wider than
/// `width` > 0.
PHRAME_API Interval narrowed(const Polynomial& p, Interval isolating, const Rational& width);

/// As isolate_real_roots(), for people to read: rational roots as points, the others in intervals
/// no wider than 2⁻²⁰. Cost: a factorization where there is a root.
PHRAME_API std::vector<Interval> located_real_roots(const Polynomial& p, const Interval& interval);

/// The Sturm sequence of (p, q): p, q and the negated remainders, each up to a positive factor;
/// the last is gcd(p, q). Basu–Pollack–Roy, Algorithms in Real Algebraic Geometry, §2.2.
class PHRAME_API SturmChain {
 public:
  /// Throws DomainError for p = 0.
  SturmChain(const Polynomial& p, const Polynomial& q);

  /// The signs −1, 0, 1 of all its polynomials at t.
  std::vector<int> signs(const Rational& t) const;
  /// The number of sign changes at t (zeros are skipped).
  long variations(const Rational& t) const;

 private:
  std::vector<flint::FmpzPoly> chain_;
};

/// The Cauchy index of q/p on (a, b): the number of jumps of q/p from −∞ to +∞ minus the number of
/// jumps from +∞ to −∞ = V(a) − V(b). Precondition: p(a)·p(b) ≠ 0. The chain is that of (p, q).
PHRAME_API long cauchy_index(const SturmChain& chain, const Rational& a, const Rational& b);

/// How γ = x + iy turns between 0 and t, by the signs of the Sturm sequence of (x, y) at both ends.
struct TurnCount {
  long index;           ///< the Cauchy index of y/x: sign changes at 0 minus sign changes at t
  std::string at_zero;  ///< the signs at 0, such as "+-0", one for each polynomial
  std::string at_t;     ///< the signs at t
  friend bool operator==(const TurnCount&, const TurnCount&) = default;
};

}  // namespace phrame
