#pragma once
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/frame/frame_verdict.hpp"

namespace phrame {

/// Compares frames with the exact ones of a spline, or of a curve as a spline of one segment. The
/// parameter of a spline of several segments is to be in [0, end], else DomainError.
class FrameCheck {
 public:
  /// Of the frames of this path.
  explicit FrameCheck(const PhPath& path);

  /// What the tangents given take for forward: the preimage if most of those where f < 0 do.
  Forward forward(const std::vector<GivenFrame>& frames) const;

  /// In balls with a radius of about 2^−bits. Where f changes its sign, T is either vector: the one
  /// that fits.
  FrameDeviation deviation(const GivenFrame& frame, Forward forward, long bits) const;

  /// The arc length from t = a to b, where f does not change sign on the way; no value else.
  std::optional<Rational> length(const Rational& a, const Rational& b) const;

 private:
  PathAngle angle_;
  std::vector<Frames> frames_;             ///< of the segments
  std::vector<GaussianPolynomial> bends_;  ///< g of their preimages
};

/// What frames are compared with, and how exactly.
struct FrameCheckOptions {
  /// Where the rotation-minimizing frame that the frames are compared with starts; an angle is that
  /// to e₂ of the Euler–Rodrigues frame, or of the frame of v where the path is no PH path. Without
  /// it, that frame agrees with the first sample.
  std::optional<FrameStart> start = std::nullopt;
  Rational tolerance{1, 1'000'000};  ///< for angles, cosines and lengths
  /// v, of paths that are not PH; one that does is chosen if there is none.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Is the sine of the angle between each tangent given and ±T within the tolerance? Exact, and much
/// faster than check_frames().
bool are_along_curve(const PhPath& path, const std::vector<GivenFrame>& frames,
                     const Rational& tolerance);

/// Where somebody says that the curve is at t.
struct GivenPosition {
  Rational t;          ///< a parameter of the path
  Vector<Rational> r;  ///< the place
};

/// Are these positions the curve's but for one translation, which takes the first to its place? To
/// within the tolerance times the way from the first to the farthest; where all are one place, they
/// are no sign of the curve. Exact.
bool are_on_curve(const PhPath& path, const std::vector<GivenPosition>& positions,
                  const Rational& tolerance);

/// A vector for each t.
using PointFunction = std::function<Vector<Rational>(const Rational& t)>;
/// @{ The same of any curve, by its tangent, of any length, and by its position.
bool are_along(const PointFunction& tangent_at, const std::vector<GivenFrame>& frames,
               const Rational& tolerance);
bool are_on(const PointFunction& position_at, const std::vector<GivenPosition>& positions,
            const Rational& tolerance);
/// @}

/// Judges frames: they pass where all angles, cosines and lengths are within the tolerance and no
/// frame is left-handed. First and last are those of the least and the largest t. Throws Undecided
/// where 4096 bits do not tell a number from the tolerance, and DomainError as start_angle() does.
/// Precondition: there is at least one frame.
FrameVerdict check_frames(const PhPath& path, const std::vector<GivenFrame>& frames,
                          const FrameCheckOptions& options = {});

}  // namespace phrame
