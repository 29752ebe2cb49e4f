#pragma once
#include <string>

#include "phrame/ph/curve/spline.hpp"

namespace phrame {

/// A curve and what it is called.
struct NamedCurve {
  std::string name;  ///< may be empty
  Curve curve;
};

struct NamedSpline {
  std::string name;  ///< may be empty
  Spline spline;
};

}  // namespace phrame
