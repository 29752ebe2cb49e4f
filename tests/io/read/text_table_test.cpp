#include "phrame/io/read/text_table.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "support/refusal.hpp"

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
}

namespace {

using Names = std::vector<std::string>;

std::string number_refusal(const std::string& text) {
  return test::refusal_of([&] { TextTable(text, {}).number(0, 0); });
}

}  // namespace

TEST_CASE("text table: units are no part of names, in the header or in a row below it") {
  const TextTable above("X [mm];Y (mm);t/s\n1;2;3\n", {});
  CHECK(above.names() == Names{"X", "Y", "t"});
  CHECK(above.units() == Names{"mm", "mm", "s"});
  const TextTable below("Time,X,Y\r\ns,[mm],(mm)\r\n1,2,3\r\n", {});
  CHECK(below.names() == Names{"Time", "X", "Y"});
  CHECK(below.units() == Names{"s", "mm", "mm"});
  CHECK(below.rows() == 1);
  CHECK(below.place(0) == "line 3");
  // What is no unit is a row of its own, which is then refused.
  CHECK(TextTable("x,y\na,q\n1,2\n", {}).rows() == 2);
  CHECK(TextTable("x,y,z,label\n,,,m\n1,2,3,4\n", {}).rows() == 2);
  CHECK_THROWS_WITH_AS(TextTable("x,y\nmm,mm\n", {}), "line 2: there are only units", InputError);
}

TEST_CASE("text table: commas are decimal ones where nothing else is meant, and a note says so") {
  const TextTable table("x;y\n1,5;-0,25\n2;1,0D+01\n", {});
  CHECK(table.number(0, 0) == Rational(3, 2));
  CHECK(table.number(0, 1) == Rational(-1, 4));
  CHECK(table.number(1, 1) == 10);
  CHECK(table.notes() == Names{"commas are decimal ones: 1,5 is 1.5"});
  CHECK(TextTable("0,5\t1,25\n1\t2\n", {}).number(0, 1) == Rational(5, 4));
  CHECK(TextTable("\"1,5\",\"2,25\"\n", {}).number(0, 1) == Rational(9, 4));
  CHECK(TextTable("1,\t2\n", {}).number(0, 1) == 2);  // a tab is a blank here
  CHECK(TextTable("1,234;0,500\n", {}).number(0, 0) == Rational(1234, 1000));
  CHECK(number_refusal("1,234;5,678\n") ==
        "\"1,234\" is not clear: its comma may be a decimal one or one of thousands");
  CHECK(number_refusal("1,5;2.5\n") ==
        "\"1,5\" is not a number: decimals elsewhere have a point, not a comma");
  CHECK(number_refusal("1,5,2;0,5\n").starts_with("\"1,5,2\" is not a number"));
}

TEST_CASE("text table: separators in quotes are none, and a quote is closed on its line") {
  const TextTable table("\"a, b\",\"say \"\"x\"\"\"\n1,2\n", {});
  CHECK(table.names().size() == 2);
  CHECK(table.names()[0] == "a, b");
  CHECK_THROWS_WITH_AS(TextTable("x,y\n1,\"2\n", {}),
                       "line 2: the quote before \"2\" is not closed on its line", InputError);
}

TEST_CASE("text table: exponents of Fortran, and numbers that are missing") {
  const TextTable table("x y z w\n1.0D+00 -2.5d-1 NaN 0x1.dp+0\n", {});
  CHECK(table.number(0, 0) == 1);
  CHECK(table.number(0, 1) == Rational(-1, 4));
  CHECK(table.number(0, 3) == Rational(29, 16));
  CHECK_FALSE(table.is_missing(0, 0));
  CHECK(table.is_missing(0, 2));
  CHECK(TextTable("x,y\n,1\n", {}).is_missing(0, 0));
  CHECK(number_refusal("x,y\n,1\n") == "the field is empty");
}
