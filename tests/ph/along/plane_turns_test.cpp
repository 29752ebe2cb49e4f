#include "phrame/ph/along/plane_turns.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace plane_turns_test {

using Corner = Vector<Rational>;

Corner edge_of(const Corner& a, const Corner& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
Corner sum_of(const Corner& a, const Corner& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Conics in the corners of a polygon, from one third of an edge to two thirds of the one before,
/// and lines between them; around the whole polygon, or without its last two corners.
Path pipe(const std::vector<Corner>& corners, const std::vector<Rational>& weights,
          bool is_closed) {
  const auto between = [](const Corner& a, const Corner& b, const Rational& share) {
    Corner p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + share * (b[k] - a[k]);
    return p;
  };
  std::vector<Segment> segments;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < (is_closed ? n : n - 2); ++k) {
    const Corner& a = corners[k];
    const Corner& b = corners[(k + 1) % n];
    const Corner& c = corners[(k + 2) % n];
    const Corner end = between(a, b, Rational(2, 3));
    segments.emplace_back(bezier_curve({between(a, b, Rational(1, 3)), end}));
    segments.emplace_back(
        bezier_curve({end, b, between(b, c, Rational(1, 3))}, {1, weights[k % weights.size()], 1}));
  }
  return joined(segments);
}

using Doubles = Vector<double>;

Doubles numbers_of(const Vector<Real>& v) {
  return {approximate(v[0].enclose(64)), approximate(v[1].enclose(64)),
          approximate(v[2].enclose(64))};
}

Doubles unit(const Doubles& v) {
  const double size = std::sqrt(dot(v, v));
  return {v[0] / size, v[1] / size, v[2] / size};
}

/// Parallel transport from one unit tangent to the next: the shortest rotation, of f.
Doubles transported(const Doubles& f, const Doubles& from, const Doubles& to) {
  const Doubles axis = cross(from, to);
  const Doubles turned = cross(axis, f);
  const double c = dot(from, to);
  const double along = dot(axis, f) / (1 + c);
  Doubles g{};
  for (std::size_t k = 0; k < 3; ++k) g[k] = c * f[k] + turned[k] + along * axis[k];
  return g;
}

/// θ at the end by transport in small steps, up to whole turns.
double transported_angle(const Path& path, const Vector<Rational>& up) {
  const Doubles v{static_cast<double>(up[0]), static_cast<double>(up[1]),
                  static_cast<double>(up[2])};
  Doubles tangent = unit(numbers_of(direction(path, {0, Rational(0)})));
  Doubles f = unit(cross(v, tangent));
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    for (long j = 1; j <= 8; ++j) {
      const Doubles next = unit(numbers_of(direction(path, {k, Rational(j, 8)})));
      f = transported(f, tangent, next);
      tangent = next;
    }
  const Doubles e2 = unit(cross(v, tangent));
  return std::atan2(dot(f, cross(tangent, e2)), dot(f, e2));
}

/// The corners from 0 on.
std::vector<Corner> along_edges(const std::vector<Corner>& edges) {
  std::vector<Corner> corners{{0, 0, 0}};
  for (const Corner& edge : edges) corners.push_back(sum_of(corners.back(), edge));
  return corners;
}

}  // namespace plane_turns_test

using namespace plane_turns_test;

// x → y → x again, in the plane z = 0, and x → z → x: both times the frame comes back.
TEST_CASE("plane turns: θ of a pipe that bends to and fro is exactly 0, and can be compiled") {
  const Corner x{1, 0, 0};
  const Path path = pipe(along_edges({x, {0, 1, 0}, x, {0, 0, 1}, x, x}), {Rational(1, 2)}, false);
  const PathAngle angle(path, {1, 3, 2});
  CHECK_FALSE(angle.is_zero());
  for (const std::size_t k : {4U, 8U}) CHECK(angle.value({k, Rational(0)}).exact() == Rational(0));
  CHECK(angle.value({8, Rational(1, 3)}).exact() == Rational(0));  // on a line
  CHECK(angle.value({2, Rational(1, 3)}).origin().is_irrational);
  CompiledAngle compiled = CompiledAngle(angle);
  CHECK(compiled(8.25) == 0);
}

// By the theorem of Gauss and Bonnet: of tangents that go around octants of the sphere, of area
// π/2.
TEST_CASE("plane turns: holonomies that are 0, π/2 and exactly π") {
  const Corner x{1, 0, 0};
  const Corner y{0, 1, 0};
  const Corner z{0, 0, 1};
  const auto back = [](const Corner& v, long times = 1) {
    return Corner{-times * v[0], -times * v[1], -times * v[2]};
  };
  const auto holonomy_of = [&](const std::vector<Corner>& edges) {
    std::vector<Corner> corners = along_edges(edges);
    CHECK(corners.back() == corners.front());
    corners.pop_back();
    const Path path = pipe(corners, {Rational(1, 2)}, true);
    const auto turn = PathAngle(path).holonomy();
    REQUIRE(turn);
    const auto half_turns = over_pi(*turn);
    REQUIRE(half_turns);
    const double expected = -transported_angle(path, {1, 2, 5});
    const double difference = static_cast<double>(*half_turns) * std::numbers::pi + expected;
    CHECK(std::abs(std::remainder(difference, 2 * std::numbers::pi)) < 1e-9);
    return *half_turns;
  };
  CHECK(holonomy_of({x, y, back(x), back(y)}) == 0);
  CHECK(holonomy_of({x, y, z, back(x), back(y), back(z)}) == 0);
  CHECK(holonomy_of({x, y, x, z, back(x, 2), back(y), back(z)}) == Rational(-1, 2));
  CHECK(holonomy_of({x, y, x, back(y), back(z), back(x, 2), z}) == Rational(1, 2));
  CHECK(holonomy_of({x, y, x, z, x, back(y), back(x, 3), back(z)}) == 1);
}

TEST_CASE("plane turns: law: as parallel transport in doubles, and 0 where it is undone") {
  test::for_samples(12, [](test::Random& random) {
    std::vector<Corner> corners;
    const long count = random.integer(4, 8);
    while (static_cast<long>(corners.size()) < count) {
      const Corner next{random.integer(-5, 5), random.integer(-5, 5), random.integer(-5, 5)};
      const std::size_t n = corners.size();
      if (n == 1 && next == corners[0]) continue;
      if (n >= 2 &&
          cross(edge_of(corners[n - 2], corners[n - 1]), edge_of(corners[n - 1], next)) == Corner{})
        continue;
      corners.push_back(next);
    }
    const Path path = pipe(corners, {1, Rational(2, 3), 2}, false);
    const PathAngle angle(path);
    const Real theta = angle.value(end_of(path));
    const double difference = approximate(theta.enclose(64)) - transported_angle(path, angle.up());
    CHECK(std::abs(std::remainder(difference, 2 * std::numbers::pi)) < 1e-8);
    CHECK((theta.exact() || theta.origin().is_irrational));

    // The edges once more in the other order: the tangent goes back the way that it came.
    std::vector<Corner> all = corners;
    for (std::size_t k = corners.size() - 2; k > 0; --k)
      all.push_back(sum_of(all.back(), edge_of(corners[k - 1], corners[k])));
    const Path both = pipe(all, {Rational(3, 4)}, false);
    const Real undone = PathAngle(both, angle.up()).value(end_of(both));
    CHECK(undone.exact() == Rational(0));
  });
}
