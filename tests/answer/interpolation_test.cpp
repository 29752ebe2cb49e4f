#include "phrame/answer/interpolation.hpp"

#include <cmath>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/ph/curve/arc_length.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

using Row = std::vector<double>;

Feedrate feed(const Polynomial& v, Feedrate::Of of = Feedrate::Of::arc_length) {
  return {RationalFunction(v), of};
}

FrameTable points(const Curve& curve, const Feedrate& feedrate, const Rational& period) {
  return answer({"", curve}, InterpolationQuery{feedrate, period});
}

}  // namespace

// r′ = 1, V = 1 + t: time = log(1 + t) = log(1 + s); e^(1/2) − 1 =
// 0.64872127070012814684865078781416…
TEST_CASE("interpolation: along a line with V = 1 + s, times are logarithms") {
  const FrameTable table = points(test::straight_line().curve, feed({1, 1}), Rational(1, 2));
  CHECK(table.columns == std::vector<std::string>{"k", "time", "t", "s", "x", "y", "z"});
  const double t = 0.648721270700128146848650787814;
  const double log2 = 0.693147180559945309417232121458;
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[0] == Row{0, 0, 0, 0, 0, 0, 0});
  CHECK(table.rows[1] == Row{1, 0.5, t, t, t, 0, 0});
  CHECK(table.rows[2] == Row{2, log2, 1, 1, 1, 0, 0});
}

TEST_CASE("interpolation: an end that is a tick is one row, with the exact time") {
  const FrameTable table = points(test::farouki_quintic().curve, feed({2}), Rational(71, 90));
  REQUIRE(table.rows.size() == 4);  // 71/30 = 3·71/90
  CHECK(table.rows[3][0] == 3);
  CHECK(table.rows[3][1] == 71.0 / 30);
  CHECK(table.rows[3][2] == 1);
  CHECK(table.rows[2][2] < 1);
  CHECK(points(test::farouki_quintic().curve, feed({2}), 1000).rows.size() == 2);
}

// mpmath: quadrature of |r′|/(1 + t²) and its root finder, 50 digits.
TEST_CASE("interpolation: the quintic of Farouki 2003 with V = 1 + t²") {
  const FrameTable table = points(test::farouki_quintic().curve,
                                  feed({1, 0, 1}, Feedrate::Of::parameter), Rational(1, 2));
  REQUIRE(table.rows.size() == 9);
  CHECK(table.rows[1][2] == 0.0899735391225559562964490457463);
  CHECK(table.rows[1][3] == 0.501301992185692453233701845119);
  CHECK(table.rows[4][2] == 0.414184876005397242705635993996);
  CHECK(table.rows[4][3] == 2.10577013546350905475825786553);
  CHECK(table.rows[8][1] == 3.77155425993934768700331443962);
  CHECK(table.rows[8][2] == 1);
}

TEST_CASE("interpolation: law: at constant speed the points are those of equal arc length") {
  test::for_samples(20, [](test::Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    const ArcLength length(curve);
    const long n = random.integer(2, 9);
    const FrameTable moving = points(curve, feed({3}), length.total() / (3 * n));
    std::vector<RealAlgebraic> at;
    for (long k = 0; k <= n; ++k)
      at.push_back(length.algebraic_parameter(length.total() * Rational(k, n)));
    const FrameTable still = frame_table(curve, {{}, {TabulatedScalar::arc_length}}, at);
    REQUIRE(moving.rows.size() == at.size());
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Row& a = moving.rows[k];
      const Row& b = still.rows[k];
      CHECK(Row(a.begin() + 4, a.end()) == Row(b.begin() + 1, b.begin() + 4));
      CHECK(a[2] == b[0]);
      CHECK(a[3] == b.back());
    }
  });
}

TEST_CASE("interpolation: JSON names its own format; what is too large is refused") {
  const FrameTable table = points(test::straight_line().curve, feed({1}), 1);
  CHECK(test::Json::parse(to_json(table))["phrame"] == "interpolation/1");
  const Curve huge({Polynomial{power_of_ten(200)}, {}, {}, {}});
  CHECK_THROWS_WITH_AS(points(huge, feed({power_of_ten(400)}), 1),
                       "point 1: s does not fit a double, of at most 1.8e308", InputError);
}

namespace {

/// The same in the columns named, to the last bit?
void check_columns(const FrameTable& a, const FrameTable& b,
                   const std::vector<std::size_t>& which) {
  REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k)
    for (const std::size_t column : which) CHECK(a.rows[k][column] == b.rows[k][column]);
}

const std::vector<std::size_t> all_but_t{0, 1, 3, 4, 5, 6};

}  // namespace

TEST_CASE("interpolation: pieces of a curve are passed as the whole") {
  const Curve quintic = test::farouki_quintic().curve;
  const Path pieces = test::cut(quintic, {Rational(1, 3)});
  const auto check = [](const Curve& whole, const Path& cut, const Feedrate& feedrate) {
    const InterpolationQuery query{feedrate, Rational(1, 7)};
    check_columns(answer({"", cut}, query), answer({"", whole}, query), all_but_t);
  };
  check(quintic, pieces, feed({2}));
  check(quintic, pieces, feed({1, Rational(1, 2)}));
  check(quintic, pieces, feed({1, 0, Rational(1, 4)}));
  check(quintic, test::cut(quintic, {Rational(1, 5), Rational(2, 5), Rational(3, 5)}),
        {RationalFunction({3}, {1, 1}), Feedrate::Of::arc_length});
  const Curve plane({{1}, {}, {}, {0, 1}});
  check(plane, test::cut(plane, {Rational(1, 3), Rational(2, 3)}),
        {RationalFunction({5}, {1, 2}), Feedrate::Of::curvature});
  // The parameter of the whole is half of that of two equal pieces.
  const Path halves = test::cut(quintic, {Rational(1, 2)});
  const auto of_t = Feedrate::Of::parameter;
  const FrameTable whole =
      answer({"", quintic}, InterpolationQuery{feed({1, 0, 1}, of_t), Rational(1, 7)});
  const FrameTable cut =
      answer({"", halves}, InterpolationQuery{feed({1, 0, Rational(1, 4)}, of_t), Rational(1, 7)});
  check_columns(cut, whole, all_but_t);
  for (std::size_t k = 0; k < cut.rows.size(); ++k) CHECK(cut.rows[k][2] == 2 * whole.rows[k][2]);
}

// Two unit lengths along x at V = 1.
TEST_CASE("interpolation: a tick at a joint, and too many rows") {
  const Curve line = test::straight_line().curve;
  const NamedPath two{"", test::chain({line, line})};
  const FrameTable table = answer(two, InterpolationQuery{feed({1}), 1});
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[1] == Row{1, 1, 1, 1, 1, 0, 0});
  CHECK(table.rows[2] == Row{2, 2, 2, 2, 2, 0, 0});
  CHECK_THROWS_WITH_AS(answer(two, InterpolationQuery{feed({1}), Rational(1, 5), 10}),
                       "1/5 asks for 11 rows, the limit is 10", InputError);
  CHECK_NOTHROW(answer(two, InterpolationQuery{feed({1}), Rational(1, 5), 11}));
}

// s = 2 is at t = 0.17389474428092800390517…, by mpmath's quad and findroot, and the length there
// and of all by its quad.
TEST_CASE("interpolation: along what is no PH curve, at a constant speed") {
  const NamedSmoothPath loop{
      "loop", SmoothPath(bezier_curve(
                  {{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}))};
  const FrameTable table = answer(loop, InterpolationQuery{feed({2}), 1});
  REQUIRE(table.rows.size() == 6);
  CHECK(table.columns == std::vector<std::string>{"k", "time", "t", "s", "x", "y", "z"});
  CHECK(table.format == "interpolation/1");
  CHECK(table.rows[0] == Row{0, 0, 0, 0, 0, 0, 0});
  CHECK(table.rows[1] == Row{1, 1, 0.1738947442809280039052, 2, 1.472700953836089241315,
                             1.118985053679505924174, 0.4344386316270840689373});
  CHECK(table.rows[5] == Row{5, 4.124762550394943255835, 1, 8.249525100789886511671, 0, 0, 0});
  // A quarter of a circle, then a line: the end is a tick.
  const NamedSmoothPath bend{"", joined({bezier_curve({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2}),
                                         bezier_curve({{0, 1, 0}, {-1, 1, 0}})})};
  const FrameTable points = answer(bend, InterpolationQuery{feed({Rational(1, 2)}), 1});
  REQUIRE(points.rows.size() == 7);
  CHECK(points.rows[2][4] == std::cos(1.0));  // correctly rounded in glibc
  CHECK(points.rows[2][5] == std::sin(1.0));
  CHECK(points.rows[5][2] > 1);
  CHECK(points.rows[5][5] == 1);
  const NamedSmoothPath line{"", joined({bezier_curve({{0, 0, 0}, {1, 2, 2}}),
                                         bezier_curve({{1, 2, 2}, {2, 4, 4}, {4, 8, 8}})})};
  const FrameTable ticks = answer(line, InterpolationQuery{feed({3}), 2});
  REQUIRE(ticks.rows.size() == 3);
  CHECK(ticks.rows[1] == Row{1, 2, 1.41421356237309504880, 6, 2, 4, 4});  // (1 + t)² = 2
  CHECK(ticks.rows[2] == Row{2, 4, 2, 12, 4, 8, 8});
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({1, 1}), 1}), InputError);
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({-1}), 1}), DomainError);
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({1}), 0}), DomainError);
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({1}), Rational(1, 10'000'000)}), InputError);
}
