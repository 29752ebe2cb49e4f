#include "phrame/ph/sweep/mesh.hpp"

#include <doctest/doctest.h>

using namespace phrame;

namespace {

Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

}  // namespace

TEST_CASE("mesh: a tetrahedron is watertight, a ball, and of the volume 1/6") {
  CHECK(is_watertight(tetrahedron()));
  CHECK(euler_characteristic(tetrahedron()) == 2);
  CHECK(volume(tetrahedron()) == doctest::Approx(1.0 / 6).epsilon(1e-15));
}

TEST_CASE("mesh: a hole, a triangle that is turned over, or there twice, is not watertight") {
  Mesh hole = tetrahedron();
  hole.triangles.pop_back();
  CHECK_FALSE(is_watertight(hole));
  Mesh turned = tetrahedron();
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  CHECK_FALSE(is_watertight(turned));
  Mesh twice = tetrahedron();
  for (const auto& triangle : tetrahedron().triangles) twice.triangles.push_back(triangle);
  CHECK_FALSE(is_watertight(twice));
  Mesh point = tetrahedron();
  point.triangles.push_back({1, 1, 1});
  CHECK_FALSE(is_watertight(point));
}
