#pragma once
#include <optional>
#include <string>
#include <vector>

#include "phrame/algebra/rational.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// A part of a segment.
struct StatedArc {
  long segment;    ///< 0, 1, …
  Rational lower;  ///< of its parameter
  Rational upper;  ///< likewise
  friend bool operator==(const StatedArc&, const StatedArc&) = default;
};

/// Two parts, the earlier one first, that cross once as they are seen along v.
struct StatedCrossing {
  StatedArc first;
  StatedArc second;
  int sign;  ///< that of det(r′(s), r′(t), r(s) − r(t)) there
  friend bool operator==(const StatedCrossing&, const StatedCrossing&) = default;
};

/// |holonomy − value| ≤ radius, up to whole turns.
struct HolonomyClaim {
  long turns;          ///< k, in θ(end) + 2·arctan(s/c) + 2πk
  std::string value;   ///< a decimal
  std::string radius;  ///< a decimal
  friend bool operator==(const HolonomyClaim&, const HolonomyClaim&) = default;
};

/// |writhe − value| ≤ radius.
struct WritheClaim {
  Vector<Rational> projection;            ///< v, nowhere along the tangent
  std::vector<StatedCrossing> crossings;  ///< all that are seen along v
  std::string value;                      ///< a decimal
  std::string radius;                     ///< a decimal
  friend bool operator==(const WritheClaim&, const WritheClaim&) = default;
};

/// What a certificate says of a closed path.
struct ClosedClaims {
  std::optional<HolonomyClaim> holonomy;
  std::optional<WritheClaim> writhe;
  friend bool operator==(const ClosedClaims&, const ClosedClaims&) = default;
};

}  // namespace phrame
