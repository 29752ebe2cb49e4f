#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/offset/envelope.hpp"

namespace phrame::inline v0 {

/// A spline of plane curves with radii near its data.
struct MinkowskiSpline {
  MedialAxis axis;      ///< the segments, one after the other
  Deviation deviation;  ///< proved: not less than the greatest distances from the data
};

/// A C¹ spline of Minkowski PH quintics through points (x, y, r) with derivatives: each segment
/// begins where the one before ends, with its derivative, exactly. f is the step of the parameter,
/// and the null factors w = (a, b) and v = (c, d) have Bernstein coefficients w₀, w₁, w₂, v₀, v₁,
/// v₂. The same data have a family of quintics with two free numbers [Kosinka, Jüttler 2009]: taken
/// is the one with
///   σ(w₀, v₂) = σ(w₂, v₀),  σ(w₀ + w₂, v₁) = σ(w₁, v₀ + v₂),  σ(w, v) = ½(ad + bc),
/// to 20 bits: backwards and after Lorentz transformations it is the same one, and with a constant
/// r a plane PH quintic. Exact where all square roots are rational, else within the tolerance.
/// Throws DomainError for a closed spline, a derivative that is 0 or timelike, x′² + y′² < r′², and
/// a segment that has none, Undecided where the tolerance is not reached.
PHRAME_API MinkowskiSpline minkowski_spline(const HermiteSpline& data, const Deviation& tolerance);

}  // namespace phrame
