#include "phrame/io/read/g2_file.hpp"

#include <doctest/doctest.h>

#include "io/reference.hpp"

namespace g2_file_test {

using namespace phrame;
using test::refusal;

// A half circle: of control points (x, y, w) those of a rational curve are multiplied by w.
TEST_CASE("G2: a B-spline, or one with weights, that control points are multiplied by") {
  CHECK(
      read_any_path("100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2 0\n3 0 1\n").path ==
      read_any_path(R"({"phrame": "curve/1", "control_points": [[0,0,0],[1,2,0],[3,0,1]]})").path);
  CHECK(read_any_path("100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n0 0 1\n2 4 2\n3 0 1\n").path ==
        read_any_path(R"({"phrame": "curve/1",
            "control_points": [[0,0,0],[1,2,0],[3,0,0]], "weights": [1,2,1]})")
            .path);
}

TEST_CASE("G2: what is no curve is refused by its place") {
  CHECK(refusal("100 1 0 0\n3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2 0\n3 0\n") ==
        "8:1: a number is expected, not the end");
  CHECK(refusal("100 1 0 0\n4 0\n") == "2:1: the dimension: 4 is not from 2 to 3");
  CHECK(refusal("100 1 0 0\n2 1\n2 2\n0 0 1 1\n0 0 1\n1 1 0\n") == "6:5: the weight 0 is not > 0");
  CHECK(refusal("100 1 0 0\n2 0\n2 2\n0 1 0 1\n0 0\n1 1\n").starts_with("1:1: "));
  CHECK(refusal("100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 0\n1 1\n100 1 0 0\n")
            .starts_with("7:1: one curve is wanted: the end is expected"));
}

}  // namespace g2_file_test
