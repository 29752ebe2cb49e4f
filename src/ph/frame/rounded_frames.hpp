#pragma once
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

/// Correctly rounded rotation-minimizing frames at thousands of rational t, best in ascending
/// order: by the same polynomials where they are enough to round a component, else exactly. Not for
/// concurrent use: it keeps the last piece.
class RoundedFrames {
 public:
  /// `angle` is that of this curve relative to the ERF, start_angle that of the frame at t = 0.
  /// Throws as compiled_rotation does.
  RoundedFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                const FrameAngle& start_angle = {});

  /// The frame at t, in [from, to] or not. Throws as round_to_double does.
  Frame<double> at(const Rational& t);

 private:
  std::optional<Frame<RealBall>> enclose(const Rational& t);

  PiecewisePolynomial polynomials_;
  std::optional<std::size_t> last_;  ///< the number of the piece whose polynomials, exactly, are:
  std::array<BallPolynomial, 4> of_last_;
  Frames exact_;
  RmfAngle angle_;
  FrameAngle start_angle_;
};

}  // namespace phrame
