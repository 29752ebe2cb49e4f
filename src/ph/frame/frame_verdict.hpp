#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// What somebody says a frame is at t, not necessarily orthonormal.
struct GivenFrame {
  Rational t;                                              ///< a parameter of the path
  Vector<Rational> f2;                                     ///< of any length
  std::optional<Vector<Rational>> f3 = std::nullopt;       ///< where it is given
  std::optional<Vector<Rational>> tangent = std::nullopt;  ///< where it is given
};

/// Which of the two unit vectors along the tangent is T.
enum class Forward {
  motion,    ///< r′/|r′|
  preimage,  ///< the e₁ of our own frames, A i A*/|A|²: its opposite where f < 0
};

/// Balls around what is exact: the given frame against T and the normal plane of the curve at t,
/// with (e₁, e₂, e₃) the frame that angles are measured from.
struct FrameDeviation {
  Vector<RealBall> e1;  ///< of length 1
  /// f₂, projected to the normal plane, has this angle in (e₂, e₃); no value where the projection
  /// is 0. Up to whole turns.
  std::optional<RealBall> f2;
  RealBall theta;  ///< the angle of the rotation-minimizing frame there, θ(0) = 0
  /// The angle from ±n to the projection of f₂; no value for a straight line and at inflections.
  std::optional<RealBall> from_normal;
  RealBall orthogonality;  ///< max |cos| of the angles between T, f₂ and f₃
  RealBall length;         ///< max | |f| − 1 | over the vectors given
  /// The sine of the angle between the given tangent and ±T; 0 where none is given, 1 where it is
  /// 0.
  RealBall tangent_sine;
  bool is_reversed = false;  ///< is (given tangent)·T < 0?
  /// The sign of det(given tangent, f₂, f₃), with T where none is given; 0 without f₃.
  int handedness = 0;
};

/// A fault of given frames, and the samples that have it.
struct FrameFinding {
  /// What it is.
  enum class Kind {
    undefined,         ///< f₂ is 0 or along the tangent
    wrong_tangent,     ///< the given tangent is another
    reversed_tangent,  ///< it is the opposite
    left_handed,       ///< the handedness is −1
    not_orthogonal,
    not_unit,
    flip,              ///< f₂ turns by more than 3 radians from the sample before
    constant_offset,   ///< the frame is rotation-minimizing, but starts at another angle
    frenet,            ///< f₂ keeps its angle to the principal normal, up to flips
    euler_rodrigues,   ///< to e₂ of the Euler–Rodrigues frame
    turned_backwards,  ///< it is the reference frame turned by −θ instead of θ
    fixed_up,          ///< f₂ keeps its angle to v × T of a fixed vector v
    other_start,       ///< the first sample is not at the start angle
    drift,      ///< f₂ turns away, more or less steadily, from the first sample to the last
    irregular,  ///< f₂ turns to and fro, or jumps
  };
  Kind kind;                              ///< what is wrong
  std::vector<std::size_t> samples = {};  ///< the numbers of the frames, from 0
  /// For constant_offset and other_start the offset; for drift the angle by which f₂ turns from the
  /// first sample to the last; for irregular the range of the errors.
  std::optional<RealBall> amount = std::nullopt;
  /// For the kinds from constant_offset to fixed_up: the greatest angle of f₂ to a frame of that
  /// kind.
  std::optional<RealBall> residual = std::nullopt;
  /// v of fixed_up, and of turned_backwards where the reference frame is that of v.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Frames are recognised as of some kind where that is proved to within this angle in radians, and
/// to within 1/100 of what it is to explain, the offset or the range of the errors. The tolerance
/// of the verdict does not matter.
inline const Rational recognition_tolerance{1, 100'000};

/// The verdict on frames. Its lists have one element for each frame.
struct FrameVerdict {
  bool passes;  ///< is everything within the tolerance?
  /// The angle of f₂ to the exact f₂, in balls around numbers of about [−π, π]; no value where f₂
  /// is undefined.
  std::vector<std::optional<RealBall>> errors;
  std::vector<FrameDeviation> deviations;  ///< of each frame
  RealBall max_error;                      ///< of |error|
  std::size_t worst_sample;  ///< a sample where it is reached, as far as the balls tell
  RealBall orthogonality;    ///< the largest
  RealBall length;           ///< the largest
  /// The angle by which f₂ turns from the first sample to the last, over the arc length. From
  /// sample to sample it turns by less than half a turn; flips are left out.
  std::optional<RealBall> drift;
  /// The faults. Frames that pass and need no remark have none.
  std::vector<FrameFinding> findings;
};

/// The number of different t. With one t and no start angle nothing is compared: the first sample
/// agrees with itself.
PHRAME_API std::size_t number_of_parameters(const std::vector<GivenFrame>& frames);

/// The exact frames that others are compared with.
struct ExactFrames {
  /// Of a frame, in balls with a radius of about 2^−bits.
  std::function<FrameDeviation(const GivenFrame&, long bits)> deviation;
  /// The arc length from t = a to b; no value where it is not known, or not told from 0.
  std::function<std::optional<RealBall>(const Rational& a, const Rational& b, long bits)> length;
  /// v, where angles are those to its frame; else they are those to the Euler–Rodrigues frame.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Judges frames as check_frames() does; `start` is the angle θ(0) of the rotation-minimizing frame
/// that they are compared with, or none. Throws Undecided where 4096 bits do not tell a number from
/// the tolerance. Precondition: there is at least one frame.
PHRAME_API FrameVerdict judge_frames(const ExactFrames& exact,
                                     const std::vector<GivenFrame>& frames,
                                     const std::optional<Real>& start, const Rational& tolerance);

}  // namespace phrame
