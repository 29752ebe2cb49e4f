#include "phrame/io/read/suggestion.hpp"

#include <doctest/doctest.h>

using namespace phrame;

TEST_CASE("suggestion: the nearest name, a part of one, or none") {
  const std::vector<std::string> keys{"phrame",   "name",        "basis", "start",
                                      "preimage", "quaternions", "hopf",  "control_points"};
  CHECK(suggestion("points", keys) == "control_points");
  CHECK(suggestion("controlPoints", keys) == "control_points");
  CHECK(suggestion("control-point", keys) == "control_points");
  CHECK(suggestion("quaternion", keys) == "quaternions");
  CHECK(suggestion("Name", keys) == "name");
  CHECK(suggestion("bais", keys) == "basis");
  CHECK(suggestion("starting_point", keys) == "start");
  CHECK_FALSE(suggestion("weights", keys));
  CHECK_FALSE(suggestion("", keys));
  CHECK_FALSE(suggestion("x", keys));
  CHECK_FALSE(suggestion("xy", {"ab"}));
  // What begins with it goes before what has it in the middle, or is spelt nearly so.
  CHECK(suggestion("--out", {"--route", "--output", "--without"}) == "--output");
  CHECK(suggestion("--pri", {"--principal-value", "--print", "--prim"}) == "--prim");
  CHECK(suggestion("form", {"from", "formula"}) == "formula");
  CHECK(suggestion("fron", {"from", "formula"}) == "from");
  CHECK(suggestion("angel", {"mtf", "angle", "check"}) == "angle");
}
