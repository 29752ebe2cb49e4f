#include "phrame/io/read/text_table.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

TEST_CASE("text table: names, numbers and places, with and without a header") {
  const TextTable named("# made by hand\nt; a\n\n1/3; 2\n# half way\n4;5", {});
  CHECK(named.names() == std::vector<std::string>{"t", "a"});
  CHECK(named.header_place() == "line 2");
  CHECK(named.rows() == 2);
  CHECK(named.columns() == 2);
  CHECK(named.number(0, 0) == Rational(1, 3));
  CHECK(named.number(1, 1) == 5);
  CHECK(named.place(1) == "line 6");
  const TextTable bare("1 2 3\n4 5 6\n", {});
  CHECK(bare.names().empty());
  CHECK(bare.columns() == 3);
}

TEST_CASE("text table: the comment above is the header if it is asked for one") {
  const std::string text = "# a b\n1 2\n";
  CHECK(TextTable(text, {}).names().empty());
  CHECK(TextTable(text, {true, "points"}).names() == std::vector<std::string>{"a", "b"});
}

TEST_CASE("text table: a table without rows is said to have none of what was wanted") {
  CHECK_THROWS_WITH_AS(TextTable("x,y\n", {false, "points"}), "line 2: there are no points",
                       InputError);
  CHECK(lower_case("X-Y z") == "x-y z");
}
