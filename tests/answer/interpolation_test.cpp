#include "phrame/answer/interpolation.hpp"

#include <cmath>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

using Row = std::vector<double>;

Feedrate feed(const Polynomial& v, Feedrate::Of of = Feedrate::Of::arc_length) {
  return {RationalFunction(v), of};
}

FrameTable points(const Curve& curve, const Feedrate& feedrate, const Rational& period) {
  return answer(NamedPhPath{"", curve}, InterpolationQuery{feedrate, period});
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
  const PhPath pieces = test::cut(quintic, {Rational(1, 3)});
  const auto check = [](const Curve& whole, const PhPath& cut, const Feedrate& feedrate) {
    const InterpolationQuery query{feedrate, Rational(1, 7)};
    check_columns(answer(NamedPhPath{"", cut}, query), answer(NamedPhPath{"", whole}, query),
                  all_but_t);
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
  const PhPath halves = test::cut(quintic, {Rational(1, 2)});
  const auto of_t = Feedrate::Of::parameter;
  const FrameTable whole =
      answer(NamedPhPath{"", quintic}, InterpolationQuery{feed({1, 0, 1}, of_t), Rational(1, 7)});
  const FrameTable cut =
      answer(NamedPhPath{"", halves},
             InterpolationQuery{feed({1, 0, Rational(1, 4)}, of_t), Rational(1, 7)});
  check_columns(cut, whole, all_but_t);
  for (std::size_t k = 0; k < cut.rows.size(); ++k) CHECK(cut.rows[k][2] == 2 * whole.rows[k][2]);
}

// Two unit lengths along x at V = 1.
TEST_CASE("interpolation: a tick at a joint, and too many rows") {
  const Curve line = test::straight_line().curve;
  const NamedPhPath two{"", test::chain({line, line})};
  const FrameTable table = answer(two, InterpolationQuery{feed({1}), 1});
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[1] == Row{1, 1, 1, 1, 1, 0, 0});
  CHECK(table.rows[2] == Row{2, 2, 2, 2, 2, 0, 0});
  CHECK_THROWS_WITH_AS(answer(two, InterpolationQuery{feed({1}), Rational(1, 5), 10}),
                       "1/5 asks for 11 rows, the limit is 10", InputError);
  CHECK_NOTHROW(answer(two, InterpolationQuery{feed({1}), Rational(1, 5), 11}));
}

namespace {

const NamedPath bezier_loop{
    "loop",
    Path(bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}))};

Path by_formulas(const std::array<const char*, 3>& r) {
  const auto formula = [](const char* text) { return parse_formula(text, "s").value; };
  return Path(ExpressionCurve({formula(r[0]), formula(r[1]), formula(r[2])}, formula("0"),
                              formula("2*pi")));
}

FrameTable points(const Path& path, const Feedrate& feedrate, const Rational& period) {
  return answer(NamedPath{"", path}, InterpolationQuery{feedrate, period});
}

}  // namespace

// s = 2 is at t = 0.17389474428092800390517…, by mpmath's quad and findroot, and the length there
// and of all by its quad.
TEST_CASE("interpolation: along what is no PH curve, at a constant speed") {
  const FrameTable table = answer(bezier_loop, InterpolationQuery{feed({2}), 1});
  REQUIRE(table.rows.size() == 6);
  CHECK(table.columns == std::vector<std::string>{"k", "time", "t", "s", "x", "y", "z"});
  CHECK(table.format == "interpolation/1");
  CHECK(table.rows[0] == Row{0, 0, 0, 0, 0, 0, 0});
  CHECK(table.rows[1] == Row{1, 1, 0.1738947442809280039052, 2, 1.472700953836089241315,
                             1.118985053679505924174, 0.4344386316270840689373});
  CHECK(table.rows[5] == Row{5, 4.124762550394943255835, 1, 8.249525100789886511671, 0, 0, 0});
  // A quarter of a circle, then a line: the end is a tick.
  const NamedPath bend{"", joined({bezier_curve({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2}),
                                   bezier_curve({{0, 1, 0}, {-1, 1, 0}})})};
  const FrameTable points = answer(bend, InterpolationQuery{feed({Rational(1, 2)}), 1});
  REQUIRE(points.rows.size() == 7);
  CHECK(points.rows[2][4] == std::cos(1.0));  // correctly rounded in glibc
  CHECK(points.rows[2][5] == std::sin(1.0));
  CHECK(points.rows[5][2] > 1);
  CHECK(points.rows[5][5] == 1);
  const NamedPath line{"", joined({bezier_curve({{0, 0, 0}, {1, 2, 2}}),
                                   bezier_curve({{1, 2, 2}, {2, 4, 4}, {4, 8, 8}})})};
  const FrameTable ticks = answer(line, InterpolationQuery{feed({3}), 2});
  REQUIRE(ticks.rows.size() == 3);
  CHECK(ticks.rows[1] == Row{1, 2, 1.41421356237309504880, 6, 2, 4, 4});  // (1 + t)² = 2
  CHECK(ticks.rows[2] == Row{2, 4, 2, 12, 4, 8, 8});
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({-1}), 1}), DomainError);
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({1}), 0}), DomainError);
  CHECK_THROWS_AS(answer(line, InterpolationQuery{feed({1}), Rational(1, 10'000'000)}), InputError);
}

// Of the loop and the cubic by mpmath's quad of |r′|/V, by its findroot, with 30 digits; with V = 1
// + s the arc length at time 1 is e − 1.
TEST_CASE("interpolation: along what is no PH curve, speeds by s, t and kappa") {
  const FrameTable by_length = points(bezier_loop.path, feed({1, 1}), 1);
  REQUIRE(by_length.rows.size() == 4);
  CHECK(by_length.rows[1] == Row{1, 1, 0.1364853451495639027764, 1.71828182845904523536,
                                 1.335776702009115469033, 0.8766717058260323543725,
                                 0.4718677827756502412601});
  CHECK(by_length.rows[3][1] == 2.224572209751220143833);
  const FrameTable by_t = points(bezier_loop.path, feed({2, 0, 1}, Feedrate::Of::parameter), 1);
  CHECK(by_t.rows[1] == Row{1, 1, 0.1750375762162693844923, 2.007738171543765348614,
                            1.475490139445361992957, 1.12604078724539050934,
                            0.4329168065156783457097});
  CHECK(by_t.rows.back()[1] == 3.586869680309328560791);
  // Its curvature is between −0.72 and −0.12.
  const FrameTable by_bend =
      points(Path(bezier_curve({{0, 0, 0}, {1, 2, 0}, {3, 2, 0}, {4, -1, 0}})),
             {RationalFunction({5}, {3, -1}), Feedrate::Of::curvature}, 2);
  CHECK(by_bend.rows[1] == Row{1, 2, 0.5538495142209626712003, 2.852222375512898711222,
                               2.242010511563043669928, 1.312708436754881364153, 0});
  CHECK(by_bend.rows.back()[1] == 3.982973154767585820887);
}

// mpmath as above. The normal of the ellipse's plane with a positive last component is (−4, 3,
// 0)/5; about it the ellipse turns right.
TEST_CASE("interpolation: along formulas, speeds by t and kappa") {
  const Path trefoil =
      by_formulas({"(2 + cos(3*s))*cos(2*s)", "(2 + cos(3*s))*sin(2*s)", "sin(3*s)"});
  const FrameTable by_t = points(trefoil, feed({2, 1}, Feedrate::Of::parameter), 10);
  REQUIRE(by_t.rows.size() == 3);
  CHECK(by_t.rows[1] == Row{1, 10, 0.7215301066591248890039, 23.47512461044014972973,
                            -2.352248791819745281314, 0.8793913233987564511948,
                            0.8594288556111466019712});
  CHECK(by_t.rows[2][1] == 12.93763232650282168004);
  const FrameTable by_bend =
      points(by_formulas({"3*cos(s)", "4*cos(s)", "2*sin(s)"}),
             {RationalFunction({4, -1}, {2, 0, 1}), Feedrate::Of::curvature}, 7);
  CHECK(by_bend.rows[1] == Row{1, 7, 0.6303838331442175792719, 13.7863710309328991524,
                               -2.048361201150239474484, -2.731148268200319299312,
                               -1.461234849117895624215});
  CHECK(by_bend.rows[2][1] == 11.60351323588437306095);
}

// The PH way has closed forms and needs none of this.
TEST_CASE("interpolation: law: a PH path by its positions is passed as in closed form") {
  const Curve quintic = test::farouki_quintic().curve;
  const Curve plane({{1}, {}, {}, {0, 1}});
  const auto check = [](const PhPath& path, const Feedrate& feedrate) {
    const InterpolationQuery query{feedrate, Rational(1, 5)};
    const FrameTable exact = answer(NamedPhPath{"", path}, query);
    const FrameTable found = answer(NamedPath{"", test::by_positions(path)}, query);
    CHECK(found.rows.size() > 3);
    CHECK(found.rows == exact.rows);
  };
  check(test::cut(quintic, {Rational(1, 3)}), feed({1, 0, Rational(1, 4)}));
  check(quintic, {RationalFunction({3}, {1, 1}), Feedrate::Of::arc_length});
  check(test::cut(quintic, {Rational(1, 2)}),
        {RationalFunction({1, 1}, {2, 0, 1}), Feedrate::Of::parameter});
  check(test::cut(plane, {Rational(1, 3), Rational(2, 3)}),
        {RationalFunction({5}, {1, 2}), Feedrate::Of::curvature});
  check(plane, {RationalFunction({3, 0, 1}, {1, 1, 1}), Feedrate::Of::curvature});
  // (4t, −4t, 2 − 4t²)/2: the unit normal (1, 1, 0)/√2 is irrational, κ no rational function.
  const Rational half(1, 2);
  const Curve slanted({{half}, {half, 1}, {-half}, {half, -1}});
  check(slanted, {RationalFunction({3, 0, 1}, {1, 1, 1}), Feedrate::Of::curvature});
  // Turned back at t = 1/2, and joined to what goes back.
  const Curve turning({{1}, {}, {}, {}}, {3, -6});
  check(test::chain({test::straight_line().curve, turning}), feed({1, 0, Rational(1, 4)}));
  check(test::chain({test::straight_line().curve, turning}),
        {RationalFunction({1, 1}, {2, 0, 1}), Feedrate::Of::parameter});
}

// Half of the cubic as a PH segment, the rest by its positions.
TEST_CASE("interpolation: law: segments of two kinds are passed as those of one") {
  const Curve plane({{1}, {}, {}, {0, 1}});
  const PhPath pieces = test::cut(plane, {Rational(1, 3), Rational(2, 3)});
  Path mixed(test::by_positions(pieces).segments()[0]);
  mixed.append(PhSegment(pieces.segments()[1]));
  mixed.append(test::by_positions(pieces).segments()[2]);
  for (const Feedrate& feedrate :
       {feed({2}), feed({1, 0, Rational(1, 4)}), feed({1, 3}, Feedrate::Of::parameter),
        Feedrate{RationalFunction({5}, {1, 2}), Feedrate::Of::curvature}}) {
    const FrameTable found = points(mixed, feedrate, Rational(1, 9));
    CHECK(found.rows.size() > 3);
    CHECK(found.rows == points(Path(pieces), feedrate, Rational(1, 9)).rows);
  }
}

TEST_CASE("interpolation: speeds that are not positive are refused, with the place") {
  const auto refused = [](const Path& path, const Feedrate& feedrate, const char* reason) {
    CHECK_THROWS_WITH_AS(points(path, feedrate, 1), doctest::Contains(reason), DomainError);
  };
  const Path& loop = bezier_loop.path;  // of the length 8.2495…
  refused(loop, feed({5, -1}), "the speed is 0 at s = 5");
  refused(loop, feed({-9, 1}), "the speed is negative, -9 at s = 0");
  CHECK(points(loop, feed({Rational(33, 4), -1}), 1).rows.back()[3] == 8.249525100789886511671);
  refused(loop, {RationalFunction({1}, {-1, 2}), Feedrate::Of::parameter},
          "the speed is infinite at t = 1/2");
  refused(loop, feed({1, 1}, Feedrate::Of::curvature), "in one plane");
  // (t, t³ − t²) turns left from t = 1/3 on.
  const Path bend(RationalCurve({Polynomial{0, 1}, Polynomial{0, 0, -1, 1}, {}}));
  refused(bend, feed({0, -1}, Feedrate::Of::curvature), "the speed is 0 or infinite at t ≈ 0.3333");
  refused(bend, feed({0, 1}, Feedrate::Of::curvature), "the speed is negative at t = 0");
  refused(Path(RationalCurve({Polynomial{0, 0, 1}, {0, 0, 0, 1}, {}})),
          feed({1, 0, 1}, Feedrate::Of::curvature), "cusp");
  const Path line(bezier_curve({{1, 2, 2}, {2, 4, 4}, {4, 8, 8}}));
  refused(line, {RationalFunction({1}, {0, 1}), Feedrate::Of::curvature}, "divides by zero");
  CHECK(points(line, {RationalFunction({3, 1}, {2}), Feedrate::Of::curvature}, 2).rows[3] ==
        Row{3, 6, 1, 9, 4, 8, 8});
  // The line from −1 to 3 by t + t² is at 0 at the time 1, exactly; the length is 1 there.
  const Path through(RationalCurve({Polynomial{-1, 0, 4}, {0, 0, 0}, {}}));
  CHECK(points(through, {RationalFunction({2}, {1, 2}), Feedrate::Of::arc_length}, 1).rows[1] ==
        Row{1, 1, 0.5, 1, 0, 0, 0});
}

// The row after one period of a table of two rows is computed exactly.
TEST_CASE("interpolation: the rows of a long table are those of short ones") {
  for (const Path& path :
       {Path(test::farouki_quintic().curve), Path(test::chain(test::quarters())),
        Path(bezier_curve({{0, 0, 0}, {1, 0, 2}, {2, 1, 0}, {1, 1, 1}}, {1, 2, 3, 1}))}) {
    const RealBall total = PathLength(path).total().enclose(64);
    const Rational period = total.lower() / 1000;
    const FrameTable all = answer(NamedPath{"", path}, InterpolationQuery{feed({2}), period});
    REQUIRE(all.rows.size() > 500);
    for (long k = 1; k < 500; k += 31) {
      CAPTURE(k);
      const InterpolationQuery query{feed({2}), Rational(k) * period};
      const Row row = answer(NamedPath{"", path}, query).rows[1];
      CHECK(all.rows[static_cast<std::size_t>(k)][0] == static_cast<double>(k));
      CHECK(Row(all.rows[static_cast<std::size_t>(k)].begin() + 1,
                all.rows[static_cast<std::size_t>(k)].end()) == Row(row.begin() + 1, row.end()));
    }
  }
}
