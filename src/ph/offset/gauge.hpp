#pragma once
#include <variant>

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

/// φ = p/q along a curve, with p and q ∈ ℚ[t] without a common root; ∞ where q = 0.
struct GaugeParameter {
  Polynomial p;  ///< the numerator
  Polynomial q;  ///< the denominator
};

/// (x, y)/weight, a polynomial vector over a polynomial.
struct GaugeVector {
  Polynomial x;       ///< its x times the weight
  Polynomial y;       ///< its y times the weight
  Polynomial weight;  ///< without a real zero
};
/// U(p/q), with weight W(p, q) for the form W of the degree of the gauge.
GaugeVector vector_at(const Gauge& gauge, const GaugeParameter& at);

/// Why there is no rational φ(t): the degrees in φ of the factors of r′(t) × U′(φ), irreducible
/// over ℚ, ascending, as often as they occur.
struct NoGaugeParameter {
  std::vector<long> degrees;
};

/// φ(t) with U′(φ) ∥ r′, U(φ) to the right of e₁: a factor of degree 1 of r′(t) × U′(φ). As the
/// gauge is traced once, U(φ(t)) is rational where φ(t) is and only there. Precondition: a curve in
/// a plane z = const. Cost: factors of a polynomial in two unknowns.
std::variant<GaugeParameter, NoGaugeParameter> right_parameter(const Gauge& gauge,
                                                               const RationalCurve& curve);

}  // namespace phrame
