#pragma once
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/transform.hpp"

namespace phrame::test {

/// The curve on [0, 1], cut at these places.
inline Path cut(const Curve& curve, std::vector<Rational> at) {
  at.push_back(1);
  Path path(segment(curve, 0, at.front()));
  for (std::size_t k = 1; k < at.size(); ++k) path.append(segment(curve, at[k - 1], at[k]));
  return path;
}

/// The curves, each moved to where the one before ends.
inline Path chain(const std::vector<Curve>& curves) {
  Path path(curves.front());
  for (std::size_t k = 1; k < curves.size(); ++k)
    path.append(Curve(curves[k].preimage(), curves[k].multiplier(),
                      evaluate(position(path.segments().back()), 1)));
  return path;
}

/// r′ = (1 − t², 2t, 0) and three copies, each turned by a quarter: a closed plane curve, whose
/// tangent turns by 2·arctan t on each.
inline Path closed_loop() {
  const Polynomial half{Rational(1, 2)};
  return chain({Curve({{1}, {}, {}, {0, 1}}), Curve({{1, -1}, {}, {}, {1, 1}}, half),
                Curve({{0, -1}, {}, {}, {1}}), Curve({{-1, -1}, {}, {}, {1, -1}}, half)});
}

}  // namespace phrame::test
