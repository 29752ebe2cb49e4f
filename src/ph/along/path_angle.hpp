#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {

/// The angle θ of the rotation-minimizing frame along a path, relative to (e₂, e₃), a reference
/// frame that is continuous through the joints, but for the half turns of the Frenet frame at
/// inflections:
///   f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃,  θ(0) = 0,  θ′ = −e₂′·e₃.
/// Through a corner (f₂, f₃) is carried by the least rotation of the tangent. So is the
/// Euler–Rodrigues frame; where (e₂, e₃) is not, as that of a vector, θ jumps, and at the joint it
/// is that of the later segment.
/// Along a PH curve it has a closed form, RmfAngle; along others its value is certain to any number
/// of digits. Copies are cheap and share what was found; any thread may ask them. To move one is to
/// copy it.
class PHRAME_API PathAngle {
 public:
  /// The angle to the Euler–Rodrigues frame where all segments are PH curves, else to the frame of
  /// up_vector(path).
  explicit PathAngle(const Path& path);
  /// The angle to this frame; Reference::up is the frame of up_vector(path). Throws DomainError
  /// where a segment has no such frame: the Euler–Rodrigues frame where it is no PH curve, the
  /// Frenet frame on a straight line. Where the Frenet frame jumps at a joint, DomainError is
  /// thrown, too, or Undecided: that is decided exactly.
  PathAngle(const Path& path, Reference reference, Form form = Form::automatic);
  /// The angle to the frame of v. Throws as require_up_vector().
  PathAngle(const Path& path, const Vector<Rational>& v, Form form = Form::automatic);
  PathAngle(const PathAngle&) = default;
  PathAngle& operator=(const PathAngle&) = default;
  ~PathAngle() = default;

  const Path& path() const;     ///< along which it is
  Reference reference() const;  ///< the frame it is measured from
  /// v, where the angle is measured from the frame of v; else up_vector(path()), found in the first
  /// call.
  const Vector<Rational>& up() const;
  /// θ along segment k, counted from the start of that, if it is a PH curve; else null.
  const RmfAngle* closed_form(std::size_t k) const;
  /// Is θ seen to be 0 all along? So it is on a straight line, and on a plane path where v is
  /// normal to the plane.
  bool is_zero() const;

  /// Chooses the way to the values of closed forms from now on. Copies keep theirs.
  void set_route(Route route);

  /// θ(t) + start, exact where it is seen to be rational, also where contributions of several
  /// segments cancel. A single PH curve has values for all t; elsewhere DomainError is thrown for t
  /// outside [0, end].
  Real value(const Rational& t, const StartAngle& start = {}) const;
  /// The same at a place. A segment that is a PH curve is continued for t outside [0, 1]; on others
  /// DomainError is thrown.
  Real value(const Place& at, const StartAngle& start = {}) const;
  /// A ball around θ(at) with a radius ≤ 2^−bits · max(1, |θ(at)|); the sums up to the joints are
  /// kept.
  RealBall enclose(const Place& at, long bits) const;
  /// A ball around θ(at) + start, of which the radius is likewise, but greater where the two
  /// cancel.
  RealBall enclose(const Place& at, const StartAngle& start, long bits) const;
  /// θ′ = dθ/dt on that segment.
  RealBall rate(const Place& at, long bits) const;
  /// z ∈ ℚ(i) with e^{iθ} = z/|z|, where each segment up to there has an RmfAngle::direction().
  std::optional<GaussianRational> direction(const PathParameter& at) const;

  /// (θ(at) + offset + arg phase(1) − arg phase(0))/π where that is rational: decided or recognised
  /// as Evaluator::multiple_of_pi does. No value means that it is irrational or not recognised, as
  /// behind a segment that is no PH curve. The phase has no zero on [0, 1].
  std::optional<Rational> multiple_of_pi(const PathParameter& at, const GaussianPolynomial& phase,
                                         const Rational& offset = 0) const;

  /// The angle in (−π, π] by which the rotation-minimizing frame of a closed path comes back turned
  /// about the tangent T = r′/|r′|,
  ///   f₂(end) = cos(·) f₂(0) + sin(·) T × f₂(0).
  /// Where the path closes at a corner, the frame is carried through that. Exact where it is seen
  /// to be 0; where it is not told from ±π, it is next to π. No value where the path is not closed
  /// with its e₁. Throws DomainError for the angle to a Frenet frame.
  std::optional<Real> holonomy() const;
  /// Where a closed path closes at a corner, the amount by which θ is greater behind that. It is 0
  /// without such a corner, and for the angle to the Euler–Rodrigues frame, which
  /// Path::closing_turn() takes care of.
  Real turn_of_ends() const;

 private:
  struct State;  ///< the angles of the segments, and what is known of their sums

  Real exact_value(const PathParameter& at, const FrameAngle& start) const;
  Real value_after(std::size_t joint, const Rational& theta, const PathParameter& at,
                   const FrameAngle& start) const;
  Real value_after_last_joint(const PathParameter& at, const FrameAngle& start) const;
  std::optional<Real> holonomy_to_erf() const;

  std::shared_ptr<State> state_;
};

/// The frame that angles along the path are measured from: that of v where there is a v, else the
/// one that is asked for, else the one that PathAngle(path) takes.
PHRAME_API Reference reference_of(const Path& path, const std::optional<Vector<Rational>>& v,
                                  std::optional<Reference> asked = std::nullopt);
/// The angle to that frame. Throws as the constructors.
PHRAME_API PathAngle angle_to(const std::optional<Vector<Rational>>& v, const Path& path,
                              std::optional<Reference> asked = std::nullopt,
                              Form form = Form::automatic);

}  // namespace phrame
