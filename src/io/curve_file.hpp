#pragma once
#include <string_view>

#include "phrame/ph/curve.hpp"

namespace phrame {

struct NamedCurve {
  std::string name;  ///< may be empty
  Curve curve;
};

struct CurveLimits {
  long max_degree = 1001;  ///< of the curve, 2m + 1 + deg f
};

/// Reads a curve/1 file (README, "Curve files"): `preimage`, `quaternions` or `hopf`, with `basis`
/// and optionally `name`, `start` and `multiplier` (in the same basis). Numbers are read exactly.
/// `note`, `family` and `expected` are remarks and are skipped.
/// Throws InputError; its place is a JSON pointer, or line:column where the JSON itself is broken.
NamedCurve read_curve(std::string_view text, const CurveLimits& limits = {});

}  // namespace phrame
