#pragma once
#include <memory>

#include "phrame/export.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame {

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
  /// To the Euler–Rodrigues frame, where all segments are PH curves, else to that of up_vector().
  explicit PathAngle(const Path& path);
  /// To this frame; that of a vector is that of up_vector(path). Throws DomainError where a segment
  /// has none: the Euler–Rodrigues frame where it is no PH curve, that of Frenet on a straight
  /// line; and where the Frenet frame jumps at a joint, which is decided exactly, or Undecided.
  PathAngle(const Path& path, Reference reference, Form form = Form::automatic);
  /// To the frame of v. Throws as require_up_vector().
  PathAngle(const Path& path, const Vector<Rational>& v, Form form = Form::automatic);
  PathAngle(const PathAngle&) = default;
  PathAngle& operator=(const PathAngle&) = default;
  ~PathAngle() = default;

  const Path& path() const;     ///< along which it is
  Reference reference() const;  ///< the frame it is measured from
  /// v: of the frame it is measured from, or else up_vector(path()), found in the first call.
  const Vector<Rational>& up() const;
  /// θ along segment k, counted from its start, where that is a PH curve; null where it is none.
  const RmfAngle* closed_form(std::size_t k) const;
  /// Is it seen to be 0 all along, as in a plane with its normal for v, and on a straight line?
  bool is_zero() const;

  /// The way to the values of closed forms from now on; that of copies stays.
  void set_route(Route route);

  /// θ(t) + start, exact where it is seen to be rational; also where the contributions of different
  /// segments cancel. A PH curve by itself goes on for all t; for t outside [0, end] of another
  /// path DomainError is thrown.
  Real value(const Rational& t, const StartAngle& start = {}) const;
  /// The same; a PH curve is continued for a t outside [0, 1], for others DomainError is thrown.
  Real value(const Place& at, const StartAngle& start = {}) const;
  /// A ball around θ(at) with a radius ≤ 2^−bits · max(1, |θ(at)|); the sums up to the joints are
  /// kept.
  RealBall enclose(const Place& at, long bits) const;
  /// Around θ(at) + start, likewise but for what the two cancel.
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

  /// By which angle in (−π, π], or next to π where it is not told from that, the
  /// rotation-minimizing frame comes back turned about the tangent r′/|r′| of a closed path, where
  /// it closes at a corner carried through that:
  /// f₂(end) = cos(·) f₂(0) + sin(·) T × f₂(0). Exact where it is seen to be 0. No value where the
  /// path is not closed with its e₁. Throws DomainError for the angle to a Frenet frame.
  std::optional<Real> holonomy() const;
  /// By what θ is greater behind the corner where the ends of a closed path meet; 0 where there is
  /// none, and to the Euler–Rodrigues frame, for which Path::closing_turn() says it.
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

/// The frame that angles along the path are measured from: that of v where there is one, else the
/// one that is asked for, else as PathAngle(path) has it.
PHRAME_API Reference reference_of(const Path& path, const std::optional<Vector<Rational>>& v,
                                  std::optional<Reference> asked = std::nullopt);
/// The angle to that frame. Throws as the constructors.
PHRAME_API PathAngle angle_to(const std::optional<Vector<Rational>>& v, const Path& path,
                              std::optional<Reference> asked = std::nullopt,
                              Form form = Form::automatic);

}  // namespace phrame
