#pragma once
#include <memory>

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/along/frame_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame::inline v0 {

struct NearPole;

/// The frame that an angle is measured from.
enum class Reference {
  euler_rodrigues,  ///< (A i A*, A j A*, A k A*)/σ
  frenet,  ///< tangent, normal, binormal; continued through inflections, where (n, b) jump by π
  up,  ///< e₂ = v × e₁/|v × e₁|, e₃ = e₁ × e₂, of a vector v that is nowhere along the tangent
};

/// The angle θ of the rotation-minimizing frame relative to (e₂, e₃), the reference frame:
///   f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃,  θ(0) = 0, θ continuous on all of ℝ,
///   θ_ERF′ = −2h/σ,  θ_Frenet′ = −2h/σ + Im(g′/g)  [Farouki 2003, (13)–(17), in closed form],
/// and to the frame of v the same with v·(A k A*) + i·v·(A j A*) for g.
/// θ has no pole on ℝ: what vanishes at a cusp cancels. It depends on the preimage A alone.
/// Copies are cheap and share the poles of θ′, which are isolated once; any thread may ask them. To
/// move one is to copy it.
class PHRAME_API RmfAngle {
 public:
  /// The angle to the Euler–Rodrigues or the Frenet frame. Throws DomainError for A = 0, for the
  /// Frenet frame of a straight line, and for Reference::up: the next constructor takes v.
  explicit RmfAngle(const QuaternionPolynomial& preimage,
                    Reference reference = Reference::euler_rodrigues, Form form = Form::automatic);
  /// The angle to the frame of v, which is continued where v is along the tangent. Throws
  /// DomainError for A = 0, and where v is along the tangent all along.
  RmfAngle(const QuaternionPolynomial& preimage, const Vector<Rational>& v,
           Form form = Form::automatic);
  /// The angle of the preimage of a curve.
  explicit RmfAngle(const Curve& curve, Reference reference = Reference::euler_rodrigues,
                    Form form = Form::automatic)
      : RmfAngle(curve.preimage(), reference, form) {}
  RmfAngle(const RmfAngle&) = default;
  RmfAngle& operator=(const RmfAngle&) = default;
  ~RmfAngle() = default;

  /// θ′ in lowest terms, found when it is first asked for.
  const RationalFunction& rate() const;
  bool is_zero() const;  ///< Is θ ≡ 0?
  /// Up to a constant θ is angle_to_erf() plus the argument of bend(), where there is one.
  /// angle_to_erf() is ∫ −2h/σ, or 0 where θ ≡ 0. It is found when it is first asked for; no value
  /// needs its form.
  const Antiderivative& angle_to_erf() const;
  /// The same without its logarithms.
  const Antiderivative& without_logarithms() const;
  /// g without its real factor; none where its argument is constant or θ ≡ 0, and to the
  /// Euler–Rodrigues frame.
  const std::optional<GaussianPolynomial>& bend() const;
  /// θ up to a constant as one value; its derivative is rate(), checked. arg g is in it as the last
  /// sum, Σ x·log v(x, t) over x = ±i/2 with v(−i/2, t) = g made monic.
  const Antiderivative& antiderivative() const;

  /// θ(t) + start, exact where it is rational, else transcendental, so that it rounds correctly.
  /// That it is rational is decided where all residues of θ′ lie in ℚ(i) and recognised in many
  /// other cases; where it is not recognised, to round it throws Undecided.
  Real value(const Rational& t, const FrameAngle& start = {}) const;
  /// Chooses the way to values from now on. Copies keep theirs.
  void set_route(Route route) { route_ = route; }
  /// A ball around θ(t) with a radius ≤ 2^−bits · max(1, |θ(t)|).
  RealBall enclose(const Rational& t, long bits) const;
  /// The poles of θ′ above the real axis, simple ones, by pairs of doubles, where θ is the sum of
  /// their logarithms; null where doubles do not tell them, with a bend(), and on other routes.
  const std::vector<NearPole>* near_poles() const;
  /// z ∈ ℚ(i) with e^{iθ(t)} = z/|z|, where there is one for all t: where θ is the argument of a
  /// function in ℚ(i)(t), as on curves with a rational rotation-minimizing frame [Han 2008], plane
  /// curves among them. No value else. Cost: in the first call, on such curves, that of their
  /// residues.
  std::optional<GaussianRational> direction(const Rational& t) const;

 private:
  struct Parts;

  RmfAngle(const QuaternionPolynomial& preimage, std::optional<GaussianPolynomial> to_frame,
           Form form);

  std::shared_ptr<const Parts> parts_;
  Route route_ = Route::automatic;
};

/// g without its greatest real factor: the Frenet frame turns with its argument, continuously.
/// Throws DomainError for a straight line.
PHRAME_API GaussianPolynomial regular_bend(const QuaternionPolynomial& a);
/// v·(A k A*) + i·v·(A j A*) without its greatest real factor: so turns the frame of v. Throws
/// DomainError where v is along the tangent all along.
PHRAME_API GaussianPolynomial regular_bend(const QuaternionPolynomial& a,
                                           const Vector<Rational>& v);
/// That to the Frenet frame for small t > 0, up to a positive factor that tends to 1. Throws
/// likewise.
PHRAME_API GaussianRational bend_after_zero(const QuaternionPolynomial& a);
/// (arg g)′ = Im(g′/g).
PHRAME_API RationalFunction rate_of_argument(const GaussianPolynomial& g);

/// −2h/σ: θ′ of the rotation-minimizing frame to the Euler–Rodrigues frame, which turns about the
/// tangent with the opposite rate. In lowest terms.
PHRAME_API RationalFunction rate_to_erf(const QuaternionPolynomial& a);

}  // namespace phrame
