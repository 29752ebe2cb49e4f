#pragma once
#include "phrame/algebra/error_free.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame {

/// Moving frames for millions of parameters, a few hundred operations each. Const
/// members may be called from several threads.
class CompiledFrames {
 public:
  /// The frame whose angle to the ERF is θ + start_angle, as in compiled_rotation.
  CompiledFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                 const FrameAngle& start_angle = {});
  /// The rotation-minimizing frame along a path, on [0, end]: its angle to the frame that θ is
  /// measured from is θ + start_angle. As in compiled_rotation.
  explicit CompiledFrames(const PathAngle& angle, const StartAngle& start_angle = {});
  /// The same of one segment k, on [k, k + 1].
  CompiledFrames(const PathAngle& angle, std::size_t segment, const StartAngle& start_angle);
  /// The Euler–Rodrigues frame, or that of Frenet continued through inflections, at t − origin, as
  /// in compiled_rotation.
  CompiledFrames(const Curve& curve, Reference reference, double from, double to,
                 double origin = 0);
  /// Whether a component of e₁, e₂, e₃ is known to be 0 for all t.
  using Zeros = std::array<std::array<bool, 3>, 3>;
  /// Of polynomials as of compiled_rotation, of compensated_shape(4).
  CompiledFrames(PiecewisePolynomial polynomials, const Zeros& zeros);

  /// The frame at t, every component within 2^−53 of the true one. Throws DomainError for a t
  /// outside [from, to] and NaN.
  Frame<double> operator()(double t) const;

  /// The frame at t with every component correctly rounded, to nearest with ties to even, where the
  /// polynomials are enough for that: all but about one in a million, but for components that are 0
  /// or nearly so. Those that are 0 everywhere, as on plane curves, are known. Throws as above.
  std::optional<Frame<double>> rounded(double t) const;

  /// B at t as sums of two doubles, off by at most the error, in the Euclidean norm. Throws as
  /// above.
  struct Rotation {
    Quaternion<DoubleDouble> b;  ///< B, a unit quaternion
    double error;                ///< of all components together
  };
  Rotation rotation(double t) const;  ///< that at t

  double from() const { return polynomials_.from(); }  ///< where they begin
  double to() const { return polynomials_.to(); }      ///< where they end

 private:
  /// What rounded() gives there.
  std::optional<Frame<double>> near_frame(const Rotation& at) const;
  static Zeros zeros(const Curve& curve, const RmfAngle& angle, const FrameAngle& start_angle);
  static Zeros zeros(const PathAngle& angle, std::size_t segment, const StartAngle& start_angle);
  static Zeros zeros(const PathAngle& angle, const StartAngle& start_angle);

  PiecewisePolynomial polynomials_;
  Zeros zeros_;
};

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
