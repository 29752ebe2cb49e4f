#pragma once
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/transform.hpp"

namespace phrame::inline v0::test {

/// The curve on [0, 1], cut at these places.
inline PhPath cut(const Curve& curve, std::vector<Rational> at) {
  at.emplace_back(1);
  PhPath path(segment(curve, 0, at.front()));
  for (std::size_t k = 1; k < at.size(); ++k) path.append(segment(curve, at[k - 1], at[k]));
  return path;
}

/// The same path by its positions, as if it were not known to be PH. Its e₁ is that of the path, or
/// the opposite everywhere.
inline Path by_positions(const PhPath& path) {
  std::vector<Segment> segments;
  for (const Curve& curve : path.segments()) segments.emplace_back(RationalCurve(position(curve)));
  return joined(std::move(segments));
}

/// The curves, each moved to where the one before ends.
inline PhPath chain(const std::vector<Curve>& curves) {
  PhPath path(curves.front());
  for (std::size_t k = 1; k < curves.size(); ++k)
    path.append(Curve(curves[k].preimage(), curves[k].multiplier(),
                      evaluate(position(path.segments().back()), 1)));
  return path;
}

/// The lines from point to point, as curves of any kind.
inline Path polygon(const std::vector<Vector<Rational>>& points) {
  std::vector<Segment> lines;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    lines.emplace_back(bezier_curve({points[k], points[k + 1]}));
  return joined(lines);
}

/// r′ = (1 − t², 2t, 0) and three copies, each turned by a quarter: a closed plane curve, whose
/// tangent turns by 2·arctan t on each.
inline PhPath closed_loop() {
  const Polynomial half{Rational(1, 2)};
  return chain({Curve({{1}, {}, {}, {0, 1}}), Curve({{1, -1}, {}, {}, {1, 1}}, half),
                Curve({{0, -1}, {}, {}, {1}}), Curve({{-1, -1}, {}, {}, {1, -1}}, half)});
}

/// Four copies of A = B² (1, 1 + 2i + 19/13 j + k, (1 + k)(2 + i)), each turned by a quarter about
/// z: a closed curve in space with a continuous tangent.
inline std::vector<Curve> quarters() {
  const Curve first({from_bernstein({1, 1, 2}), from_bernstein({0, 2, 1}),
                     from_bernstein({0, Rational(19, 13), 1}), from_bernstein({0, 1, 2})});
  std::vector<Curve> curves{first};
  while (curves.size() < 4)
    curves.push_back(scaled(rotated(curves.back(), {1, 0, 0, 1}), Rational(1, 2)));
  return curves;
}

}  // namespace phrame::test
