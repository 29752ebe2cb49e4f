#pragma once
#include <functional>

#include "phrame/export.hpp"
#include "phrame/ph/along/rmf_angle.hpp"

namespace phrame::inline v0 {

/// A right-handed orthonormal frame; the first vector is along A i A*: the unit tangent, or its
/// opposite where the multiplier f is negative.
template <class T>
struct Frame {
  Vector<T> e1;  ///< along the tangent
  /// @{ Normal to it: f₂, f₃ of a rotation-minimizing frame; n, b of Frenet's.
  Vector<T> e2;
  Vector<T> e3;
  /// @}
};

// Rounding. At rational t all components round correctly to doubles, to nearest with ties to even:
// none is half way between two doubles or two decimals (docs/algorithms.md, "The vectors round").
// Undecided is thrown where one is not told from such a point within the precision limit, by
// default where it is within about 2^−9000 of it; and in rounding to decimals for a component that
// is 0 but not exact in the sense below. As a double that is 0.

/// The frame turned about e₁ by θ: e₁, cos θ e₂ + sin θ e₃, −sin θ e₂ + cos θ e₃. Exact where θ =
/// 0, and a component where both e₂ and e₃ have the component 0.
PHRAME_API Frame<Real> turned(const Frame<Real>& frame, const Real& theta);
/// The same by θ = arg z, z ≠ 0: components are exact where |z|² is a rational square, else
/// irrational or 0.
PHRAME_API Frame<Real> turned(const Frame<Rational>& frame, const GaussianRational& z);
PHRAME_API Frame<Real> as_real(const Frame<Rational>& frame);  ///< the same numbers

/// The angle to (e₂, e₃) of v projected to their plane. Throws DomainError where that is 0.
PHRAME_API FrameAngle angle_of(const Vector<Rational>& v, const Frame<Rational>& frame);

/// The frame turned about e₁ by θ + start, an angle that `theta(start)` gives. It is exact if
/// `direction` is there, a number with the argument θ up to whole turns, and if start is the
/// argument of such a number, too; also where θ = 0.
PHRAME_API Frame<Real> turned(const Frame<Rational>& frame,
                              const std::optional<GaussianRational>& direction,
                              const std::function<Real(const FrameAngle& start)>& theta,
                              const FrameAngle& start);

/// The frames of one curve, for many t: what does not depend on t is computed once.
class PHRAME_API Frames {
 public:
  /// The frames of this curve.
  explicit Frames(const Curve& curve);

  /// (A i A*, A j A*, A k A*)/σ at t, exact; through cusps by continuity.
  Frame<Rational> euler_rodrigues(const Rational& t) const;

  /// (t, n, b) at t: n = (Re g·e₂ − Im g·e₃)/|g|, b = (Im g·e₂ + Re g·e₃)/|g| in the ERF.
  /// Components are exact where |g|² is a rational square, else irrational or 0.
  /// Throws DomainError for a straight line and at an inflection.
  Frame<Real> frenet(const Rational& t) const;

  /// The rotation-minimizing frame that at t = 0 has this angle to the ERF, so that it agrees with
  /// it for 0; `angle` is that of this curve relative to the ERF. Where the angle at the start is
  /// arg z with z ∈ ℚ(i), the frame is exact where there is a direction() of the angle, so on plane
  /// curves and all others with a rational rotation-minimizing frame, and where θ(t) = 0.
  Frame<Real> rotation_minimizing(const RmfAngle& angle, const Rational& t,
                                  const FrameAngle& start = {}) const;

 private:
  QuaternionPolynomial primitive_;  ///< A without its greatest real factor
  GaussianPolynomial bend_;         ///< g of that
};

/// (A i A*, A j A*, A k A*)/σ at t of an A without a real factor.
PHRAME_API Frame<Rational> euler_rodrigues_frame(const QuaternionPolynomial& primitive,
                                                 const Rational& t);

/// Throws DomainError for g = 0, of a straight line.
PHRAME_API void require_bend(const GaussianPolynomial& g);
/// (t, n, b) at t by the g of such an A, as of Frames.
PHRAME_API Frame<Real> frenet_frame(const QuaternionPolynomial& primitive,
                                    const GaussianPolynomial& bend, const Rational& t);

/// @{ One frame of a curve, as those of Frames; Frames is faster for many.
PHRAME_API Frame<Rational> euler_rodrigues_frame(const Curve& curve, const Rational& t);
PHRAME_API Frame<Real> frenet_frame(const Curve& curve, const Rational& t);
PHRAME_API Frame<Real> rotation_minimizing_frame(const Curve& curve, const RmfAngle& angle,
                                                 const Rational& t);
/// @}

/// @{ Every component correctly rounded.
PHRAME_API Vector<double> round_to_double(const Vector<Real>& v);
PHRAME_API Vector<double> round_to_double(const Vector<Rational>& v);
/// @}

}  // namespace phrame
