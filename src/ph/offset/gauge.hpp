#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A norm of the plane, by its unit circle U(φ), the indicatrix: a rational curve that is closed
/// for φ from −∞ to ∞, strictly convex, U′ × U″ ≠ 0 for each φ and at ∞, and its own reflection in
/// 0. For every direction there are two φ, on both sides, where U′ is parallel to it.
class PHRAME_API Gauge {
 public:
  /// That of the whole curve of which this is a part, in the parameter φ of its first segment; all
  /// segments are on one curve. Throws DomainError, saying which of the above it is not, where, and
  /// for a curve that is traced several times by complex φ.
  explicit Gauge(const Path& path);

  const Polynomial& x() const { return x_; }            ///< X of U = (X, Y)/W
  const Polynomial& y() const { return y_; }            ///< Y
  const Polynomial& weight() const { return weight_; }  ///< W, without a real zero
  long degree() const { return weight_.degree(); }      ///< of W, and the greatest of X and Y
  /// H along U′ with coprime integer coefficients: U′ = p·H/W², p without a real zero.
  const std::array<Polynomial, 2>& direction() const { return direction_; }

 private:
  Polynomial x_;
  Polynomial y_;
  Polynomial weight_;
  std::array<Polynomial, 2> direction_;
};

}  // namespace phrame
