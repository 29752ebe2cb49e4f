#pragma once
#include <string>
#include <utility>

#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// A curve and what it is called.
struct NamedCurve {
  std::string name;  ///< may be empty
  Curve curve;
};

/// A path and what it is called; a curve is one.
struct NamedPath {
  std::string name;  ///< may be empty
  Path path;

  NamedPath(std::string its_name, Path its_path)
      : name(std::move(its_name)), path(std::move(its_path)) {}
  NamedPath(NamedCurve named)  // NOLINT(google-explicit-constructor)
      : NamedPath(std::move(named.name), std::move(named.curve)) {}
};

/// r′ and r(0) of a curve that may not be PH.
struct NamedHodograph {
  std::string name;
  Vector<Polynomial> hodograph;  ///< not 0
  Vector<Rational> start;
};

}  // namespace phrame
