#include "phrame/io/read/curve_choice.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

TEST_CASE("curve choice: the only one, or the one that is named") {
  const std::vector<CurveLabel> labels{{"left", "a"}, {"", "b"}};
  CHECK(chosen_curve({{"left", "a"}}, "") == 0);
  CHECK(chosen_curve(labels, "b") == 1);
  CHECK(chosen_curve(labels, "a") == 0);
  CHECK(chosen_curve(labels, "left") == 0);
  CHECK_THROWS_WITH_AS(chosen_curve(labels, ""),
                       "there are 2 curves, and --pick names one: left, b", InputError);
  CHECK_THROWS_WITH_AS(chosen_curve(labels, "c"), "there is no curve \"c\"; there are left, b",
                       InputError);
  CHECK_THROWS_WITH_AS(chosen_curve({{"a", "1"}, {"a", "2"}}, "a"), "2 curves are called \"a\"",
                       InputError);
}
