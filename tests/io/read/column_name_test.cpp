#include "phrame/io/read/column_name.hpp"

#include <doctest/doctest.h>

namespace column_name_test {

using namespace phrame;

TEST_CASE("column name: a unit is taken off, and nothing else") {
  const auto parts = [](std::string_view header) {
    const ColumnName name = column_name(header);
    return name.name + "|" + name.unit;
  };
  CHECK(parts("X [mm]") == "X|mm");
  CHECK(parts("x (m)") == "x|m");
  CHECK(parts("v[m/s]") == "v|m/s");
  CHECK(parts("y/mm") == "y|mm");
  CHECK(parts(" f2x [-] ") == "f2x|");
  CHECK(parts("f(x)") == "f(x)|");
  CHECK(parts("a/b") == "a/b|");
  CHECK(parts("[mm]") == "[mm]|");
}

TEST_CASE("column name: units are known with and without brackets") {
  for (const char* text : {"mm", "[mm]", "(m/s)", "-", "MM", "µm", " deg "}) CHECK(is_unit(text));
  for (const char* text : {"x", "", "12", "mm/", "[]"}) CHECK_FALSE(is_unit(text));
  CHECK(unit_in("[mm]") == "mm");
  CHECK(unit_in("-").empty());
}

TEST_CASE("column name: positions have many names, and tell their axis") {
  const auto found = [](std::string_view name) {
    const auto column = position_column(name);
    return column ? column->family + std::to_string(column->axis) : "";
  };
  CHECK(found("pos_x") == "pos0");
  CHECK(found("Position Y") == "position1");
  CHECK(found("posZ") == "pos2");
  CHECK(found("px") == "p0");
  CHECK(found("tz") == "t2");
  CHECK(found("x_pos") == "pos0");
  CHECK(found("field.pose.position.y") == "position1");
  CHECK(found("x").empty());
  CHECK(found("f2x").empty());
  CHECK(found("").empty());
}

TEST_CASE("column name: words that stand for no number") {
  for (const char* text : {"", "NaN", "-inf", "null", "N/A"}) CHECK(is_missing_text(text));
  for (const char* text : {"0", "x", "nan1"}) CHECK_FALSE(is_missing_text(text));
  CHECK(lower_case("X-Y z") == "x-y z");
}

}  // namespace column_name_test
