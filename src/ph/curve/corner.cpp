// The least rotation R that takes â to b̂ takes S, normal to a, to
//   S − S·b̂/(1 + â·b̂)·(â + b̂) = S − S·b/s·(|a|·b̂ + a),  s = |a||b| + a·b,
// so that with T·b = 0
//   s·T·RS = s·T·S − (S·b)(T·a),  s·(b × T)·RS = s·(b × T)·S − (S·b)((b × T)·a),
// where nothing is divided by a × b, which may be next to 0. The axis a × b is at rest: the angle
// is also that from T to it, about b, less that from S to it, about a, the arguments of
//   T·(a × b) − i|b|(T·a)  and  S·(a × b) + i|a|(S·b),
// which are algebraic angles.

#include "phrame/ph/curve/corner.hpp"

#include <algorithm>

#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Real angle_between(const Vector<Real>& a, const Vector<Real>& b) {
  const Vector<Real> axis = cross(a, b);
  const Real cosine = dot(a, b);
  const Real sine = dot(axis, axis);
  if (!cosine.exact() || !sine.exact()) return argument_of(cosine, square_root_of(sine));
  return argument_of(cosine, square_root_of(sine), [x = *cosine.exact(), d = *sine.exact()] {
    return AlgebraicAngle::argument(x, 1, d);
  });
}

Corner corner_between(const Path& path, std::size_t before, std::size_t after) {
  return {after, angle_between(direction(path, {before, Rational(1)}),
                               direction(path, {after, Rational(0)}))};
}

}  // namespace

std::vector<Corner> corners(const Path& path) {
  std::vector<Corner> found;
  for (const std::size_t k : path.corners()) found.push_back(corner_between(path, k - 1, k));
  if (closure(path).at_corner) found.push_back(corner_between(path, path.segments().size() - 1, 0));
  return found;
}

const Corner& greatest(const std::vector<Corner>& corners) {
  const auto size = [](const Corner& corner) { return approximate(corner.angle.enclose(64)); };
  return *std::max_element(corners.begin(), corners.end(),
                           [&](const Corner& a, const Corner& b) { return size(a) < size(b); });
}

Real carried_angle(const Vector<Real>& a, const Vector<Real>& S, const Vector<Real>& b,
                   const Vector<Real>& T) {
  const Real squared_a = dot(a, a);
  const Real squared_b = dot(b, b);
  const Real s = square_root_of(squared_a * squared_b) + dot(a, b);
  const Vector<Real> third = cross(b, T);
  const Real across = dot(S, b);
  const Real x = s * dot(S, T) + -(across * dot(T, a));
  const Real y = over_square_root(s * dot(S, third) + -(across * dot(third, a)), squared_b);
  const auto exact_a = exactly(a);
  const auto exact_b = exactly(b);
  const auto exact_S = exactly(S);
  const auto exact_T = exactly(T);
  if (!exact_a || !exact_b || !exact_S || !exact_T) return argument_of(x, y);
  const auto known = [a = *exact_a, b = *exact_b, S = *exact_S, T = *exact_T] {
    const Vector<Rational> axis = cross(a, b);
    return AlgebraicAngle::argument(dot(T, axis), -dot(T, a), dot(b, b)) +
           -AlgebraicAngle::argument(dot(S, axis), dot(S, b), dot(a, a));
  };
  return argument_of(x, y, known);
}

}  // namespace phrame
