#include "phrame/ph/sweep/mesh.hpp"

#include <cmath>

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
  // Both sides of a triangle: each side has its opposite, but there is no body between them.
  CHECK(is_watertight({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}));
}

// A fan around one point, and its mirror image: sides from that point are many.
TEST_CASE("mesh: a double pyramid with many sides is watertight until one side is left out") {
  constexpr std::uint32_t n = 1000;
  Mesh mesh{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t k = 0; k < n; ++k) {
    mesh.points.push_back({std::cos(2 * M_PI * k / n), std::sin(2 * M_PI * k / n), 0});
    mesh.triangles.push_back({0, 2 + k, 2 + (k + 1) % n});
    mesh.triangles.push_back({1, 2 + (k + 1) % n, 2 + k});
  }
  CHECK(is_watertight(mesh));
  CHECK_FALSE(first_flat_triangle(mesh));
  mesh.triangles.erase(mesh.triangles.begin() + 777);
  CHECK_FALSE(is_watertight(mesh));
}

// 1 + 2^−52 is the next double after 1: the area is decided exactly, not by its rounded products.
TEST_CASE("mesh: a triangle without area is found, however flat others are") {
  const double next = 1 + 0x1p-52;
  const auto first = [](const Vector<double>& c) {
    return first_flat_triangle({{{0, 0, 0}, {1, 1, 1}, c, {1, 0, 0}}, {{0, 1, 3}, {0, 1, 2}}});
  };
  CHECK(first({1, 1, 1}) == 1);
  CHECK(first({7, 7, 7}) == 1);
  CHECK(first({0, 0, 0}) == 1);
  CHECK_FALSE(first({next, 1, 1}));
  CHECK_FALSE(first({1, 1, next}));
  CHECK_FALSE(first({0x1p-1074, 0, 0}));
  // On the line y = 3x, where the products of the rounded differences are not the same.
  CHECK(first_flat_triangle({{{0x1.3ee681a68b1a0p-4, 0x1.de59c279d0a70p-3, 0},
                              {0x1.e782e3297e4b8p-8, 0x1.6da22a5f1eb8ap-6, 0},
                              {0x1.4ca03316b0448p+2, 0x1.f2f04ca20866cp+3, 0}},
                             {{0, 1, 2}}}) == 0);
  CHECK(first_flat_triangle(
            {{{3e-320, 0, 0}, {6e-320, 1e-320, 0}, {9e-320, 2e-320, 0}}, {{0, 1, 2}}}) == 0);
}
