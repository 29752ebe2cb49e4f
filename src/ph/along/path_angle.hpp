#pragma once
#include <memory>
#include <string>

#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame {

/// The angle θ of the rotation-minimizing frame along a path, relative to its Euler–Rodrigues
/// frame, which is continuous through the joints, or to the Frenet frame where that is, too, but
/// for the half turns of inflections: θ(0) = 0, θ continuous, θ′ that of RmfAngle. Copies are cheap
/// and share what was found; any thread may ask them. To move one is to copy it.
class PathAngle {
 public:
  /// Throws DomainError as RmfAngle, and where the Frenet frame jumps at a joint, which is decided
  /// exactly.
  explicit PathAngle(PhPath path, Reference reference = Reference::euler_rodrigues,
                     Form form = Form::automatic);
  PathAngle(const PathAngle&) = default;
  PathAngle& operator=(const PathAngle&) = default;
  ~PathAngle() = default;

  const PhPath& path() const;   ///< along which it is
  Reference reference() const;  ///< the frame it is measured from
  /// The angle along segment k, counted from its start.
  const RmfAngle& segment(std::size_t k) const;

  /// The way to the values of the segments from now on; that of copies stays.
  void take(Route route);

  /// θ(t) + start, exact where it is seen to be rational; also where the contributions of different
  /// segments cancel. Throws DomainError for t outside [0, end] of a
  /// spline.
  Real value(const Rational& t, const FrameAngle& start = {}) const;
  /// The same; at.t may be any number, with which the segment is continued.
  Real value(const PathParameter& at, const FrameAngle& start = {}) const;
  /// A ball around θ(at) with a radius ≤ 2^−bits · max(1, |θ(at)|); the sums up to the joints are
  /// kept. at.t may be any number.
  RealBall enclose(const PathParameter& at, long bits) const;
  /// Around θ(at) + start, likewise but for what the two cancel.
  RealBall enclose(const PathParameter& at, const FrameAngle& start, long bits) const;
  /// z ∈ ℚ(i) with e^{iθ} = z/|z|, where each segment up to there has an RmfAngle::direction().
  std::optional<GaussianRational> direction(const PathParameter& at) const;

  /// (θ(at) + offset + arg phase(1) − arg phase(0))/π where that is rational: decided or recognised
  /// as Evaluator::multiple_of_pi does. No value means that it is irrational or not recognised. The
  /// phase has no zero on [0, 1].
  std::optional<Rational> multiple_of_pi(const PathParameter& at, const GaussianPolynomial& phase,
                                         const Rational& offset = 0) const;

  /// By which angle in (−π, π] the rotation-minimizing frame comes back turned about the tangent
  /// r′/|r′| of a closed spline: f₂(end) = cos(·) f₂(0) + sin(·) T × f₂(0). It does not depend on
  /// the preimages. Exact where it is seen to be 0. No value where the spline has no
  /// closing_turn(). Throws DomainError for the angle to a Frenet frame.
  std::optional<Real> holonomy() const;

 private:
  struct State;  ///< the angles of the segments, and what is known of their sums

  Real value_after(std::size_t joint, const Rational& theta, const PathParameter& at,
                   const FrameAngle& start) const;
  Real value_after_last_joint(const PathParameter& at, const FrameAngle& start) const;

  std::shared_ptr<State> state_;
};

/// "Frenet frame: at the joint t = 2 it jumps, by 0.5 radians".
std::string frenet_jump(std::size_t joint, const Real& angle);

}  // namespace phrame
