#include "phrame/io/read/pose_columns.hpp"

#include <doctest/doctest.h>

#include "phrame/io/read/text_table.hpp"

namespace pose_columns_test {

using namespace phrame;

namespace {

std::optional<PoseColumns> columns(const std::string& text) {
  return matrix_columns(TextTable(text, {}));
}

}  // namespace

// A quarter turn about z takes x to y; the position is (7, 8, 9).
TEST_CASE("pose columns: matrices are seen by rows and by columns") {
  const auto three = columns("0 -1 0 7 1 0 0 8 0 0 1 9\n");
  REQUIRE(three);
  CHECK(three->position == std::array<std::size_t, 3>{3, 7, 11});
  CHECK(three->rotation == std::array<std::size_t, 9>{0, 1, 2, 4, 5, 6, 8, 9, 10});
  CHECK(three->what == "3 × 4 matrices, row by row");
  CHECK(columns("0 -1 0 7 1 0 0 8 0 0 1 9 0 0 0 1\n")->what == "4 × 4 matrices, row by row");
  const auto turned = columns("0 1 0 0 -1 0 0 0 0 0 1 0 7 8 9 1\n");
  REQUIRE(turned);
  CHECK(turned->position == std::array<std::size_t, 3>{12, 13, 14});
  CHECK(turned->rotation == std::array<std::size_t, 9>{0, 4, 8, 1, 5, 9, 2, 6, 10});
}

TEST_CASE("pose columns: what is no rotation is none") {
  CHECK_FALSE(columns("0 -1 0 7 1 0 0 8 0 0 2 9\n"));
  CHECK_FALSE(columns("0 1 0 7 1 0 0 8 0 0 1 9\n"));  // a reflection
  CHECK_FALSE(columns("0 -1 0 7 1 0 0 8 0 0 1 9 0 0 1 1\n"));
  CHECK_FALSE(columns("0 -1 0 7 1 0 0 8 0 0 1\n"));
  CHECK_FALSE(columns("0 -1 0 7 1 0 0 8 0 0 1 x\n"));
  CHECK_FALSE(columns("0 -1 0 nan 1 0 0 8 0 0 1 9\n"));
  CHECK(columns("0 -1 0 nan 1 0 0 8 0 0 1 9\n0 -1 0 7 1 0 0 8 0 0 1 9\n"));
}

TEST_CASE("pose columns: a quaternion has the length 1") {
  CHECK(is_unit_quaternion(TextTable("5 0.6 0 0 0.8\n", {}), 1));
  CHECK_FALSE(is_unit_quaternion(TextTable("5 0.6 0 0 0.9\n", {}), 1));
}

}  // namespace pose_columns_test
