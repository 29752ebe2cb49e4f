#include "phrame/answer/machine_path.hpp"

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "support/curves.hpp"

using namespace phrame;

namespace {

MachineQuery query_of(const Polynomial& speed, const Rational& period, ToolAxis tool) {
  MachineQuery query{{{RationalFunction(speed), Feedrate::Of::parameter}, period}};
  query.tool = tool;
  return query;
}

}  // namespace

// A = 1 − 2tj: e₁ = (1 − 4t², 0, 4t)/(1 + 4t²), and with V = |r′| = 1 + 4t² the time is t. At t =
// 1/4 the tilt is arctan((1 − 1/4)/1) = 36.8698976…°, at 3/4 arctan(−(9/4 − 1)/3) = −22.6198649…°.
TEST_CASE("machine path: through a pole A goes on, and C is kept") {
  const Curve over({{1}, {}, {0, -2}, {}});
  const MachinePath path =
      answer(NamedPhPath{"", PhPath(over)}, query_of({1, 0, 4}, {1, 4}, ToolAxis::e1));
  REQUIRE(path.moves.size() == 5);
  const Integer tilts[]{900000, 368699, 0, -226199, -368699};
  for (std::size_t k = 0; k < 5; ++k) {
    CAPTURE(k);
    CHECK(path.moves[k].a == tilts[k]);
    CHECK(path.moves[k].c == 900000);
    CHECK(path.moves[k].is_pole == (k == 2));
    CHECK(path.moves[k].feed == (k == 0 ? 0 : 2400000));
  }
  CHECK(path.moves[4].tip == std::array<Integer, 3>{-3333, 0, 20000});
}

TEST_CASE("machine path: a feed of 0 is refused, and poles need no other C") {
  const Curve plane({{1}, {}, {}, {0, 1}});
  MachineQuery query = query_of({1}, 1000, ToolAxis::f3);
  query.motion = {{RationalFunction(Polynomial{Rational(1, 1000000)})}, 2000000};
  query.places = 1;
  CHECK_THROWS_WITH_AS(answer(NamedPhPath{"", PhPath(plane)}, query),
                       "places: the feed, 1/minutes of a move, is 0 in 1 decimals", InputError);
  const MachinePath path =
      answer(NamedPhPath{"", PhPath(plane)}, query_of({1}, {1, 3}, ToolAxis::f3));
  for (const MachineMove& move : path.moves) {
    CHECK(move.is_pole);
    CHECK(move.a == 0);
    CHECK(move.c == 0);
  }
}
