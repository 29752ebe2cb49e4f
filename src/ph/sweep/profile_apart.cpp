#include "phrame/ph/sweep/profile_apart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

constexpr double least_part = 0x1p-40;      ///< of the size of the profile
constexpr std::size_t most_pairs = 10'000;  ///< of boxes, of two rings

/// A part of a ring in the box of its control points, in doubles: rounding keeps the order of
/// numbers.
struct BoxedPiece {
  PlaneBezier curve;
  std::array<double, 2> low;
  std::array<double, 2> high;

  explicit BoxedPiece(PlaneBezier piece) : curve(std::move(piece)) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = high[axis] = round_to_double(curve.points.front()[axis]);
      for (const ProfilePoint& point : curve.points) {
        const double x = round_to_double(point[axis]);
        low[axis] = std::min(low[axis], x);
        high[axis] = std::max(high[axis], x);
      }
    }
  }

  double size() const { return std::max(high[0] - low[0], high[1] - low[1]); }
  bool is_apart_from(const BoxedPiece& other) const {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (high[axis] < other.low[axis] || other.high[axis] < low[axis]) return true;
    return false;
  }
};

/// By de Casteljau's algorithm at 1/2, in homogeneous coordinates.
std::pair<BoxedPiece, BoxedPiece> halves(const PlaneBezier& curve) {
  const std::size_t count = curve.points.size();
  std::vector<Rational> weights = curve.weights;
  std::vector<ProfilePoint> products;
  for (std::size_t k = 0; k < count; ++k)
    products.push_back({weights[k] * curve.points[k][0], weights[k] * curve.points[k][1]});
  PlaneBezier first;
  PlaneBezier second;
  const auto append = [&](PlaneBezier& half, std::size_t k) {
    half.points.push_back({products[k][0] / weights[k], products[k][1] / weights[k]});
    half.weights.push_back(weights[k]);
  };
  for (std::size_t left = count; left > 0; --left) {
    append(first, 0);
    append(second, left - 1);
    for (std::size_t k = 0; k + 1 < left; ++k) {
      weights[k] = (weights[k] + weights[k + 1]) / 2;
      for (std::size_t axis = 0; axis < 2; ++axis)
        products[k][axis] = (products[k][axis] + products[k + 1][axis]) / 2;
    }
  }
  return {BoxedPiece(std::move(first)), BoxedPiece(reversed(std::move(second)))};
}

using BoxedRingPieces = std::vector<BoxedPiece>;

/// Have the two rings no point in common? Not where parts meet that are not larger than `least`.
bool are_apart(const BoxedRingPieces& a, const BoxedRingPieces& b, double least) {
  std::size_t tried = 0;
  std::vector<std::pair<BoxedPiece, BoxedPiece>> left;
  for (const BoxedPiece& p : a)
    for (const BoxedPiece& q : b) {
      if (!p.is_apart_from(q)) left.emplace_back(p, q);
      while (!left.empty()) {
        auto [x, y] = std::move(left.back());
        left.pop_back();
        if (x.size() < y.size()) std::swap(x, y);
        if (x.size() <= least || ++tried > most_pairs) return false;
        auto [first, second] = halves(x.curve);
        if (!first.is_apart_from(y)) left.emplace_back(std::move(first), y);
        if (!second.is_apart_from(y)) left.emplace_back(std::move(second), std::move(y));
      }
    }
  return true;
}

}  // namespace

void require_rings_apart(const ProfileCurve& profile) {
  const auto& firsts = profile.rings();
  std::vector<BoxedRingPieces> rings(firsts.size());
  double size = 0;
  for (std::size_t ring = 0; ring < firsts.size(); ++ring) {
    const std::size_t end = ring + 1 < firsts.size() ? firsts[ring + 1] : profile.pieces().size();
    for (std::size_t k = firsts[ring]; k < end; ++k) {
      rings[ring].emplace_back(profile.pieces()[k]);
      size = std::max(size, rings[ring].back().size());
    }
  }
  for (std::size_t j = 0; j < rings.size(); ++j)
    for (std::size_t k = j + 1; k < rings.size(); ++k)
      if (!are_apart(rings[j], rings[k], least_part * size))
        throw Undecided(fmt::format(
            "profile: whether the outlines {} and {} meet is not told: they touch, or nearly so",
            j + 1, k + 1));
}

}  // namespace phrame
