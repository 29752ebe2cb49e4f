#pragma once
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/frame/erf_turning.hpp"
#include "phrame/ph/frame/rational_frame.hpp"

namespace phrame {

struct Classification {
  std::vector<RealRoot> cusps;
  std::vector<RealRoot> inflections;
  std::optional<Vector<Rational>> line;    ///< its direction
  std::optional<Vector<Rational>> normal;  ///< of its plane
  std::optional<Helix> helix;
  std::optional<DoublePh> double_ph;
  Polynomial content;
  bool erf_is_rotation_minimizing;  ///< h = 0
  std::variant<RationalFrame, NoRationalFrame> rational_frame;
  ErfTurning erf_turning;
};

/// The answers to all questions, their witnesses checked by identities between polynomials and by
/// Sturm's theorem.
Classification classify(const Curve& curve);

}  // namespace phrame
