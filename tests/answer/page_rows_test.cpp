#include "phrame/answer/page_rows.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/expression_curves.hpp"

using namespace phrame;

namespace page_rows_test {

namespace {

using Graph = double (*)(std::size_t segment, double t);

/// Rows of t and of a graph as the curvature, and of a column that pages do not plot.
RowMaker rows_of(Graph graph) {
  return [graph](const std::vector<PathParameter>& places) {
    FrameTable table;
    table.columns = {"t", "curvature", "f2x"};
    for (const PathParameter& place : places) {
      const double t = round_to_double(place.t);
      const double away = t * (1 - t) * (std::fmod(1000 * t, 2) < 1 ? 1 : -1);
      table.rows.push_back({static_cast<double>(place.segment) + t, graph(place.segment, t), away});
    }
    return table;
  };
}

/// k/parts of each segment, and the end.
std::vector<PathParameter> equal_steps(std::size_t segments, long parts) {
  std::vector<PathParameter> at;
  for (std::size_t segment = 0; segment < segments; ++segment)
    for (long k = 0; k < parts; ++k) at.push_back({segment, Rational(k, parts)});
  at.push_back({segments - 1, 1});
  return at;
}

/// Ascending, in the order of the rows' t, and all places are still there.
void check_order(const PageRows& rows, const std::vector<PathParameter>& given) {
  REQUIRE(rows.at.size() == rows.table.rows.size());
  for (std::size_t k = 1; k < rows.at.size(); ++k) {
    CHECK(is_before(rows.at[k - 1], rows.at[k]));
    CHECK(rows.table.rows[k - 1][0] < rows.table.rows[k][0]);
  }
  for (const PathParameter& place : given)
    CHECK(std::count_if(rows.at.begin(), rows.at.end(), [&](const PathParameter& at) {
            return at.segment == place.segment && at.t == place.t;
          }) == 1);
}

}  // namespace

TEST_CASE("page rows: a straight graph has the rows that were asked for, whatever is not plotted") {
  const auto at = equal_steps(1, 20);
  const PageRows rows = page_rows(at, rows_of([](std::size_t, double t) { return 3 - 2 * t; }));
  CHECK(rows.at.size() == at.size());
  CHECK(rows.jumps.empty());
  check_order(rows, at);
}

TEST_CASE("page rows: more where a graph bends, and only there") {
  const auto at = equal_steps(1, 20);
  const PageRows rows =
      page_rows(at, rows_of([](std::size_t, double t) { return std::abs(t - 0.52); }));  // a corner
  check_order(rows, at);
  std::size_t near = 0;
  for (const PathParameter& place : rows.at) {
    const double t = round_to_double(place.t);
    const bool is_new = round_to_double(20 * place.t) != std::round(20 * t);
    if (is_new) CHECK(std::abs(t - 0.52) <= 0.1);
    near += is_new;
  }
  CHECK(near >= 2);
}

TEST_CASE("page rows: of a joint where a graph jumps both limits, of a smooth one none") {
  const auto at = equal_steps(3, 8);
  const PageRows rows =
      page_rows(at, rows_of([](std::size_t segment, double t) {
                  return segment == 0 ? t : segment == 1 ? 1 - t : 5 - t;  // 1 | 1 … 0 | 5
                }));
  check_order(rows, at);
  REQUIRE(rows.jumps.size() == 1);
  const auto& [row, before] = rows.jumps.front();
  CHECK(rows.at[row].segment == 2);
  CHECK(rows.at[row].t == 0);
  CHECK(before[1] == 0);
  CHECK(rows.table.rows[row][1] == 5);
}

TEST_CASE("page rows: what is undefined at a joint on one side only is a jump") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const RowMaker make = [](const std::vector<PathParameter>& places) {
    FrameTable table;
    table.columns = {"t", "torsion"};
    for (const PathParameter& place : places)
      table.rows.push_back({static_cast<double>(place.segment) + round_to_double(place.t),
                            place.segment == 1 ? nan : 0.0});
    return table;
  };
  const PageRows rows = page_rows(equal_steps(4, 4), make);
  REQUIRE(rows.jumps.size() == 2);  // 0 | nan | 0 · 0
  CHECK(rows.at[rows.jumps[0].row].segment == 1);
  CHECK(rows.jumps[0].before[1] == 0);
  CHECK(rows.at[rows.jumps[1].row].segment == 2);
  CHECK(std::isnan(rows.jumps[1].before[1]));
}

TEST_CASE("page rows: places are told apart as doubles tell them, and segments always") {
  const Rational third(1, 3);
  CHECK(is_same_place({2, third}, {2, exact_rational(round_to_double(third))}));
  CHECK_FALSE(is_same_place({2, third}, {2, Rational(1, 3) + power_of_two(-40)}));
  CHECK(is_same_place({0, 0}, {0, power_of_two(-100)}));
  CHECK_FALSE(is_same_place({0, 1}, {1, 0}));
  CHECK(is_before({0, 1}, {1, 0}));
  CHECK_FALSE(is_before({1, 0}, {1, 0}));
}

// κ of (t, t²) is 2/(1 + 4t²)^(3/2), greatest at t = 0: in the middle of s from −1 to 1.
TEST_CASE("page rows: the turns of a path hold the greatest curvature of a parabola") {
  const PathTurns turns =
      path_turns(PathAngle(Path(test::expression_curve({"s", "s^2", "0"}, "-1", "1"))));
  CHECK(turns.infinite.empty());
  CHECK(std::any_of(turns.at.begin(), turns.at.end(), [](const PathParameter& at) {
    return is_same_place(at, {0, Rational(1, 2)});
  }));
}

}  // namespace page_rows_test
