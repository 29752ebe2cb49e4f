#pragma once
#include <array>
#include <vector>

#include "phrame/ph/sweep/sweep_form.hpp"
#include "phrame/ph/sweep/sweep_turn.hpp"

namespace phrame::inline v0 {

/// λ and its first two derivatives.
class ScaleRates {
 public:
  ScaleRates(const SweepScale& scale, std::size_t segments);
  /// Of the absolute value of a derivative, of order 0 to 2, on a segment around t of it, above.
  double bound(std::size_t order, std::size_t segment, const RealBall& t) const;
  /// A derivative at t of a segment, rounded.
  double at(std::size_t order, std::size_t segment, double t) const;

 private:
  const RationalFunction& derivative(std::size_t order, std::size_t segment) const {
    return derivatives_[derivatives_.size() == 1 ? 0 : segment][order];
  }
  /// Of each segment; one for all where they are the same.
  std::vector<std::array<RationalFunction, 3>> derivatives_;
};

/// Bounds of how fast a path, and a profile along it, change on a part; derivatives are by t.
struct SweepRates {
  double speed;                 ///< |r′|
  double acceleration;          ///< |r″|
  double tangent;               ///< |T′|, T the unit tangent
  double tangent2;              ///< |T″|
  std::array<double, 3> scale;  ///< λ, |λ′|, |λ″|
  double turn;                  ///< |φ′|, φ the angle by which the profile turns
  double turn2;                 ///< |φ″|
};

/// By balls around all t of the part; no value where r′ may be 0, but for cusps it goes through.
std::optional<SweepRates> sweep_rates(const SweepPath& path, const ScaleRates& scale,
                                      const SweepTurn& turn, const SweepPart& part);

/// As far as an edge along the path, between the corners of two sections, is from the surface at
/// most, no corner of the profile being farther from the path than `reach` where λ = 1.
double edge_error(const SweepRates& rates, double reach, double step);

/// Parts of all segments on which T is defined and edges are within the tolerance.
struct SweepParts {
  std::vector<SweepPart> parts;
  double error = 0;  ///< of the edges
};
/// Throws Undecided where r′ is not told from 0, as where the curve turns back in a cusp, and for
/// too small a tolerance.
SweepParts sweep_parts(const SweepPath& path, const ScaleRates& scale, const SweepTurn& turn,
                       double reach, double tolerance);

/// Bounds in doubles are of some ten operations on positive numbers.
constexpr double sweep_slack = 1 + 0x1p-40;
constexpr std::size_t most_sweep_points = 20'000'000;

}  // namespace phrame
