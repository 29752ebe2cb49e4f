#pragma once
#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "parameters.hpp"

namespace phrame::inline v0::python {

/// The coordinates of a point, at doubles.
using RoundedPoint = std::array<RoundedPolynomial, 3>;

/// Where a path of so many segments is at t in [0, segments]: the segment, and t in that, exactly.
std::pair<std::size_t, double> place_at(double t, std::size_t segments);

/// None is points only.
using FrameKind = std::optional<TabulatedFrame>;

/// The frames of a path of PH curves, each as exactly as rounding wants, and their unit
/// quaternions. A segment is compiled when it has been asked for often enough; what is found is
/// kept for later calls, which may come from any thread.
class FrameSource {
 public:
  FrameSource(PhPath path, FrameKind kind, const FrameAngle& start);

  /// To be called before the others are asked for these parameters.
  void prepare(const Parameters& at);
  /// Has prepare() nothing left to do, and is hardly a frame computed exactly? A few frames of a
  /// spline are as soon done by balls as another thread is woken; they are counted for prepare().
  bool is_prepared(const Parameters& at) const;

  Frame<double> frame(const Parameters& at, std::size_t k) const;
  /// (x, y, z, w); of a Frenet frame up to its sign.
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const;
  Vector<double> point(const Parameters& at, std::size_t k) const;

 private:
  struct Segment;

  void make();
  void make_zeros();
  void compile(std::size_t k, double from, double to);
  void prepare_curve(const std::vector<double>& ts);
  const CompiledFrames* compiled_at(double t, const Segment& segment) const;
  std::optional<Frame<double>> approximated_frame(double t) const;
  std::optional<CompiledFrames::Rotation> approximated_rotation(double t) const;
  /// B = A/|A|·e^{iφ}, φ half of θ + start, with the sign that makes it continuous; of a Frenet
  /// frame up to its sign.
  std::array<Real, 4> rotation(const PathParameter& at) const;
  /// The same by balls, but of no Frenet frame.
  Quaternion<RealBall> ball_at(const PathParameter& at) const;

  PhPath path_;
  FrameKind kind_;
  StartAngle start_;  ///< exact
  std::optional<PathAngle> angle_;
  std::mutex lock_;  ///< while something is made or compiled
  std::atomic<bool> is_made_{false};
  std::deque<Segment> segments_;
  std::deque<CompiledFrames> compiled_;  ///< which do not move
};

/// The last few sources of a path that were asked for, by what they are of. Any thread may ask.
template <class Source, class Key>
class LastSources {
 public:
  /// The one kept, or what `make` makes.
  template <class Make>
  std::shared_ptr<Source> of(const Key& key, const Make& make) {
    constexpr std::size_t most = 4;
    const std::lock_guard guard(lock_);
    for (const auto& [known, source] : kept_)
      if (known == key) return source;
    if (kept_.size() == most) kept_.pop_front();
    return kept_.emplace_back(key, make()).second;
  }

 private:
  std::mutex lock_;
  std::deque<std::pair<Key, std::shared_ptr<Source>>> kept_;
};
using FrameSources = LastSources<FrameSource, std::pair<FrameKind, FrameStart>>;

struct FrameSource::Segment {
  Vector<Polynomial> position;
  RoundedPoint rounded;
  Frames frames;
  QuaternionPolynomial preimage;              ///< without real factors
  int sign = 1;                               ///< of the preimage, for a continuous B
  RoundedPolynomial normal;                   ///< the real factor of g, of whose sign Frenet's n is
  std::array<bool, 4> zeros{};                ///< components u, v, p, q of B that are 0 everywhere
  mutable std::atomic<std::size_t> asked{0};  ///< how often, up to now
  std::atomic<bool> is_undecided{false};  ///< it cannot be compiled: poles of θ′ are too near
  std::atomic<const CompiledFrames*> compiled{nullptr};

  explicit Segment(const Curve& curve, FrameKind kind);
};

}  // namespace phrame::python
