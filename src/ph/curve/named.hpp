#pragma once
#include <string>
#include <utility>
#include <vector>

#include "phrame/ph/curve/frame_through.hpp"
#include "phrame/ph/curve/nearness.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// A curve and what it is called.
struct NamedCurve {
  std::string name;  ///< may be empty
  Curve curve;       ///< the curve
  /// How near it is to the one in whose place it stands, where that is no PH curve.
  std::optional<Nearness> near = {};
};

/// A path and what it is called; a curve is one.
struct NamedPhPath {
  std::string name;  ///< may be empty
  PhPath path;       ///< the path
  /// How near it is to the one in whose place it stands, where that is no PH path.
  std::optional<Nearness> near = {};
  std::vector<std::string> notes = {};     ///< on how it was read, in sentences without a point
  std::optional<FrameThrough> frame = {};  ///< the orientations that come with it

  /// A path under this name.
  NamedPhPath(std::string its_name, PhPath its_path, std::optional<Nearness> to_another = {})
      : name(std::move(its_name)), path(std::move(its_path)), near(std::move(to_another)) {}
  /// The path of one segment, under the name of the curve.
  NamedPhPath(NamedCurve named)  // NOLINT(google-explicit-constructor)
      : NamedPhPath(std::move(named.name), std::move(named.curve), std::move(named.near)) {}
};

/// r′ and r(0) of a curve that may not be PH.
struct NamedHodograph {
  std::string name;              ///< may be empty
  Vector<Polynomial> hodograph;  ///< not 0
  Vector<Rational> start;        ///< r(0)
};

}  // namespace phrame
