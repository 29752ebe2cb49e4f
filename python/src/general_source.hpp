#pragma once
#include "frame_source.hpp"

namespace phrame::inline v0::python {

/// What frames of a path of any kind are asked for: where they start, by their kind.
struct GeneralFrames {
  FrameKind kind;
  FrameStart start;
  std::optional<Vector<Rational>> up;
  ParameterKind by = ParameterKind::t;
  friend bool operator==(const GeneralFrames&, const GeneralFrames&) = default;
};

/// The frames and points of a path of any kind, each as exactly as rounding wants. What is found is
/// kept for later calls, which may come from any thread.
class GeneralSource {
 public:
  /// Without an angle there are points only.
  GeneralSource(Parametrization along, std::optional<PathAngle> angle, FrameKind kind,
                StartAngle start);

  /// To be called before the others are asked for these parameters.
  void prepare(const Parameters& at);
  /// Has prepare() nothing left to do, and is hardly anything computed exactly?
  bool is_prepared(const Parameters& at) const;

  Vector<double> point(const Parameters& at, std::size_t k) const;
  Frame<double> frame(const Parameters& at, std::size_t k) const;
  /// (x, y, z, w), up to its sign.
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const;

 private:
  Place place(const Parameters& at, std::size_t k) const;
  void round_positions();
  Frame<Real> exact_frame(const Parameters& at, std::size_t k) const;

  Parametrization along_;
  Path path_;
  std::optional<PathAngle> angle_;
  FrameKind kind_;
  StartAngle start_;
  std::mutex lock_;  ///< while something is made
  std::size_t asked_ = 0;
  std::optional<CompiledFrames> compiled_;
  std::vector<RoundedPoint> rounded_;
  std::atomic<bool> is_compiled_{false};
  std::atomic<bool> is_rounded_{false};
  bool is_undecided_ = false;
};
using GeneralSources = LastSources<GeneralSource, GeneralFrames>;

}  // namespace phrame::python
