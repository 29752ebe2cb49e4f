#pragma once
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "phrame/algebra/near_numbers.hpp"
#include "phrame/algebra/near_poles.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/frame/compiled_frame_rotation.hpp"

namespace phrame::inline v0 {

/// Rotation-minimizing frames along a path of PH curves in pairs of doubles, with what they are off
/// by: for tables too short for compiled polynomials, some microseconds a frame, where balls take
/// ten times as long, and exact fractions of a long path with rational frames a thousand times.
/// Any thread may ask.
class NearRotations {
 public:
  /// Precondition: θ is measured from the Euler–Rodrigues frame.
  NearRotations(PathAngle angle, StartAngle start);

  /// B of the frame at t on this segment, up to its sign. No value where doubles do not tell the
  /// poles of θ′, or are too small for numbers of the curve. Cost: in the first call, that of the
  /// poles of all segments up to there.
  std::optional<CompiledFrames::Rotation> at(std::size_t segment, const NearNumber& t) const;
  /// The frame there, every component correctly rounded. No value where B has none, and where
  /// doubles leave a rounding open.
  std::optional<Frame<double>> frame(std::size_t segment, const NearNumber& t) const;
  /// The same at t along the path. No value next to a joint, where t may be on either side of it.
  std::optional<Frame<double>> frame(const NearNumber& t) const;
  /// The frames at many t. The numbers of those that have none, ascending; what their frames are
  /// then is no matter.
  std::vector<std::size_t> frames(const NearNumbers& t, std::span<Frame<double>> found) const;
  /// The frame there by balls, where doubles do not do; no value where these leave a rounding open,
  /// as that of what is 0 or ±1: then only exact numbers decide.
  std::optional<Frame<double>> by_balls(const Place& at) const;

 private:
  using NearPolynomial = std::vector<NearNumber>;  // ascending

  /// θ = θ(0) + Σ 2 Re(c·log(1 − t/z)), and A.
  struct Segment {
    Quaternion<NearPolynomial> preimage;
    const std::vector<NearPole>* poles = nullptr;  ///< null where θ ≡ θ(0)
    NearNumber start;                              ///< θ(0) + start
    bool is_known = false;
    Lazy<CompiledFrames::Zeros> zeros;

    NearNumber theta(const NearNumber& t) const;
  };

  Segment made(std::size_t k) const;
  const Segment& segment(std::size_t k) const;

  PathAngle angle_;
  StartAngle start_;
  mutable std::mutex lock_;
  mutable std::deque<Segment> segments_;  ///< those that were asked for, and all before
};

/// Is θ measured from the Euler–Rodrigues frame, and do doubles tell its poles along a segment in
/// the middle, so that most frames have a value?
bool has_near_rotations(const PathAngle& angle);

}  // namespace phrame
