#pragma once
#include <string>
#include <utility>

#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// A curve and what it is called.
struct NamedCurve {
  std::string name;  ///< may be empty
  Curve curve;       ///< the curve
};

/// A path and what it is called; a curve is one.
struct NamedPath {
  std::string name;  ///< may be empty
  Path path;         ///< the path

  /// A path under this name.
  NamedPath(std::string its_name, Path its_path)
      : name(std::move(its_name)), path(std::move(its_path)) {}
  /// The path of one segment, under the name of the curve.
  NamedPath(NamedCurve named)  // NOLINT(google-explicit-constructor)
      : NamedPath(std::move(named.name), std::move(named.curve)) {}
};

/// r′ and r(0) of a curve that may not be PH.
struct NamedHodograph {
  std::string name;              ///< may be empty
  Vector<Polynomial> hodograph;  ///< not 0
  Vector<Rational> start;        ///< r(0)
};

}  // namespace phrame
