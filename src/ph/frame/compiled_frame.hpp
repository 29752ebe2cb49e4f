#pragma once
#include <memory>
#include <span>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {

class PiecewisePolynomial;
struct NearNumber;
struct NearNumbers;

/// Moving frames for millions of parameters, a few hundred operations each. Const
/// members may be called from several threads.
class PHRAME_API CompiledFrames {
 public:
  /// The frame whose angle to the ERF is θ + start_angle, as in compiled_rotation.
  CompiledFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                 const FrameAngle& start_angle = {});
  /// The rotation-minimizing frame along a path, on [0, end]: its angle to the frame that θ is
  /// measured from is θ + start_angle. As in compiled_rotation.
  explicit CompiledFrames(const PathAngle& angle, const StartAngle& start_angle = {});
  /// The same frame of segment k alone, on [k, k + 1].
  CompiledFrames(const PathAngle& angle, std::size_t segment, const StartAngle& start_angle);
  /// The Euler–Rodrigues frame, or that of Frenet continued through inflections, at t − origin, as
  /// in compiled_rotation. Throws DomainError for Reference::up, and for the Frenet frame of a
  /// straight line.
  CompiledFrames(const Curve& curve, Reference reference, double from, double to,
                 double origin = 0);
  /// Whether a component of e₁, e₂, e₃ is known to be 0 for all t.
  using Zeros = std::array<std::array<bool, 3>, 3>;
  /// Those of the rotation-minimizing frame along segment k.
  static Zeros zeros(const PathAngle& angle, std::size_t segment, const StartAngle& start_angle);
  /// Frames by polynomials that compiled_rotation made, of compensated_shape(4). There are zeros()
  /// for all t, or for each [k, k + 1], k = 0, 1, ….
  CompiledFrames(PiecewisePolynomial polynomials, std::vector<Zeros> zeros);

  /// The frame at t, every component within 2^−53 of the true one. Throws DomainError for a t
  /// outside [from, to] and NaN.
  Frame<double> operator()(double t) const;
  /// The frames at many t, whatever their order, several at once by what the processor has for
  /// that. Each is rounded(t), where there is one. Throws as for one t, before anything is written,
  /// and DomainError where there are not as many frames as t.
  void operator()(std::span<const double> t, std::span<Frame<double>> frames) const;

  /// The frame at t with every component correctly rounded, to nearest with ties to even, where the
  /// polynomials are enough for that: all but about one in a million, but for components that are 0
  /// or nearly so. Those that are 0 everywhere, as on plane curves, are known. Throws as above.
  std::optional<Frame<double>> rounded(double t) const;
  /// The same at many t as above. The numbers of those that have none, ascending; what their frames
  /// are then is no matter.
  std::vector<std::size_t> rounded(std::span<const double> t,
                                   std::span<Frame<double>> frames) const;
  /// The same at a t that need not be a double; no value outside of [from, to].
  std::optional<Frame<double>> rounded(const NearNumber& t) const;
  /// The same at many t; throws DomainError where the high part of one is outside.
  std::vector<std::size_t> rounded(const NearNumbers& t, std::span<Frame<double>> frames) const;

  struct Rotation;  // ph/frame/compiled_frame_rotation.hpp
  /// The unit quaternion that the frame at t is made of. Throws as above.
  Rotation rotation(double t) const;

  double from() const;  ///< where they begin
  double to() const;    ///< where they end

 private:
  /// Which components are 0 where t is.
  const Zeros& zeros_at(double t) const;
  /// What rounded() gives at these t, in groups by the doubles `at`.
  template <class Numbers>
  std::vector<std::size_t> found_frames(std::span<const double> at, const Numbers& t,
                                        std::span<Frame<double>> frames) const;
  static Zeros zeros(const Curve& curve, const RmfAngle& angle, const FrameAngle& start_angle);
  static std::vector<Zeros> zeros(const PathAngle& angle, const StartAngle& start_angle);

  std::shared_ptr<const PiecewisePolynomial> polynomials_;
  std::vector<Zeros> zeros_;
};

}  // namespace phrame
