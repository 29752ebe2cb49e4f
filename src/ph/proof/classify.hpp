#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/control_cone.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/frame/erf_turning.hpp"
#include "phrame/ph/frame/rational_frame.hpp"

namespace phrame::inline v0 {

/// Of which kinds a curve is, with a witness of each: docs/classification.md.
struct Classification {
  std::vector<RealRoot> cusps;              ///< on [0, 1]
  std::vector<RealRoot> inflections;        ///< on [0, 1]
  std::optional<Vector<Rational>> line;     ///< its direction
  std::optional<Vector<Rational>> normal;   ///< of its plane
  std::optional<Helix> helix;               ///< with axis and angle; no value for plane curves
  std::optional<ControlCone> control_cone;  ///< of a cubic
  std::optional<DoublePh> double_ph;        ///< ρ as a constant times a square
  Polynomial content;  ///< gcd(x′, y′, z′); the hodograph is primitive where it is constant
  bool erf_is_rotation_minimizing;                              ///< h = 0
  std::variant<RationalFrame, NoRationalFrame> rational_frame;  ///< the frame, or why there is none
  ErfTurning erf_turning;  ///< how the Euler–Rodrigues frame turns
};

/// The answers to all questions, their witnesses checked by identities between polynomials and by
/// Sturm's theorem.
PHRAME_API Classification classify(const Curve& curve);

/// What is true of a path as a whole, and of each of its segments.
struct PathClassification {
  bool is_regular = true;                  ///< no segment has a cusp
  std::optional<Vector<Rational>> line;    ///< its direction, of the first segment
  std::optional<Vector<Rational>> normal;  ///< of the plane of all segments
  std::optional<ConstantAngle> helix;      ///< one axis and one angle for all segments, all PH
  bool erf_is_rotation_minimizing = true;  ///< h = 0 on all segments, all PH
  /// Each by itself; no value for one that is no PH curve.
  std::vector<std::optional<Classification>> segments;
};

/// Likewise checked; line and plane of a path with segments that are not PH are decided by the form
/// of these, direction_span().
PHRAME_API PathClassification classify(const Path& path);

}  // namespace phrame
