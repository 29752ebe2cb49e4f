#pragma once
#include <memory>

#include "phrame/ph/curve/place.hpp"

namespace phrame {

/// The frame that the angle along a path of any kind is measured from.
enum class SmoothReference {
  up,      ///< e₂ = v × H/|v × H|, e₃ = e₁ × e₂, of an up vector v
  frenet,  ///< n = e₁′/|e₁′|, b = e₁ × n, continued through inflections
};

/// The angle θ of the rotation-minimizing frame along a path of any kind, relative to (e₂, e₃):
///   f₂ = cos θ e₂ + sin θ e₃,  f₃ = −sin θ e₂ + cos θ e₃,  θ(0) = 0,  θ′ = −e₂′·e₃.
/// It has no closed form; its value is certain to any number of digits. Copies are cheap and share
/// what was found; any thread may ask them. To move one is to copy it.
class SmoothAngle {
 public:
  /// To the frame of up_vector(path).
  explicit SmoothAngle(const Path& path);
  /// To that of v. Throws as require_up_vector().
  SmoothAngle(const Path& path, const Vector<Rational>& up);
  /// To the Frenet frame: throws DomainError for a straight line and as require_frenet_joints().
  /// Its up() is up_vector(path).
  SmoothAngle(const Path& path, SmoothReference reference);
  SmoothAngle(const SmoothAngle&) = default;
  SmoothAngle& operator=(const SmoothAngle&) = default;
  ~SmoothAngle() = default;

  const Path& path() const;            ///< along which it is
  const Vector<Rational>& up() const;  ///< v
  SmoothReference reference() const;   ///< the frame it is measured from
  /// Is it 0 all along, as in a plane with its normal for v, and on a straight line?
  bool is_zero() const;

  /// θ there; exact where it is 0 all along, and at the start. For t outside [0, 1] DomainError is
  /// thrown.
  Real value(const Place& at) const;
  /// A ball around θ with a radius ≤ 2^−bits · max(1, |θ|); the sums up to the joints are kept.
  RealBall enclose(const Place& at, long bits) const;
  /// θ′ = dθ/dt on that segment.
  RealBall rate(const Place& at, long bits) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

/// By which angle in (−π, π], or next to π where it is not told from that within 256 bits, the
/// rotation-minimizing frame comes back turned about the tangent r′/|r′| of a closed path: f₂(end)
/// = cos(·) f₂(0) + sin(·) T × f₂(0). Exact where θ is 0 all along. No value where the path is not
/// closed with its e₁. Throws DomainError for the angle to the Frenet frame.
std::optional<Real> holonomy(const SmoothAngle& angle);

}  // namespace phrame
