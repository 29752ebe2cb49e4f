#pragma once
#include <optional>
#include <string>
#include <vector>

#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/proof/closed_claims.hpp"

namespace phrame::inline v0 {

// The crossings of a closed path of PH curves, as docs/certificate.md proves them.

/// Why it is not proved that these are all crossings that are seen along v ≠ 0, in their boxes and
/// with their signs; empty where it is. Precondition: the path is closed, and no weight is 0 on it.
std::string objection_to_crossings(const std::vector<Curve>& segments, const Vector<Rational>& v,
                                   const std::vector<StatedCrossing>& crossings);

/// A place of a path.
struct ArcCentre {
  long segment;  ///< 0, 1, …
  Rational t;    ///< the parameter there
};
/// Boxes around the crossing that is near these places, as wide as they can be halved down to, with
/// its sign; no value where none is proved. Precondition: as above.
std::optional<StatedCrossing> box_around(const std::vector<Curve>& segments,
                                         const Vector<Rational>& v, const ArcCentre& first,
                                         const ArcCentre& second);

}  // namespace phrame
