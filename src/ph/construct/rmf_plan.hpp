#pragma once
#include <optional>

#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/construct/rmf_septic.hpp"

namespace phrame::inline v0 {

// What is known of a spline with h ≡ 0 before numbers are rounded: which curve is where.

/// What a segment is.
enum class SegmentForm {
  line,   ///< A is constant
  plane,  ///< between parallel tangents, a plane quintic
  space   ///< a septic
};

/// A segment, and if it is a septic, which one.
struct SegmentPlan {
  SegmentForm form = SegmentForm::space;
  std::optional<SepticSection> section;  ///< of a septic, seen from preimage(derivative)
  double unit = 1;                       ///< its phase_unit
};

/// All segments, and how they depend on each other.
struct RmfPlan {
  std::vector<SegmentPlan> segments;
  /// Of each joint the first one of those before that have the same direction; after an end where
  /// the derivative is 0 the next one.
  std::vector<std::size_t> base;
  std::size_t closing = 0;  ///< the segment that closes the spline, if it is to be closed
};

/// With so many bits for what is known before doubles are taken. Throws Undecided where no septic
/// is found, with the segment.
RmfPlan rmf_plan(const HermiteSpline& data, const Deviation& tolerance, long bits);

/// From point k to the next, by the parameter.
Vector<Rational> mean_derivative(const HermiteSpline& data, std::size_t k);

}  // namespace phrame
