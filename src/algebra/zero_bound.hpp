#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {

/// What a number of a field was made from: a root, or √x for an x of the field of others. It
/// adjoins a number of this degree. Equal roots are one generator, and so are copies of one √x.
class Generator {
 public:
  /// A root of its polynomial.
  explicit Generator(RealAlgebraic root)
      : degree_(root.polynomial().degree()),
        root_(std::make_shared<const RealAlgebraic>(std::move(root))) {}
  /// Some square root.
  Generator() : degree_(2), root_(std::make_shared<const RealAlgebraic>()) {}

  long degree() const { return degree_; }  ///< the greatest that it adds by
  friend bool operator==(const Generator& a, const Generator& b) {
    return a.root_ == b.root_ ||
           (!a.root_->is_rational() && a.root_->polynomial() == b.root_->polynomial() &&
            *a.root_ == *b.root_);
  }

 private:
  long degree_;
  std::shared_ptr<const RealAlgebraic> root_;  ///< 0 for a square root, which only copies share
};

/// What is known of an algebraic number without its polynomial: that it is 0 or not too small.
/// Where it is of degree ≤ d and of absolute height ≤ 2ʰ,
///     x = 0 or |x| ≥ 2^(−d·h)                                                    (Liouville)
/// (Waldschmidt, Diophantine Approximation on Linear Algebraic Groups, section 3.5). So equality is
/// decided by enclosures alone. Heights add. The number lies in the field that its generators span,
/// whose degree is at most the product of theirs, so arithmetic within one field raises no degree.
struct ZeroBound {
  long degree = 0;  ///< d; 0 where nothing is known: the number may be transcendental
  long height = 0;  ///< h, in bits
  std::vector<Generator> generators =
      {};  ///< distinct ones, with d as the product of their degrees

  bool is_known() const { return degree > 0; }  ///< Is there a bound?
  /// d·h: with so many bits after the binary point the number is told from 0.
  long bits() const { return degree * height; }
};

/// @{ Of a rational number, and of an algebraic one by the coefficients of its polynomial.
ZeroBound zero_bound(const Rational& x);
ZeroBound zero_bound(const RealAlgebraic& x);
/// @}
/// @{ Of x + y or x − y, of x·y or x/y, of √x and of xᵏ. Nothing is known beyond 2¹⁶ bits.
ZeroBound of_sum(const ZeroBound& x, const ZeroBound& y);
ZeroBound of_product(const ZeroBound& x, const ZeroBound& y);
ZeroBound of_square_root(const ZeroBound& x);
ZeroBound of_power(const ZeroBound& x, long k);
/// @}

/// The number, exact where it is rational, and known to be irrational where it is not, as far as
/// the bound decides it; else as it was.
Real settled(const Real& x, const ZeroBound& bound);
/// −1, 0 or 1; no value where the number is neither told from 0 nor seen to be it within 8192 bits
/// and four times those of what it was made from, or 2¹⁸.
std::optional<int> decided_sign(const Real& x, const ZeroBound& bound);
/// The greatest integer ≤ x; no value where x is not told from an integer likewise.
std::optional<Integer> decided_floor(const Real& x);

}  // namespace phrame
