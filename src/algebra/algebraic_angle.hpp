#pragma once
#include <vector>

#include "phrame/algebra/real.hpp"

namespace phrame::inline v0 {

/// An angle up to whole turns, π·half_turns + Σ arg zₖ with zₖ = x + y·√−d ≠ 0 for rational x, y
/// and d > 0: the argument of an algebraic number. Whether it is a rational multiple of π is
/// decided, however many different roots there are.
class AlgebraicAngle {
 public:
  AlgebraicAngle() = default;  ///< 0
  /// π·half_turns.
  explicit AlgebraicAngle(Rational half_turns) : half_turns_(std::move(half_turns)) {}
  /// arg(x + y·√−d). Throws DomainError for d ≤ 0 and for 0.
  static AlgebraicAngle argument(const Rational& x, const Rational& y, const Rational& d);

  /// The angle over π in (−1, 1] where that is rational; no value where it is not.
  std::optional<Rational> half_turns() const;

  /// Different ones, of those that are left.
  std::size_t count_roots() const { return factors_.size(); }

  /// @{ Up to whole turns. Cost of a sum: the product of the numbers of different roots.
  friend AlgebraicAngle operator+(AlgebraicAngle a, const AlgebraicAngle& b);
  friend AlgebraicAngle operator-(AlgebraicAngle a);
  /// @}

 private:
  /// x + y·√−d, coprime integers x and y.
  struct Factor {
    Integer x;
    Integer y;
    Integer d;
  };
  void multiply(const Factor& z);

  Rational half_turns_;
  std::vector<Factor> factors_;  ///< no two d of which have a product that is a square
};

/// What a Real may know of itself: it is radians + an AlgebraicAngle, up to whole turns.
struct AngleForm {
  Rational radians;
  /// The other part, found when it is needed; no value where that is too much work.
  std::function<std::optional<AlgebraicAngle>()> rest;
};

/// The number in these enclosures, which has this form: exact where it is rational, which is where
/// it equals the radians, and else known to be irrational (Lindemann).
Real real_angle(Real::Enclosure enclosure, AngleForm form, long bits_of_origin);

/// x/π where x has an AngleForm or is exact, and it is rational. No value where it is not, or
/// nothing is known.
std::optional<Rational> over_pi(const Real& x);

}  // namespace phrame
