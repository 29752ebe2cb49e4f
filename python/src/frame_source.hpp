#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "parameters.hpp"

namespace phrame::python {

/// The coordinates of a point, at doubles.
using RoundedPoint = std::array<RoundedPolynomial, 3>;

/// Where a path of so many segments is at t in [0, segments]: the segment, and t in that, exactly.
std::pair<std::size_t, double> place_at(double t, std::size_t segments);

enum class FrameKind { rmf, erf, frenet };

/// The frames of a path, each as exactly as rounding wants, and their unit quaternions.
class FrameSource {
 public:
  FrameSource(Path path, FrameKind kind, const FrameAngle& start)
      : path_(std::move(path)), kind_(kind), start_(start) {}

  /// To be called once, before the others, which any thread may call.
  void prepare(const Parameters& at);

  Frame<double> frame(const Parameters& at, std::size_t k) const;
  /// (x, y, z, w); of a Frenet frame up to its sign.
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const;
  Vector<double> point(const Parameters& at, std::size_t k) const;

 private:
  /// B = A/|A|·e^{iφ}, φ half of θ + start, up to the sign that makes it continuous.
  std::array<Real, 4> rotation(const PathParameter& at) const;
  std::array<bool, 4> zeros() const;

  Path path_;
  FrameKind kind_;
  FrameAngle start_;
  std::vector<Vector<Polynomial>> positions_;
  std::vector<RoundedPoint> rounded_;
  std::vector<Frames> frames_;                   ///< of the segments
  std::vector<QuaternionPolynomial> preimages_;  ///< without real factors
  std::vector<int> signs_;                       ///< of the preimages
  std::optional<PathAngle> angle_;
  std::optional<CompiledFrames> compiled_;
  std::array<bool, 4> zeros_{};  ///< components u, v, p, q of B that are 0 everywhere
};

}  // namespace phrame::python
