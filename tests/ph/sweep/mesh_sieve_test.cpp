#include "phrame/ph/sweep/mesh_sieve.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/mesh_numbers.hpp"

using namespace phrame;

namespace {

/// Counts them.
class Counter : public MeshSink {
 public:
  void add_point(const Vector<double>& /*point*/) override { ++points; }
  void add_triangle(const Triangle& /*triangle*/, const Corners& /*corners*/) override {
    ++triangles;
  }
  std::size_t points = 0;
  std::size_t triangles = 0;
};

constexpr std::uint32_t sides = 100;

/// A pipe with lids: rings of points, and the middles of the lids.
struct Pipe {
  Mesh mesh;
  std::vector<std::size_t> rings;  ///< how many triangles there are when a ring is there

  explicit Pipe(std::uint32_t count) {
    mesh.points = {{0, 0, -1}, {0, 0, 1.0 * count}};
    for (std::uint32_t ring = 0; ring < count; ++ring)
      for (std::uint32_t k = 0; k < sides; ++k)
        mesh.points.push_back(
            {std::cos(2 * M_PI * k / sides), std::sin(2 * M_PI * k / sides), 1.0 * ring});
    for (std::uint32_t ring = 0; ring < count; ++ring) {
      for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t next = (k + 1) % sides;
        if (ring == 0) mesh.triangles.push_back({0, at(0, next), at(0, k)});
        if (ring > 0) {
          mesh.triangles.push_back({at(ring - 1, k), at(ring - 1, next), at(ring, next)});
          mesh.triangles.push_back({at(ring - 1, k), at(ring, next), at(ring, k)});
        }
        if (ring + 1 == count) mesh.triangles.push_back({1, at(ring, k), at(ring, next)});
      }
      rings.push_back(mesh.triangles.size());
    }
  }
  static std::uint32_t at(std::uint32_t ring, std::uint32_t k) { return 2 + ring * sides + k; }
};

/// Seen as it is made, ring by ring; points of the ring before may be left out of those to keep.
bool is_proved(const Pipe& pipe, Coordinates numbers = Coordinates::doubles, bool keeps = true) {
  Counter counter;
  MeshSieve sieve(numbers, counter);
  std::size_t point = 0;
  std::size_t triangle = 0;
  const auto add_points = [&](std::size_t end) {
    for (; point < end; ++point) sieve.add_point(pipe.mesh.points[point]);
  };
  add_points(2);
  for (std::uint32_t ring = 0; ring < pipe.rings.size(); ++ring) {
    add_points(2 + (ring + 1) * sides);
    for (; triangle < pipe.rings[ring] && triangle < pipe.mesh.triangles.size(); ++triangle) {
      const auto& [i, j, k] = pipe.mesh.triangles[triangle];
      sieve.add_triangle({i, j, k},
                         {&pipe.mesh.points[i], &pipe.mesh.points[j], &pipe.mesh.points[k]});
    }
    std::vector<std::uint32_t> here;
    for (std::uint32_t k = 0; k < sides; ++k) here.push_back(Pipe::at(ring, keeps ? k : 0));
    sieve.keep_points(std::vector<std::uint32_t>{0, 1}, here);
  }
  CHECK(counter.points == pipe.mesh.points.size());
  CHECK(counter.triangles == pipe.mesh.triangles.size());
  return sieve.is_proved();
}

/// What a whole mesh is seen to be.
bool is_sound(const Mesh& mesh) {
  try {
    require_apart(mesh, Coordinates::doubles);
    return is_watertight(mesh);
  } catch (const Undecided&) {
    return false;
  }
}

}  // namespace

// 800 rings have 160 000 triangles, which are looked at in five blocks.
TEST_CASE("mesh sieve: a mesh in many blocks is proved as the whole one is") {
  for (const std::uint32_t rings : {1U, 2U, 3U, 800U}) {
    CAPTURE(rings);
    const Pipe pipe(rings);
    CHECK(is_sound(pipe.mesh));
    CHECK(is_proved(pipe));
  }
}

TEST_CASE("mesh sieve: one fault anywhere is seen") {
  const Pipe good(800);
  const std::size_t count = good.mesh.triangles.size();
  // Next to each border of blocks, and elsewhere.
  std::vector<std::size_t> places{0, 5, count / 3, count - 1};
  for (std::size_t block = 1; block < 5; ++block)
    for (std::size_t k = 0; k < 500; k += 167) places.push_back((block << 15) + k);
  for (const std::size_t n : places) {
    CAPTURE(n);
    Pipe turned = good;
    std::swap(turned.mesh.triangles[n][0], turned.mesh.triangles[n][1]);
    CHECK_FALSE(is_proved(turned));
    Pipe twice = good;
    twice.mesh.triangles[n] = twice.mesh.triangles[n > 0 ? n - 1 : 1];
    CHECK_FALSE(is_proved(twice));
    Pipe moved = good;
    moved.mesh.triangles[n][2] = n < count / 2 ? Pipe::at(799, 7) : Pipe::at(0, 7);
    CHECK_FALSE(is_proved(moved));
  }
}

TEST_CASE("mesh sieve: points that are the same, far apart in the mesh, are seen") {
  const Pipe good(800);
  for (const std::uint32_t ring : {1U, 400U, 799U}) {
    Pipe same = good;
    same.mesh.points[Pipe::at(ring, 13)] = same.mesh.points[Pipe::at(0, 6)];
    CHECK_FALSE(is_sound(same.mesh));
    CHECK_FALSE(is_proved(same));
  }
  // 0 and −0 are the same number.
  Pipe zero = good;
  zero.mesh.points[Pipe::at(3, 1)] = {0.0, 7, 7};
  zero.mesh.points[Pipe::at(700, 1)] = {-0.0, 7, 7};
  CHECK_FALSE(is_sound(zero.mesh));
  CHECK_FALSE(is_proved(zero));
}

TEST_CASE("mesh sieve: flat triangles, numbers too great, and points that were let go") {
  Pipe flat(800);
  for (std::uint32_t ring = 500; ring < 503; ++ring)
    flat.mesh.points[Pipe::at(ring, 9)] = {5, 5, 1.0 * ring};
  CHECK(is_proved(flat));  // pointed, but a body
  flat.mesh.points[Pipe::at(500, 9)] =
      0.5 * flat.mesh.points[Pipe::at(500, 8)] + 0.5 * flat.mesh.points[Pipe::at(501, 9)];
  CHECK(is_proved(flat) == is_sound(flat.mesh));
  flat.mesh.points[Pipe::at(500, 9)] = {4, 4, 4};
  flat.mesh.points[Pipe::at(501, 9)] = {5, 5, 5};
  flat.mesh.points[Pipe::at(501, 10)] = {6, 6, 6};
  CHECK_FALSE(is_sound(flat.mesh));
  CHECK_FALSE(is_proved(flat));
  Pipe great(3);
  great.mesh.points[Pipe::at(1, 0)] = {1e39, 0, 1};
  CHECK(is_proved(great));
  CHECK_FALSE(is_proved(great, Coordinates::floats));
  great.mesh.points[Pipe::at(1, 0)] = {HUGE_VAL, 0, 1};
  CHECK_FALSE(is_proved(great));
  CHECK_FALSE(is_proved(Pipe(800), Coordinates::doubles, false));
  CHECK(is_proved(Pipe(20), Coordinates::doubles, false));  // in one block nothing is let go
}
