#pragma once
#include "phrame/ph/offset/gauge.hpp"
#include "phrame/ph/offset/offset.hpp"
#include "phrame/ph/offset/offset_kind.hpp"

namespace phrame::inline v0 {

/// The offsets r + d·U(φ(t)) of a path under a gauge, U′(φ) ∥ r′ with U(φ) to the right of e₁: they
/// are that by d > 0 to the right of travel and for d < 0 to the left, as those by a distance,
/// which they are for the unit circle. r_d′ is along r′.
class PHRAME_API GaugeOffsets {
 public:
  /// A segment of which the offsets are not rational over ℚ.
  struct None {
    std::size_t segment;        ///< which
    std::vector<long> degrees;  ///< those of the factors of r′ × U′ in φ
    /// Over which field they are rational, or both together, where the φ of both sides are the
    /// zeros of a factor of degree 2: D is that of its discriminant.
    std::optional<OffsetKind> kind = {};
  };

  /// Of a path of polynomial or rational curves in planes z = const, PH or not. Throws DomainError
  /// for others, naming the segment. Cost: a factorization for each segment.
  GaugeOffsets(const Path& path, Gauge gauge);

  const std::vector<None>& none() const { return none_; }  ///< ascending; for every d
  /// That of all others, cut where there is none, with H along e₁. On the outer side of a corner it
  /// is joined: `round` by the arc of the gauge about the corner, from where its tangent is that
  /// before to where it is that behind the corner; `mitre` by these tangents. Throws DomainError
  /// for d = 0.
  Offset at(const Rational& d, OffsetJoin join = OffsetJoin::round) const;
  /// @{ The arcs of d·U about the end of the path, on from where the offset at d ends, and about
  /// its start, up to where that starts: on the side to which the path does not go. Precondition:
  /// the segment there has an offset.
  std::vector<RationalCurve> end_cap(const Rational& d) const;
  std::vector<RationalCurve> start_cap(const Rational& d) const;
  /// @}

 private:
  struct State;
  std::shared_ptr<const State> state_;
  std::vector<None> none_;
};

}  // namespace phrame
