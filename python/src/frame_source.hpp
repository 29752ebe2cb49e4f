#pragma once
#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "parameters.hpp"

namespace phrame::inline v0::python {

/// The coordinates of a point, at doubles.
using RoundedPoint = std::array<RoundedPolynomial, 3>;

/// Where a path of so many segments is at t in [0, segments]: the segment, and t in that, exactly.
std::pair<std::size_t, double> place_at(double t, std::size_t segments);

/// None is points only.
using FrameKind = std::optional<TabulatedFrame>;

/// What frames of a path are asked for.
struct FrameQuery {
  FrameKind kind;
  FrameStart start;  ///< of rotation-minimizing ones
  bool is_to_up;     ///< are angles to the frame of a vector, also where the path is of PH curves?
  std::optional<Vector<Rational>> up;
  ParameterKind by;
  friend bool operator==(const FrameQuery&, const FrameQuery&) = default;
};

/// The last few values that were asked for, by their keys. Any thread may ask.
template <class Key, class Value>
class LastFew {
 public:
  /// The one kept, or what `make` makes: without the lock, since it may let go of Python's, which
  /// those who wait for ours would hold. Of two that are made at once the first is kept.
  template <class Make>
  Value of(const Key& key, const Make& make) {
    if (auto known = kept(key)) return *std::move(known);
    Value made = make();
    const std::lock_guard guard(lock_);
    if (auto known = find(key)) return *std::move(known);
    constexpr std::size_t most = 4;
    if (kept_.size() == most) kept_.pop_front();
    return kept_.emplace_back(key, std::move(made)).second;
  }

 private:
  std::optional<Value> kept(const Key& key) {
    const std::lock_guard guard(lock_);
    return find(key);
  }
  std::optional<Value> find(const Key& key) const {
    for (const auto& [known, value] : kept_)
      if (known == key) return value;
    return std::nullopt;
  }

  std::mutex lock_;
  std::deque<std::pair<Key, Value>> kept_;
};

/// The frames and points of a path, each as exactly as rounding wants, and the unit quaternions of
/// the frames. Where t is asked for, a segment is compiled when that was often enough; what is
/// found is kept for later calls, which may come from any thread.
class FrameSource {
 public:
  /// The angle is needed for rotation-minimizing frames, and for those of its vector. Of PH curves
  /// angles are to the Euler–Rodrigues frame, if there is no other angle.
  FrameSource(Parametrization along, FrameKind kind, std::optional<PathAngle> angle,
              StartAngle start);

  /// To be called before the others are asked for these parameters.
  void prepare(const Parameters& at);
  /// Has prepare() nothing left to do, and is hardly a frame computed exactly? A few frames are as
  /// soon done by pairs of doubles or balls as another thread is woken; they are counted for
  /// prepare().
  bool is_prepared(const Parameters& at);

  Frame<double> frame(const Parameters& at, std::size_t k) const;
  /// Those from number `begin` on, as many as there is room for: many at once where they are
  /// compiled.
  void frames(const Parameters& at, std::size_t begin, std::span<Frame<double>> found) const;
  /// (x, y, z, w), up to its sign but for rotation-minimizing and Euler–Rodrigues frames of PH
  /// curves.
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const;
  Vector<double> point(const Parameters& at, std::size_t k) const;

 private:
  struct Piece;

  const Path& path() const { return along_.path(); }
  /// Are frames B i B*, B j B*, B k B* with a B that is known?
  bool are_by_preimage() const;
  Place place(const Parameters& at, std::size_t k) const;
  /// The parameter as that of compiled pieces.
  std::optional<double> near_parameter(const Parameters& at, std::size_t k) const;
  /// A point of a segment that is made, where it is polynomial.
  const std::optional<RoundedPoint>& rounded_point(std::size_t segment) const;
  void make();
  void make_zeros();
  void make_few();
  void compile(std::size_t k, double from, double to);
  void prepare_curve(const std::vector<double>& ts);
  const CompiledFrames* compiled_at(double t, const Piece& piece) const;
  std::optional<Frame<double>> approximated_frame(double t) const;
  /// So many frames of a segment are asked for before it pays to compile it.
  std::size_t least_of_frames() const;
  std::optional<CompiledFrames::Rotation> approximated_rotation(double t) const;
  Frame<Real> exact_frame(const Place& at) const;
  /// B = A/|A|·e^{iφ}, φ half of θ + start, with the sign that makes it continuous; of other frames
  /// up to its sign.
  std::array<Real, 4> rotation(const Place& at) const;
  /// The same by balls, of so many bits; no value of other frames.
  std::optional<Quaternion<RealBall>> ball_at(const Place& at, long bits = rotation_bits) const;

  Parametrization along_;
  FrameKind kind_;
  std::optional<PathAngle> angle_;
  StartAngle start_;
  std::optional<NearRotations> rotations_;  ///< of rotation-minimizing frames of PH curves
  bool is_of_ph_;    ///< PH curves, with angles to the Euler–Rodrigues frame
  std::mutex lock_;  ///< while something is made or compiled
  std::atomic<bool> is_made_{false};
  std::deque<Piece> pieces_;
  std::deque<CompiledFrames> compiled_;  ///< which do not move
  /// The last few that were not compiled, such as those at the ends, which are asked for again and
  /// again.
  mutable LastFew<double, Frame<double>> last_frames_;
};

/// Those of a path, by what they are of.
using FrameSources = LastFew<FrameQuery, std::shared_ptr<FrameSource>>;

/// A segment.
struct FrameSource::Piece {
  mutable std::once_flag has_rounded;  ///< which frames do not need
  mutable std::optional<RoundedPoint> rounded;
  // Of PH curves:
  const QuaternionPolynomial* preimage = nullptr;  ///< without real factors
  int sign = 1;                                    ///< of the preimage, for a continuous B
  std::optional<RoundedPolynomial> normal;    ///< the real factor of g, of whose sign Frenet's n is
  std::array<bool, 4> zeros{};                ///< components u, v, p, q of B that are 0 everywhere
  mutable std::atomic<std::size_t> asked{0};  ///< how often, up to now
  std::atomic<bool> is_undecided{false};  ///< it cannot be compiled: poles of θ′ are too near
  std::atomic<const CompiledFrames*> compiled{nullptr};
};

}  // namespace phrame::python
