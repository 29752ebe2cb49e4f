#pragma once
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

/// The rotation-minimizing frame at the points of a motion along a path. e₁ is exact where it is
/// rational and known to be; of the other vectors at an irrational t nothing is known but
/// enclosures.
class MovingFrame {
 public:
  /// Throws DomainError as start_angle(). Cost: the antiderivative of θ.
  MovingFrame(const PhPath& path, const FrameStart& start);

  /// e₁ = A i A*/σ there.
  Vector<Real> tangent(const Place& at) const;
  /// (e₁, f₂, f₃) there.
  Frame<Real> at(const Place& at) const;

 private:
  PathAngle angle_;
  Real start_;
  std::vector<Frame<RationalFunction>> frames_;  ///< of Euler–Rodrigues, along the segments
};

}  // namespace phrame
