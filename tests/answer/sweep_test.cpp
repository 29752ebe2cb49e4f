#include "phrame/answer/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

using namespace phrame;

namespace {

const Rational tolerance(1, 1000);

SweepQuery within(const Profile& profile, const Rational& distance = tolerance) {
  SweepQuery query{profile};
  query.tolerance_or_sections = distance;
  return query;
}

SweepQuery in_sections(const Profile& profile, long count) {
  SweepQuery query{profile};
  query.tolerance_or_sections = count;
  return query;
}

NamedPhPath named(const Curve& curve) { return {"", PhPath(curve)}; }

/// r = (t, 0, 0)
const NamedPhPath line = named(Curve({{1}, {}, {}, {}}));

/// (2 cos s, 2 sin s, 0), or backwards.
NamedPath circle(long turns = 1) {
  const Formula s = Formula::variable();
  return {"", Segment(ExpressionCurve({Formula(2) * cos(s), Formula(2) * sin(s), Formula(0)},
                                      Formula(0), Formula(0, 2 * turns)))};
}

/// A closed curve in space, whose rotation-minimizing frame does not close.
NamedPhPath space_loop() { return {"", test::chain(test::quarters())}; }

/// The largest deviation of the points and middles of sides of the mesh, by `distance`.
template <class Distance>
double farthest(const Mesh& mesh, Distance distance) {
  double largest = 0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector<double>, 4> probes{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t n = 0; n < 3; ++n) {
        probes[k][n] = (mesh.points[triangle[k]][n] + mesh.points[triangle[(k + 1) % 3]][n]) / 2;
        probes[3][n] += mesh.points[triangle[k]][n] / 3;
      }
    for (const Vector<double>& p : probes) largest = std::max(largest, std::abs(distance(p)));
  }
  return largest;
}

/// Points − edges + triangles, of a watertight mesh: 2 of a ball, 0 of a torus.
long euler_characteristic(const Mesh& mesh) {
  // Each of the three sides of a triangle is that of two.
  return static_cast<long>(mesh.points.size()) - static_cast<long>(mesh.triangles.size() / 2);
}

void check_body(const SweptBody& body, long characteristic) {
  CHECK(is_watertight(body.mesh));
  CHECK(euler_characteristic(body.mesh) == characteristic);
  CHECK(volume(body.mesh) > 0);
  CHECK(body.folds == 0);
}

}  // namespace

TEST_CASE("sweep: along a line it is a prism, of two sections") {
  // An L, of the area 3.
  const Profile profile({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const SweepAnswer found = answer(line, within(profile));
  check_body(found.body, 2);
  CHECK(found.body.sections == 2);
  CHECK(found.body.mesh.points.size() == 12);
  CHECK(volume(found.body.mesh) == 3);
  CHECK(*found.body.error < 1e-12);
  CHECK_FALSE(found.is_closed);
  // x is along f₂, which is e₂ = j there.
  CHECK(found.body.mesh.points[1] == Vector<double>{0, 2, 0});
}

// 81 less 1/2 and 4; with g holes its characteristic is 2 − 2g.
TEST_CASE("sweep: holes go through the body, and its caps are open there") {
  const std::vector<ProfilePoint> square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const std::vector<ProfilePoint> hole{{1, 1}, {2, 1}, {2, 2}};
  const std::vector<ProfilePoint> other{{4, 4}, {6, 4}, {6, 6}, {4, 6}};
  for (const std::size_t count : {1UL, 2UL}) {
    std::vector<std::vector<ProfilePoint>> rings{hole, square, other};
    rings.resize(count + 1);
    const SweptBody body = answer(line, within(Profile::of_rings(rings))).body;
    check_body(body, count == 1 ? 0 : -2);
    CHECK(volume(body.mesh) == (count == 1 ? 80.5 : 76.5));
  }
  // Around a closed path they are surfaces of their own.
  const Profile pipe =
      Profile::of_rings({rectangle_profile(1, 1).corners(),
                         rectangle_profile(Rational(1, 2), Rational(1, 2)).corners()});
  const SweptBody ring = answer(circle(), within(pipe)).body;
  check_body(ring, 0);
  CHECK(volume(ring.mesh) == doctest::Approx(3 * M_PI).epsilon(1e-2));
}

// Both ways: e₁ is −r′/|r′| for the multiplier −1.
TEST_CASE("sweep: a body is not inside out where the multiplier is negative") {
  const NamedPhPath backwards = named(Curve({{1}, {}, {}, {}}, Polynomial{-1}));
  const SweepAnswer found = answer(backwards, within(rectangle_profile(1, 2)));
  check_body(found.body, 2);
  CHECK(volume(found.body.mesh) == 2);
}

// A pyramid's frustum has the volume h/3·(A + √(AB) + B).
TEST_CASE("sweep: a scale makes a frustum of a prism") {
  SweepQuery query = within(rectangle_profile(1, 1));
  query.scale = RationalFunction(Polynomial{2, -1});
  const SweepAnswer found = answer(line, query);
  check_body(found.body, 2);
  CHECK(volume(found.body.mesh) == doctest::Approx(7.0 / 3).epsilon(1e-14));
  query.scale = RationalFunction(Polynomial{1, -1});
  CHECK_THROWS_AS(answer(line, query), DomainError);
  query.scale = RationalFunction(Polynomial{1}, Polynomial{-1, 2});
  CHECK_THROWS_AS(answer(line, query), DomainError);
}

// (√(x² + y²) − 2)² + z² = 1/4, and Pappus: the volume is the area of the section times 4π.
TEST_CASE("sweep: a circle along a circle is a torus within the bound") {
  for (const Rational& distance : {Rational(1, 50), Rational(1, 1000)}) {
    const Rational radius(1, 2);
    const SweepAnswer found =
        answer(circle(), within(circle_profile(radius, distance / 4), distance));
    check_body(found.body, 0);
    CHECK(found.is_closed);
    CHECK(*found.body.error <= round_to_double(distance));
    const double deviation = farthest(found.body.mesh, [](const Vector<double>& p) {
      return std::hypot(std::hypot(p[0], p[1]) - 2, p[2]) - 0.5;
    });
    CHECK(deviation <= *found.body.error);
    CHECK(deviation > *found.body.error / 10);  // the bound is not idle
    CHECK(volume(found.body.mesh) ==
          doctest::Approx(M_PI * M_PI).epsilon(4 * round_to_double(distance)));
  }
}

TEST_CASE("sweep: against its direction a torus is no other") {
  const SweepAnswer found = answer(circle(-1), within(rectangle_profile(1, Rational(1, 2))));
  check_body(found.body, 0);
  CHECK(volume(found.body.mesh) == doctest::Approx(2 * M_PI).epsilon(1e-2));
}

// (y, z) turned back by x·π/2 is on the boundary of the square.
TEST_CASE("sweep: a twisted square is met within the bound") {
  SweepQuery query = within(rectangle_profile(1, 1));
  query.twist = Angle(Rational(1, 2), 0);
  const SweepAnswer found = answer(line, query);
  check_body(found.body, 2);
  CHECK(found.body.sections > 10);
  const double deviation = farthest(found.body.mesh, [](const Vector<double>& p) {
    if (p[0] == 0 || p[0] == 1) return 0.0;  // caps
    const double phi = p[0] * M_PI / 2;
    const double y = std::cos(phi) * p[1] + std::sin(phi) * p[2];
    const double z = -std::sin(phi) * p[1] + std::cos(phi) * p[2];
    return std::max(std::abs(y), std::abs(z)) - 0.5;
  });
  CHECK(deviation <= *found.body.error);
  CHECK(*found.body.error <= 1e-3);
  CHECK(deviation > *found.body.error / 20);
  CHECK(volume(found.body.mesh) == doctest::Approx(1).epsilon(1e-2));
}

TEST_CASE("sweep: a closed body closes, by the least turn") {
  const SweepAnswer found = answer(
      space_loop(), within(rectangle_profile(Rational(1, 4), Rational(1, 8)), Rational(1, 50)));
  check_body(found.body, 0);
  CHECK(std::abs(found.turn) > 1e-3);
  CHECK(std::abs(found.turn) <= M_PI);
  // The last section is the next to the first one as any other is to its next: no jump.
  const Mesh& mesh = found.body.mesh;
  const auto step = [&](std::size_t from, std::size_t to) {
    double size = 0;
    for (std::size_t n = 0; n < 3; ++n)
      size = std::hypot(size, mesh.points[to][n] - mesh.points[from][n]);
    return size;
  };
  const std::size_t last = mesh.points.size() - 4;
  for (std::size_t k = 0; k < 4; ++k) CHECK(step(last + k, k) < 3 * step(last + k - 4, last + k));
  SweepQuery query = within(rectangle_profile(Rational(1, 4), Rational(1, 8)), Rational(1, 50));
  query.twist = Angle(2, 0);
  CHECK(answer(space_loop(), query).turn == doctest::Approx(found.turn + 2 * M_PI));
  query.twist = Angle(1, 0);
  CHECK_THROWS_AS(answer(space_loop(), query), DomainError);
  query.twist = {};
  query.end_normal = Vector<Rational>{0, 0, 1};
  CHECK_THROWS_AS(answer(space_loop(), query), DomainError);
  query.end_normal = {};
  query.scale = RationalFunction(Polynomial{2, -1});
  CHECK_THROWS_AS(answer(space_loop(), query), DomainError);
}

// From each section to the next, the first after the last too, f₂ turns by little; turned the wrong
// way the body would jump by twice the turn, 2.3, where it closes.
TEST_CASE("sweep: where a closed body closes its sections go on as elsewhere") {
  constexpr std::size_t count = 500;
  const SweepAnswer found =
      answer(space_loop(), in_sections(rectangle_profile(1, Rational(1, 2)), count));
  const auto& points = found.body.mesh.points;
  const auto f2 = [&](std::size_t section) {  // the corners 0 and 1 are at ±1/2 along it
    return points[4 * section] - points[4 * section + 1];
  };
  const auto step = [&](std::size_t section) {
    const Vector<double> change = f2((section + 1) % count) - f2(section);
    return std::sqrt(dot(change, change));
  };
  double greatest = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) greatest = std::max(greatest, step(k));
  CHECK(greatest < 0.1);
  CHECK(step(count - 1) <= 1.5 * greatest);
  CHECK(std::abs(found.turn) > 0.2);
}

TEST_CASE("sweep: with an end normal the last section is along it") {
  SweepQuery query = in_sections(rectangle_profile(1, Rational(1, 4)), 50);
  query.start = StartNormal({0, 0, 1});
  query.end_normal = Vector<Rational>{1, 0, 0};
  const NamedPhPath path = named(test::quintic);
  const SweepAnswer found = answer(path, query);
  check_body(found.body, 2);
  CHECK(found.body.sections == 50);
  CHECK_FALSE(found.body.error);
  const Mesh& mesh = found.body.mesh;
  // The corners 0 and 1 are (1, ±…)/2 on the long side of the rectangle: their difference is f₂.
  const auto along = [&](std::size_t section, const Vector<Rational>& v, const Rational& t) {
    const Vector<double> e1 = round_to_double(euler_rodrigues_frame(test::quintic, t).e1);
    double in_v = 0;
    double across = 0;
    Vector<double> f2{};
    Vector<double> rest{};
    const Vector<double> given = round_to_double(v);
    for (std::size_t n = 0; n < 3; ++n) {
      f2[n] = mesh.points[4 * section][n] - mesh.points[4 * section + 1][n];
      in_v += given[n] * e1[n];
    }
    for (std::size_t n = 0; n < 3; ++n) rest[n] = given[n] - in_v * e1[n];
    const double size = std::hypot(rest[0], rest[1], rest[2]);
    for (std::size_t n = 0; n < 3; ++n) across = std::hypot(across, f2[n] - rest[n] / size);
    return across;
  };
  CHECK(along(0, {0, 0, 1}, 0) < 1e-12);
  CHECK(along(49, {1, 0, 0}, 1) < 1e-12);
  query.end_normal = Vector<Rational>{3, 4, 0};  // the tangent at the end
  CHECK_THROWS_AS(answer(path, query), DomainError);
}

// Along the circle of radius 2 a rectangle has two of its corners inside, by half its width; they
// fold over where that is more than 2, in either direction of the curve.
TEST_CASE("sweep: a body folds where its profile is larger than the radius of curvature") {
  const auto folds = [](const NamedPath& path, const Rational& width, long sections) {
    return answer(path, in_sections(rectangle_profile(width, 1), sections)).body.folds;
  };
  for (const long turns : {1, -1}) {
    CHECK(folds(circle(turns), Rational(399, 100), 100) == 0);
    CHECK(folds(circle(turns), Rational(401, 100), 100) == 200);
    CHECK(folds(circle(turns), Rational(401, 100), 5) == 10);
  }
  // A scale counts: half as large where t = 1.
  SweepQuery query = in_sections(rectangle_profile(Rational(41, 10), 1), 101);
  query.scale = RationalFunction(Polynomial{1, -2, 2});
  CHECK(answer(circle(), query).body.folds < 20);
  CHECK(answer(circle(), query).body.folds > 0);
  // (t, t²) has the least radius of curvature, 1/2, at its start: y = 1 + … is beyond it there.
  const NamedPath parabola{
      "", Segment(RationalCurve({Polynomial{0, 1}, Polynomial{0, 0, 1}, Polynomial()}))};
  const SweptBody body =
      answer(parabola, in_sections(rectangle_profile(Rational(11, 10), Rational(11, 10)), 101))
          .body;
  CHECK(body.folds >= 2);
  CHECK(body.folds < 60);
}

TEST_CASE("sweep: a closed path needs three sections, and a loose tolerance gives them") {
  CHECK_THROWS_AS(answer(circle(), in_sections(rectangle_profile(1, 1), 2)), DomainError);
  check_body(answer(circle(), in_sections(rectangle_profile(1, 1), 3)).body, 0);
  check_body(answer(circle(), within(rectangle_profile(1, 1), 1000)).body, 0);
}

TEST_CASE("sweep: a body whose triangles vanish in doubles is refused") {
  const NamedPhPath far = named(Curve({{1}, {}, {}, {}}, Polynomial{1}, {0, power_of_two(60), 0}));
  CHECK_THROWS_AS(answer(far, in_sections(rectangle_profile(1, 1), 2)), Undecided);
  check_body(answer(far, in_sections(rectangle_profile(1024, 1), 2)).body, 2);
}

TEST_CASE("sweep: where the curve turns back in a cusp it is refused") {
  // r′ = (t − 1/2)·i
  const NamedPhPath cusp = named(Curve({{1}, {}, {}, {}}, Polynomial{Rational(-1, 2), 1}));
  CHECK_THROWS_AS(answer(cusp, within(rectangle_profile(1, 1))), Undecided);
  CHECK_THROWS_AS(answer(cusp, in_sections(rectangle_profile(1, 1), 5)), Undecided);
}

// The prism along a line, how fast ever it is passed: r′ = (t − 1/2)²·i, and t²(1 − t)·i backwards.
TEST_CASE("sweep: through cusps of a line it goes on") {
  for (const Polynomial& f : {Polynomial{Rational(1, 4), -1, 1}, Polynomial{0, 0, -1, 1}}) {
    const double length = std::abs(round_to_double(antiderivative(f)(Rational(1))));
    for (SweepQuery query :
         {within(rectangle_profile(1, 2)), in_sections(rectangle_profile(1, 2), 5)}) {
      const SweptBody body = answer(named(Curve({{1}, {}, {}, {}}, f)), query).body;
      check_body(body, 2);
      CHECK(volume(body.mesh) == doctest::Approx(2 * length).epsilon(1e-14));
      query.twist = Angle{Rational(1, 2), 0};
      CHECK(is_watertight(answer(named(Curve({{1}, {}, {}, {}}, f)), query).body.mesh));
    }
  }
}

// Pappus and Guldin: around its centroid a profile bounds its area times the length, folds counted
// as they turn. Handles of a Bézier curve that lie on its ends, as editors have them.
TEST_CASE("sweep: handles drawn into the ends of a curve leave a body") {
  for (const bool is_reversed : {false, true}) {
    std::vector<Vector<Rational>> points{{0, 0, 0}, {0, 0, 0}, {10, 2, 1}, {10, 10, 3}};
    if (is_reversed) std::reverse(points.begin(), points.end());
    const NamedPath curve{"", Path(bezier_curve(points))};
    const SweptBody body =
        answer(curve, within(circle_profile(Rational(1, 4), Rational(1, 4000)))).body;
    CHECK(is_watertight(body.mesh));
    const double length = round_to_double(PathLength(curve.path).total());
    const double circumference = std::numbers::pi / 2;
    CHECK(std::abs(volume(body.mesh) - std::numbers::pi / 16 * length) <=
          *body.error * (circumference * length + 1));
    CHECK(*body.error <= 1e-3);
    CHECK(volume(body.mesh) > 0);
  }
}

// Up to where 10⁻³ needs parts of 2⁻²² there are a hundred thousand that do: they are not found
// first.
TEST_CASE("sweep: that a curve turns too far on is seen in the middle of it") {
  const Formula s = Formula::variable();
  const NamedPath steep{
      "", Segment(ExpressionCurve({s, exp(Formula(60) * s), Formula(0)}, Formula(0), Formula(1)))};
  CHECK_THROWS_WITH_AS(answer(steep, within(rectangle_profile(1, 1))),
                       doctest::Contains("sweep: near t = 0.5 the curve turns back in a cusp, or"),
                       Undecided);
}

// Cavalieri: in the mitres of a profile around its centroid nothing is lost or gained.
TEST_CASE("sweep: a pipe along the edges of a cube has the volume of its edges, mitred") {
  const Path edges =
      test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}, {0, 0, 0}});
  const Profile square = rectangle_profile(Rational(1, 5), Rational(1, 5));
  for (const SweepQuery& query : {within(square), in_sections(square, 5)}) {
    const SweepAnswer made = answer(NamedPath("", edges), query);
    CHECK(made.is_closed);
    check_body(made.body, 0);
    CHECK(made.body.mesh.points.size() == 24);
    CHECK(std::abs(volume(made.body.mesh) - 6.0 / 25) < 1e-14);
  }
  const Path open = segment(edges, 0, 3);
  const SweptBody body = answer(NamedPath("", open), within(square)).body;
  check_body(body, 2);
  CHECK(body.mesh.points.size() == 16);
  CHECK(std::abs(volume(body.mesh) - 3.0 / 25) < 1e-14);
}

/// A quarter of a circle from a to c where b is the corner of their tangents.
Segment quarter(const Vector<Rational>& a, const Vector<Rational>& b, const Vector<Rational>& c) {
  return bezier_curve({a, b, c}, {1, 1, 2});
}

TEST_CASE("sweep: at a corner between arcs points on the axis of the turn are one") {
  // They meet at 90° in the plane of x and y: f₃ is along z, and so is the axis.
  const Path path =
      joined({quarter({0, 0, 0}, {2, 0, 0}, {2, 2, 0}), quarter({2, 2, 0}, {4, 2, 0}, {4, 4, 0})});
  REQUIRE(path.corners().size() == 1);
  const Profile diamond = regular_polygon(4, Rational(1, 10));
  const SweptBody body = answer(NamedPath("", path), within(diamond)).body;
  CHECK(is_watertight(body.mesh));
  CHECK(euler_characteristic(body.mesh) == 2);
  CHECK(body.folds == 1);
  // Around its centroid a profile of the area 2/100 along two quarters, up to the tolerance.
  CHECK(std::abs(volume(body.mesh) - 0.02 * 2 * M_PI) < 1e-3 * 0.6 * 2 * M_PI);
  CHECK(body.mesh.points.size() == 4 * body.sections - 2 * 2);  // two of three rings share them
}

TEST_CASE("sweep: a mitre nearer than the tolerance stands for the sections beside it") {
  const Rational tiny(1, 1000000);
  const Segment first = quarter({0, 0, 0}, {2, 0, 0}, {2, 2, 0});
  const auto body_of = [&](const Rational& off) {
    const Path path = joined({first, quarter({2, 2, 0}, {2 + 2 * off, 4, 0}, {0, 4, 0})});
    return answer(NamedPath("", path), within(regular_polygon(5, 1))).body;
  };
  const SweptBody smooth = body_of(0);
  const SweptBody body = body_of(tiny);
  check_body(body, 2);
  CHECK(body.sections == smooth.sections);
  CHECK(*body.error - *smooth.error > 0.4e-6);  // tan(α/2)
  CHECK(*body.error < 1e-3);
  CHECK(body_of(Rational(1, 10)).folds > 0);
  // Facets that lead back into the body have normals of their own.
  SweepQuery query = within(regular_polygon(5, 1));
  query.normal_tolerance = Angle(Rational(1, 4), 0);
  const auto path_of = [&](const Rational& off) {
    return NamedPath("", joined({first, quarter({2, 2, 0}, {2 + 2 * off, 4, 0}, {0, 4, 0})}));
  };
  CHECK_THROWS_AS(answer(path_of(Rational(1, 10)), query), Undecided);
}

// Frustums of square pyramids: h/3·(a² + ab + b²).
TEST_CASE("sweep: a scale by values at joints is linear in between") {
  const Path two_sides = test::polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  SweepQuery query = within(rectangle_profile(1, 1), Rational(1, 1000000));
  query.scale = SweepScale(std::vector<Rational>{1, 2, 1});
  const SweptBody body = answer(NamedPath("", two_sides), query).body;
  check_body(body, 2);
  CHECK(std::abs(volume(body.mesh) - 14.0 / 3) < 1e-12);
  query.scale = SweepScale(std::vector<Rational>{1, 2});
  CHECK_THROWS_AS(answer(NamedPath("", two_sides), query), DomainError);
  query.scale = SweepScale(std::vector<Rational>{1, -2, 1});
  CHECK_THROWS_AS(answer(NamedPath("", two_sides), query), DomainError);
}

TEST_CASE("sweep scale: its greatest value is at a joint, or bounded by balls") {
  const SweepScale joints(std::vector<Rational>{1, Rational(5, 2), 2});
  CHECK(joints.greatest(2) >= 2.5);
  CHECK(joints.greatest(2) < 2.5 + 1e-14);
  CHECK_FALSE(joints.is_constant());
  CHECK(joints.on(1)(Rational(3, 2)) == Rational(9, 4));
  CHECK(joints.at(2) == 2);
  CHECK(SweepScale(std::vector<Rational>{3, 3, 3}).is_constant());
  CHECK(SweepScale().greatest(7) == 1);
  const SweepScale parabola(RationalFunction(Polynomial{1, 1, Rational(-1, 2)}));
  CHECK(parabola.greatest(1) >= 1.5);
  CHECK(parabola.greatest(1) < 1.51);
}
