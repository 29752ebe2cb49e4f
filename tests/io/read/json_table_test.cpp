#include "phrame/io/read/json_table.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "support/refusal.hpp"

namespace json_table_test {

using namespace phrame;

namespace {

JsonTable table(const std::string& text) { return JsonTable(parse_json(text)); }

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { table(text); });
}

}  // namespace

TEST_CASE("JSON table: lists of numbers are rows without names, matrices row by row") {
  const JsonTable rows = table(R"([[0.1, "1/3", 2], [3, 4, 5]])");
  CHECK(rows.names().empty());
  CHECK(rows.rows() == 2);
  CHECK(rows.columns() == 3);
  CHECK(rows.number(0, 0) == Rational(1, 10));
  CHECK(rows.number(0, 1) == Rational(1, 3));
  CHECK(rows.place(1) == "/1");
  CHECK(rows.place_in_row(1, 2, "z") == "/1/2");
  const JsonTable matrices = table("[[[1, 2], [3, 4]]]");
  CHECK(matrices.columns() == 4);
  CHECK(matrices.number(0, 2) == 3);
  CHECK(matrices.number(0, 3) == 4);
}

TEST_CASE("JSON table: objects are rows whose keys are the names") {
  const JsonTable rows = table(R"([{"t": 1, "position": {"x": 2, "y": 3}, "v [m/s]": [4, 5, 6]},
                {"position": {"x": 7, "y": null}, "t": "nan"}])");
  CHECK(rows.names() == std::vector<std::string>{"t", "position.x", "position.y", "v [m/s].x",
                                                 "v [m/s].y", "v [m/s].z"});
  CHECK(rows.number(0, 5) == 6);
  CHECK(rows.number(1, 1) == 7);
  CHECK(rows.is_missing(1, 0));
  CHECK(rows.is_missing(1, 2));
  CHECK(rows.is_missing(1, 3));
  CHECK_FALSE(rows.is_missing(1, 1));
  CHECK_THROWS_WITH_AS(rows.number(1, 3), "there is no number", InputError);
}

TEST_CASE("JSON table: what is no list of rows is refused at its place") {
  CHECK(refusal("[]") == "/: the list is empty");
  CHECK(refusal("{}").starts_with("/: a list of rows is wanted"));
  CHECK(refusal("[1, 2]").starts_with("/0: a row is wanted, not the number 1"));
  CHECK(refusal("[[1, 2], {}]").starts_with("/1: a row like the first is wanted"));
  CHECK(refusal("[[1, 2], [3]]") == "/1: 1 number here, but 2 in the first row");
  CHECK(refusal("[[]]") == "/0: the row is empty");
}

}  // namespace json_table_test
