#include "phrame/answer/rational_sweep.hpp"

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

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
    CHECK(half(point(patches[0], 1, 0), point(patches[0], 0, 0)) ==
          Rational(3, 5) * first.e2 + Rational(4, 5) * first.e3);
    const SurfacePatch& end = patches[patches.size() - 4];
    CHECK(half(point(end, 1, 1), point(end, 0, 1)) ==
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
