#include "phrame/answer/rational_sweep.hpp"

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/surface_point.hpp"

using namespace phrame;

namespace rational_sweep_answer_test {

ProfileCurve square() { return polygon_curve(rectangle_profile(2, 2)); }

}  // namespace rational_sweep_answer_test

using namespace rational_sweep_answer_test;

// f₂ at the ends is that of a frame of minimal twist, where it is rational exactly.
TEST_CASE("rational sweep: a rational frame of minimal twist is one exactly, with the ends asked") {
  const PhPath path = test::cut(test::quintic, {Rational(1, 2)});
  const Frame<Rational> first = euler_rodrigues_frame(path.segments().front(), 0);
  const Frame<Rational> last = euler_rodrigues_frame(path.segments().back(), 1);
  RationalSweepQuery query{square()};
  query.start = StartNormal(Rational(3) * first.e2 + Rational(4) * first.e3);
  query.end_normal = Rational(5) * last.e2 - Rational(12) * last.e3;
  for (const long degree : {1L, 2L, 3L}) {
    query.twist_degree = degree;
    const RationalSweepAnswer found = answer(NamedPhPath("", path), query);
    const auto& patches = found.surface.patches;
    CHECK(patches.size() >= 8);
    const auto half = [](const Vector<Rational>& from, const Vector<Rational>& to) {
      return Rational(1, 2) * (to - from);
    };
    // The first side of the square goes from (1, 1) to (−1, 1): against f₂.
    CHECK(half(test::point(patches[0], 1, 0), test::point(patches[0], 0, 0)) ==
          Rational(3, 5) * first.e2 + Rational(4, 5) * first.e3);
    const SurfacePatch& end = patches[patches.size() - 4];
    CHECK(half(test::point(end, 1, 1), test::point(end, 0, 1)) ==
          Rational(5, 13) * last.e2 - Rational(12, 13) * last.e3);
  }
}

TEST_CASE("rational sweep: a closed curve in space is closed by a frame of minimal twist") {
  const NamedPhPath loop("", test::chain(test::quarters()));
  RationalSweepQuery query{square()};
  CHECK_THROWS_AS(answer(loop, query), DomainError);
  query.twist_degree = 2;
  CHECK(answer(loop, query).surface.is_closed);
  query.end_normal = Vector<Rational>{0, 0, 1};
  CHECK_THROWS_AS(answer(loop, query), DomainError);
}

// An arc of three quarters of a circle of radius 2, by weights that are not its symmetric ones, and
// a line: places are compared with those of the circle and the frame that turns in its plane.
TEST_CASE("rational sweep: lines and arcs have exact surfaces, wherever fractions are a frame") {
  const auto arc = [](const Vector<Rational>& a, const Vector<Rational>& b,
                      const Vector<Rational>& c) {
    return Segment(bezier_curve({a, b, c}, {1, 1, 2}));
  };
  Path path(bezier_curve({{2, -3, 1}, {2, 0, 1}}));
  path.append(arc({2, 0, 1}, {2, 2, 1}, {0, 2, 1}));
  path.append(arc({0, 2, 1}, {-2, 2, 1}, {-2, 0, 1}));
  path.append(arc({-2, 0, 1}, {-2, -2, 1}, {0, -2, 1}));
  RationalSweepQuery query{square()};
  query.start = StartNormal({0, 0, 1});
  query.scale = RationalFunction(Polynomial{1, 1});
  const RationalSurface surface = answer(NamedPath("", path), query).surface;
  REQUIRE(surface.patches.size() == 16);
  CHECK_FALSE(surface.is_closed);
  for (const SurfacePatch& patch : surface.patches) {
    if (patch.side > 0) continue;  // from (1, 1) to (-1, 1): f2 = z, f3 = e1 x f2 from the axis
    CHECK(patch.points.front().size() == 2);
    for (const Rational& s : {Rational(0), Rational(1, 3), Rational(1)}) {
      const Vector<Rational> at = test::point(patch, Rational(1, 4), s);
      const Rational scale = 1 + patch.from + s * (patch.to - patch.from);
      CHECK(at[2] == 1 + scale / 2);
      const Rational out = 2 + scale;
      if (patch.from == 0)
        CHECK(at[0] == out);
      else
        CHECK(at[0] * at[0] + at[1] * at[1] == out * out);
    }
  }
}

TEST_CASE("rational sweep: a circle by arcs is a closed body, a line of length sqrt(2) is none") {
  std::vector<Segment> quarters;
  const Vector<Rational> corners[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::size_t k = 0; k < 4; ++k)
    quarters.emplace_back(bezier_curve(
        {corners[k], corners[k] + corners[(k + 1) % 4], corners[(k + 1) % 4]}, {2, 1, 1}));
  RationalSweepQuery query{circle_curve(Rational(1, 3))};
  CHECK(answer(NamedPath("", joined(quarters)), query).surface.is_closed);
  query.scale = RationalFunction(Polynomial{1, 1});
  CHECK_THROWS_AS(answer(NamedPath("", joined(quarters)), query), DomainError);
  CHECK_THROWS_AS(answer(NamedPath("", Path(bezier_curve({{0, 0, 0}, {1, 1, 0}}))), {square()}),
                  DomainError);
}
