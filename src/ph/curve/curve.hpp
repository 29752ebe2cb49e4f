#pragma once
#include "phrame/algebra/sturm.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A spatial Pythagorean-hodograph curve r(t), t ∈ ℝ (the segment is [0, 1]):
///   r′ = f · A i A*,  r(0) = start,
/// with the preimage A ∈ ℍ[t] and the multiplier f ∈ ℚ[t], both not zero [Farouki 2003, (12)]. Of a
/// rational one, r = X/W, it is r′ = f · A i A*/W²: what depends on A alone, and on the sign of f,
/// is that of a polynomial curve.
/// Frames and angles are those of A i A*, whatever the sign of f: e₁ = A i A*/σ is r′/|r′| where
/// f > 0 and −r′/|r′| where f < 0.
class PHRAME_API Curve {
 public:
  /// @{ From (0, 0, 0), unless another start is given. Throws DomainError where the preimage or the
  /// multiplier is zero.
  explicit Curve(QuaternionPolynomial preimage, Polynomial multiplier = Polynomial{1});
  Curve(QuaternionPolynomial preimage, Polynomial multiplier, Vector<Rational> start);
  /// @}
  /// The rational curve X/W. Throws DomainError where f · A i A* is not X′W − XW′, where W(0) = 0,
  /// and likewise.
  static Curve quotient(QuaternionPolynomial preimage, Polynomial multiplier,
                        Vector<Polynomial> numerator, Polynomial weight);

  const QuaternionPolynomial& preimage() const { return preimage_; }  ///< A
  const Polynomial& multiplier() const { return multiplier_; }        ///< f
  const Vector<Rational>& start() const { return start_; }            ///< r(0)
  const Polynomial& weight() const { return weight_; }                ///< W, 1 of polynomial ones
  bool is_polynomial() const { return weight_.is_constant(); }        ///< is W = 1?

  /// The same r with other A and f, of which f · A i A* is the same.
  Curve with_form(QuaternionPolynomial preimage, Polynomial multiplier) const;
  friend PHRAME_API Vector<Polynomial> numerator(const Curve& curve);

  friend bool operator==(const Curve&, const Curve&) = default;

 private:
  QuaternionPolynomial preimage_;
  Polynomial multiplier_;
  Vector<Rational> start_;
  Polynomial weight_{1};
  Vector<Polynomial> numerator_;  ///< X of a rational one
};

/// The same curve with A·j and −f: e₁ and e₃ are reversed.
PHRAME_API Curve turned_over(const Curve& curve);

/// On one line: "A = (t + 1, 2, 0, t^2), f = 1, r(0) = (0, 0, 0)".
PHRAME_API std::ostream& operator<<(std::ostream& out, const Curve& curve);

PHRAME_API long preimage_degree(const Curve& curve);  ///< m
/// The degree of r: 2m + 1 + deg f, or the greatest of X and W.
PHRAME_API long degree(const Curve& curve);

/// @{ r′ and r of a polynomial curve. Throws DomainError for a rational one.
PHRAME_API Vector<Polynomial> hodograph(const Curve& curve);
PHRAME_API Vector<Polynomial> position(const Curve& curve);
/// @}
/// @{ W²·r′ = f · A i A* and X = W·r, of polynomial curves r′ and r.
PHRAME_API Vector<Polynomial> hodograph_numerator(const Curve& curve);
PHRAME_API Vector<Polynomial> numerator(const Curve& curve);
/// @}
/// gcd(x′, y′, z′), the numerators of r′ in lowest terms; constant for a primitive hodograph.
PHRAME_API Polynomial hodograph_content(const Curve& curve);
/// The signs that f takes on the segment [0, 1], its zeros apart; decided exactly.
struct Signs {
  bool positive = false;  ///< is f > 0 anywhere on it?
  bool negative = false;  ///< is f < 0 anywhere on it?
  friend bool operator==(const Signs&, const Signs&) = default;
};
/// Cost: the real roots of f in (0, 1).
PHRAME_API Signs multiplier_signs(const Curve& curve);

PHRAME_API Vector<Rational> evaluate(const Vector<Polynomial>& v, const Rational& t);  ///< v(t)

/// The polynomial Σ b_r C(m, r) (1 − t)^{m−r} tʳ with m + 1 Bernstein coefficients b.
PHRAME_API Polynomial from_bernstein(const std::vector<Rational>& b);
/// The Bernstein coefficients of p on [0, 1] in degree m ≥ deg p: b_r = Σ_k C(r, k)/C(m, k) p_k.
/// Throws DomainError for m < deg p.
PHRAME_API std::vector<Rational> to_bernstein(const Polynomial& p, long m);

/// @{ The same of A, component by component.
PHRAME_API QuaternionPolynomial from_bernstein(const std::vector<RationalQuaternion>& b);
PHRAME_API std::vector<RationalQuaternion> to_bernstein(const QuaternionPolynomial& a, long m);
/// @}

/// The cᵣ = C(m, r)·bᵣ, as coefficients: p(t) = Σ cᵣ tʳ (1 − t)ᵐ⁻ʳ. Throws as above.
PHRAME_API Polynomial scaled_bernstein(const Polynomial& p, long m);

/// The Bézier control points of r on [0, 1], degree(curve) + 1 of them.
PHRAME_API std::vector<Vector<Rational>> control_points(const Curve& curve);
/// r′ of the Bézier curve with these points. Throws DomainError where there is none.
PHRAME_API Vector<Polynomial> bezier_hodograph(const std::vector<Vector<Rational>>& control_points);

}  // namespace phrame
