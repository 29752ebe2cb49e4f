#include "phrame/answer/near_rows.hpp"

#include <algorithm>
#include <sstream>

#include "io/reference.hpp"
#include "phrame/answer/frame_rows.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/frame/rational_frame.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace near_rows_test {

/// Of `count` rows along a path, equally spaced by t or by arc length: the share of those that
/// doubles were enough for. Every `step`-th of these is compared with that of a table of one row,
/// which is computed exactly.
double compare_rows(const Path& path, bool is_by_length, long count, long step,
                    const FrameStart& start = {}) {
  const PathAngle angle = angle_to(std::nullopt, path);
  const PathLength length(path);
  TableColumns columns{{TabulatedFrame::rmf}, {TabulatedScalar::arc_length}};
  columns.start = start;
  TableColumns exact = columns;
  exact.digits = 1;  // for decimals doubles are not asked
  const auto at = [&](std::vector<Rational> numbers) {
    return is_by_length ? RowPlaces(std::move(numbers), length)
                        : RowPlaces(std::move(numbers),
                                    [path](const Rational& t) { return Place(locate(path, t)); });
  };
  const RealBall total = length.total().enclose(64);
  const Rational end = is_by_length ? length.total().exact().value_or(total.lower()) : path.end();
  std::vector<Rational> numbers;
  for (long k = 0; k < count; ++k) numbers.push_back(end * Rational(k, count - 1));
  const FrameRows rows(angle, columns, at(numbers));
  std::vector<std::vector<double>> made(numbers.size());
  const std::vector<std::size_t> untold = rows.near(0, made);
  long near = 0;
  for (std::size_t number = 0; number < numbers.size(); ++number) {
    const std::vector<double>& row = made[number];
    if (std::binary_search(untold.begin(), untold.end(), number)) continue;
    if (near++ % step != 0) continue;
    CAPTURE(number);
    FrameRows one(angle, exact, at({numbers[number]}));
    std::vector<double> none;
    REQUIRE(one.near(0, {&none, 1}).size() == 1);
    CHECK(row == one.exact(0).values);
  }
  return static_cast<double>(near) / static_cast<double>(count);
}

/// The curve, cut into 13 segments.
Path many_segments(const Curve& curve) {
  std::vector<Rational> at;
  for (long k = 1; k < 13; ++k) at.emplace_back(k * k, 169);
  return test::cut(curve, at);
}

/// Also with other starts.
void check_rows(const Path& path, long step = 97) {
  const long more = test::everyday(12, 1);
  CHECK(compare_rows(path, false, 3001, more * step) > 0.9);
  CHECK(compare_rows(path, true, 1501, more * step) > 0.9);
  CHECK(compare_rows(path, false, 3001, 3 * more * step, StartNormal({3, -1, 2})) > 0.9);
}

}  // namespace near_rows_test

using namespace near_rows_test;

TEST_CASE("near rows: of curves of many kinds they are the exact ones, and nearly all there") {
  SUBCASE("a quintic") { check_rows(Path(test::quintic)); }
  SUBCASE("with f < 0") {
    check_rows(Path(Curve(test::quintic.preimage(), Polynomial{-1, Rational(-1, 3)})));
  }
  SUBCASE("a near-cusp, whose frame turns within 10^-8") {
    const Polynomial zero{-1, 3};
    const Rational tiny = parse_rational("1e-8");
    check_rows(Path(Curve({zero * Polynomial{1, 1} + Polynomial{tiny}, Rational(2) * zero,
                           zero * Polynomial{-2, 1}, zero + Polynomial{3 * tiny}})));
  }
  SUBCASE("of degree 41") {
    test::Random random(41);
    QuaternionPolynomial a;
    for (Polynomial* p : {&a.u, &a.v, &a.p, &a.q}) {
      std::vector<Rational> c;
      for (int k = 0; k <= 20; ++k) c.emplace_back(random.integer(-9, 9));
      *p = Polynomial(c);
    }
    check_rows(Path(Curve(a)), 401);
  }
  SUBCASE("closed, of four segments") { check_rows(Path(test::chain(test::quarters()))); }
  SUBCASE("of twenty segments, of which three are tried") {
    std::vector<Curve> segments;
    for (long k = 0; k < 20; ++k)
      segments.push_back(segment(test::quintic, Rational(k, 20), Rational(k + 1, 20)));
    check_rows(Path(test::chain(segments)));
  }
  SUBCASE("with corners") {
    check_rows(joined({bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}}),
                       bezier_curve({{2, 2, 1}, {2, 2, 3}, {0, 1, 3}}),
                       bezier_curve({{0, 1, 3}, {5, 1, 3}})}));
  }
  SUBCASE("rational") {
    check_rows(Path(bezier_curve({{0, 0, 0}, {1, 0, 2}, {2, 1, 0}, {1, 1, 1}}, {1, 2, 3, 1})));
  }
  SUBCASE("by formulas") {
    check_rows(Path(test::expression_curve({"s", "exp(s)", "sin(3*s)"}, "0", "2")), 311);
  }
}

// The end of a segment is no number: at a joint that would be the start of the next one.
TEST_CASE("near rows: of tables too short to compile PH curves they are the exact ones, too") {
  CHECK(compare_rows(Path(test::quintic), false, 101, 7) > 0.9);
  CHECK(compare_rows(Path(test::quintic), false, 101, 7, StartNormal({3, -1, 2})) > 0.9);
  CHECK(compare_rows(Path(test::cut(test::quintic, {Rational(1, 3), Rational(3, 4)})), false, 101,
                     7) > 0.9);
  CHECK(compare_rows(many_segments(Curve(test::class_one)), false, 201, 11) > 0.9);
}

// Where the frame is rational, along one segment it is found as fractions, behind many by balls,
// and by fractions again where these do not tell a component.
TEST_CASE("near rows: decimals along many segments with a rational frame are those along one") {
  // Turned so that e₁, f₂ and f₃ are the axes at the end.
  const auto rational = rational_frame(test::class_one);
  const QuaternionPolynomial& b = std::get<RationalFrame>(rational).preimage;
  const RationalQuaternion end = evaluate(b, 1);
  const QuaternionPolynomial back{Polynomial{end.u}, Polynomial{-end.v}, Polynomial{-end.p},
                                  Polynomial{-end.q}};
  const Curve curve(back * test::class_one);
  const Path path = many_segments(curve);
  TableColumns columns{{TabulatedFrame::rmf}};
  columns.digits = 25;
  columns.have_quaternions = true;
  columns.start = StartNormal(rotated_j(evaluate(back * b, 0)));
  std::vector<Place> along_one;
  std::vector<Place> along_many;
  for (long k = 0; k < 13; ++k)
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
      along_many.emplace_back(static_cast<std::size_t>(k), t);
      along_one.emplace_back(0, Rational((k * k + t * (2 * k + 1)) / 169));
    }
  const FrameTable one = frame_table(PathAngle{Path(curve)}, columns, along_one);
  const FrameTable many = frame_table(PathAngle(path), columns, along_many);
  for (std::size_t k = 0; k < along_one.size(); ++k)
    for (std::size_t i = 1; i < one.columns.size(); ++i)  // but for t
      CHECK(one.decimals[k][i] == many.decimals[k][i]);
  CHECK(std::vector(many.rows.back().begin() + 4, many.rows.back().begin() + 13) ==
        std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
}

TEST_CASE("near rows: at a corner they are those of the side that is asked for") {
  const Path path = test::polygon({{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {2, 5, 4}});
  const PathAngle angle = angle_to(std::nullopt, path);
  TableColumns columns{{TabulatedFrame::rmf}};
  std::vector<Place> at(2000, Place(1, Rational(1, 3)));
  at[7] = Place(0, Rational(1));
  at[8] = Place(1, Rational(0));
  const FrameTable all = frame_table(angle, columns, at);
  CHECK(all.rows[7] == frame_table(angle, columns, {at[7]}).rows[0]);
  CHECK(all.rows[8] == frame_table(angle, columns, {at[8]}).rows[0]);
  CHECK(all.rows[7][4] != all.rows[8][4]);
}

// The arc length is none of a polynomial where f changes its sign.
TEST_CASE("near rows: of a curve that turns back they are the exact ones") {
  const Path path(Curve(test::quintic.preimage(), Polynomial{-1, 3}));
  CHECK(compare_rows(path, false, 3001, 37) == 0);  // with a column of s
  CHECK(compare_rows(path, true, 1501, 401) == 0);
}

// Every day of every eightieth line.
TEST_CASE("near rows: along the collections they are the exact ones") {
  const long every = test::everyday(80, 1);
  std::istringstream lines(test::read_data("curves.jsonl"));
  long curves = 0;
  double share = 0;
  long number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (number++ % every != 0) continue;
    if (line.size() > 4000) continue;  // the exact rows of others take long
    CAPTURE(line.substr(0, 60));
    const Path path = read_any_path(line).path;
    share += compare_rows(path, false, 3001, 1200);
    share += compare_rows(path, true, 1501, 600);
    curves += 2;
  }
  std::istringstream others(test::read_data("any_curves.jsonl"));
  for (std::string line; std::getline(others, line);) {
    if (number++ % every != 0) continue;
    const JsonValue document = parse_json_file(line, "line");
    const Path path = read_any_path(JsonNode(document).at("file")).path;
    share += compare_rows(path, false, 4001, 1600);
    ++curves;
  }
  CHECK(share > 0.8 * static_cast<double>(curves));
}
