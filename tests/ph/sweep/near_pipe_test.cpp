#include "phrame/ph/sweep/near_pipe.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/tangent_path.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/rational_sweep.hpp"
#include "support/paths.hpp"
#include "support/surface_point.hpp"

using namespace phrame;

namespace near_pipe_test {

/// A line, an arc of 60° between directions of the length √2, by weights over ℚ, and a line.
Path bent_pipe() {
  Path path(bezier_curve({{-4, -4, 0}, {-1, -1, 0}}));
  path.append(bezier_curve({{-1, -1, 0}, {0, 0, 0}, {0, 1, 1}}, {4, 3, 3}));
  path.append(bezier_curve({{0, 1, 1}, {0, 3, 3}}));
  return path;
}

const Rational tiny = power_of_ten(-25);

}  // namespace near_pipe_test

using namespace near_pipe_test;

// Places are compared at the same t, and lengths with the Pythagorean theorem.
TEST_CASE("near pipe: lines and arcs stay where they are, and have tangents in fractions") {
  const Path given = bent_pipe();
  CHECK_THROWS_AS(path_with_tangents(given), DomainError);
  const auto [path, distance] = near_pipe(given);
  CHECK(distance < tiny);
  CHECK(path.corners().empty());
  CHECK(path_with_tangents(path).segments().size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
      const Vector<Rational> off = point(*rational_curve(path.segments()[k]), t) -
                                   point(*rational_curve(given.segments()[k]), t);
      CHECK(dot(off, off) <= distance * distance);
    }
}

// The first line is along (1, 1, 0), so that points at 1/4 from it have the square distance
// |P|² − (x + y)²/2 = 1/16, and those of the last one likewise.
TEST_CASE("near pipe: its body is bounded by cylinders and tori but for what was rounded") {
  const Path path = near_pipe(bent_pipe()).path;
  const auto frames = rational_rmf(path_with_tangents(path), LeastRotation());
  const RationalSurface surface = rational_sweep(path, frames, {circle_curve(Rational(1, 4))});
  CHECK(surface.patches.size() == 12);
  for (const SurfacePatch& patch : surface.patches) {
    if (patch.from == 1) continue;
    for (const Rational& s : {Rational(0), Rational(2, 3)}) {
      const auto [x, y, z] = test::point(patch, Rational(1, 3), s);
      const Rational along = patch.from == 0 ? Rational(x + y) : Rational(y + z);
      const Rational square = x * x + y * y + z * z - along * along / 2;
      CHECK(abs(square - Rational(1, 16)) < tiny);
    }
  }
}

TEST_CASE("near pipe: what is no smooth path of lines and arcs is far from it, or refused") {
  CHECK(near_pipe(test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})).distance > Rational(1, 2));
  CHECK_THROWS_AS(near_pipe(Path(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 1}}))),
                  DomainError);
  // A parabola.
  CHECK(near_pipe(Path(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}))).distance >
        Rational(1, 100));
}
