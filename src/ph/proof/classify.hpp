#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/frame/erf_turning.hpp"
#include "phrame/ph/frame/rational_frame.hpp"

namespace phrame {

/// The points of [0, 1] where r′ = 0, with the order of |r′| = |f|·σ. None on a regular curve.
std::vector<RealRoot> cusp_points(const Curve& curve);

/// The points of [0, 1] where the tangent stands still: the real zeros of g, those apart that only
/// a real factor of A brings. (n, b) flip at those of odd order. None for a straight line.
std::vector<RealRoot> inflections(const QuaternionPolynomial& a);

/// gcd(x′, y′, z′); constant for a primitive hodograph.
Polynomial hodograph_content(const Curve& curve);

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
