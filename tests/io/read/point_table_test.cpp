#include "phrame/io/read/point_table.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/point_file.hpp"
#include "support/refusal.hpp"

namespace point_table_test {

using namespace phrame;

namespace {

using Notes = std::vector<std::string>;

const std::vector<Vector<Rational>> two{{0, 1, 2}, {Rational(3, 2), 4, 5}};

std::string refusal(const std::string& text, bool skips_invalid = false) {
  return test::refusal_of([&] { read_points(text, {skips_invalid}); });
}

GivenPoints skipped(const std::string& text) { return read_points(text, {true}); }

}  // namespace

TEST_CASE("point table: coordinates under other names are the same points, and a note says which") {
  for (const char* header : {"pos_x,pos_y,pos_z", "Position X,Position Y,Position Z", "px,py,pz",
                             "\"x_pos\",\"y_pos\",\"z_pos\"", "X [mm],Y [mm],Z [mm]"}) {
    CAPTURE(header);
    const GivenPoints given = read_points(std::string(header) + "\r\n0,1,2\r\n1.5,4,5\r\n");
    CHECK(given.points == two);
    CHECK(given.notes.size() == 1);
  }
  CHECK(read_points("pos_x;pos_y\n0;1\n1;2\n").notes ==
        Notes{"the columns pos_x, pos_y are taken for the position"});
  CHECK(read_points("x;y;px;py\n0;1;7;7\n1;2;8;8\n").notes.empty());
  CHECK(read_points("tx,ty,pos_x,pos_y\n7,7,0,1\n7,7,1,2\n").points[1] ==
        Vector<Rational>{1, 2, 0});
  CHECK(refusal("px,py,pos_x,pos_y\n0,1,0,1\n1,2,1,2\n") ==
        "line 1: columns of 2 positions have an x, \"p\" and \"pos\": which of them is the curve's "
        "is not known");
  CHECK(refusal("px,py,pX,z\n0,1,0,1\n1,2,1,2\n") == "line 1: missing is the column x");
  CHECK(refusal("px,py,PX\n0,1,0\n1,2,1\n") == "line 1: two columns have the name PX");
}

TEST_CASE("point table: coordinates have one unit, which a note names") {
  CHECK(read_points("x,y,dx,dy,t\nmm,mm,mm/s,mm/s,s\n0,1,1,1,0\n1,2,1,1,1\n").notes ==
        Notes{"the coordinates are in mm"});
  CHECK(refusal("x [mm],y [m]\n0,1\n1,2\n") ==
        "line 1: y has the unit \"m\", but by x it is to have the unit \"mm\"");
  CHECK(refusal("x [mm],y\n0,1\n1,2\n") ==
        "line 1: y has no unit, but by x it is to have the unit \"mm\"");
  CHECK(refusal("x,y,dx,dy,t\nmm,mm,m/s,m/s,s\n0,1,1,1,0\n1,2,1,1,1\n") ==
        "line 1: dx has the unit \"m/s\", but by x it is to have the unit \"mm/s\"");
}

TEST_CASE("point table: rows without numbers are refused, or left out if that is asked for") {
  for (const char* row : {",,", "NaN,NaN,NaN", "1,,2", "1,2,inf"}) {
    CAPTURE(row);
    const std::string text = "x,y,z\n0,1,2\n" + std::string(row) + "\n1.5,4,5\n";
    CHECK(refusal(text).starts_with("line 3, "));
    CHECK(refusal(text).ends_with("; --skip-invalid leaves such rows out"));
    CHECK(skipped(text).points == two);
    CHECK(skipped(text).notes == Notes{"left out is 1 row without a number, line 3"});
  }
  CHECK(refusal("x,y\n0,0\n1,1x\n2,2\n", true).starts_with("line 3, y: \"1x\" is not a number"));
  CHECK(refusal("x,y\n,\n,\n", true) == "line 2: all rows are without a number");
  CHECK(skipped("x,y,label\n0,0,\n1,1,\n").points.size() == 2);  // it is not read
}

TEST_CASE("point table: points that are those before them are left out if that is asked for") {
  const std::string text = "t,x,y\n0,0,0\n1,0,0\n2,1,1\n3,1,1\n4,2,0\n";
  CHECK(refusal(text).starts_with("line 3: the point (0, 0, 0) is that before it"));
  CHECK(refusal(text).ends_with("; --skip-invalid leaves it out"));
  CHECK(skipped(text).parameters == std::vector<Rational>{0, 2, 4});
  CHECK(skipped(text).notes ==
        Notes{"left out are 2 rows with the point before them, the first line 3"});
  CHECK(refusal("x,y\n1,1\n1,1\n", true) ==
        "line 2: there is one point; a curve needs two at least");
}

TEST_CASE("point table: a list in JSON is a table") {
  CHECK(read_points("[[0, 1, 2], [1.5, 4, 5]]").points == two);
  CHECK(read_points("\xEF\xBB\xBF [{\"y\": 1, \"x\": 0, \"z\": 2, \"id\": 7},"
                    " {\"x\": 1.5, \"y\": 4, \"z\": 5}]")
            .points == two);
  CHECK(refusal("[[0, 1, 2], [1, true, 0]]").starts_with("/1/1: a number is wanted, not true"));
  CHECK(skipped("[[0, 1, 2], [null, 1, 1], [1.5, 4, 5]]").points == two);
}

TEST_CASE("point table: poses without names have positions") {
  const GivenPoints matrices =
      read_points("0 -1 0 0 1 0 0 1 0 0 1 2\n0 -1 0 1.5 1 0 0 4 0 0 1 5\n");
  CHECK(matrices.points == two);
  CHECK(matrices.notes ==
        Notes{"12 columns without names are taken for 3 × 4 matrices, row by row"});
  const GivenPoints timed = read_points("10 0 1 2 0 0 0 1\n11 1.5 4 5 0 0.6 0 0.8\n");
  CHECK(timed.points == two);
  CHECK(timed.parameters == std::vector<Rational>{10, 11});
  CHECK(timed.skipped_columns.empty());
  CHECK(refusal("10 0 1 2 0 0 0 2\n11 1 4 5 0 0 0 1\n")
            .ends_with("8 t, x, y, z and a quaternion of length 1, which is not here"));
  CHECK(refusal("1 2 3 4 5 6 7 8 9 10 11 12\n")
            .ends_with("12 a matrix with a rotation, which is not here"));
  const GivenPoints tum =
      read_points("# timestamp tx ty tz qx qy qz qw\n10 0 1 2 0 0 0 1\n11 1.5 4 5 0 0.6 0 0.8\n");
  CHECK(tum.points == two);
  CHECK(tum.parameter_column == "timestamp");
}

}  // namespace point_table_test
