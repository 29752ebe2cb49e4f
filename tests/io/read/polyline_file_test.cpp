#include "phrame/io/read/polyline_file.hpp"

#include <doctest/doctest.h>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace polyline_file_test {

using namespace phrame;
using test::refusal;

namespace {

const std::string vertices = "v 0 0 0\nv 10.5 2.25 1\nv 20 0.5 4.75\nv 31 -3.5 5.5\n";
const std::string table = "x,y,z\n0,0,0\n10.5,2.25,1\n20,0.5,4.75\n31,-3.5,5.5\n";

std::string ply(const std::string& more, const std::string& end = "") {
  return "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float z\nproperty "
         "float "
         "x\nproperty double y\n" +
         more + "end_header\n0 0 0\n1 10.5 2.25\n4.75 20 0.5\n5.5 31 -3.5\n" + end;
}

const std::string edge = "element edge 3\nproperty int vertex1\nproperty int vertex2\n";

}  // namespace

TEST_CASE("polyline: of OBJ the joined vertices are the points of a spline") {
  const Path wanted = read_any_path(table).path;
  const NamedPath named = read_any_path(test::read_data("polyline.obj"));
  CHECK(named.path == wanted);
  CHECK(named.name == "rail");
  CHECK(named.notes ==
        std::vector<std::string>{"the curve is the natural cubic spline through the points"});
  // Edge by edge, in any order and direction, and counted from the end.
  CHECK(read_any_path(vertices + "l 1 2\nl 4 3\nl 2 3\n").path == wanted);
  CHECK(read_any_path("# by hand\n" + vertices + "l -4/1 -3/2 -2 -1\r\n").path == wanted);
}

TEST_CASE("polyline: a loop has a periodic spline") {
  const NamedPath loop = read_any_path(vertices + "l 1 2 3 4 1\n");
  CHECK(loop.path.is_closed());
  CHECK(loop.path == read_any_path("# kind: periodic\n" + table).path);
  CHECK(loop.notes ==
        std::vector<std::string>{"the curve is the periodic cubic spline through the points"});
}

TEST_CASE("polyline: of several one is picked, by the name of its object") {
  const std::string text = vertices + "o left\nl 1 2\no right\nl 3 4\n";
  CHECK(refusal(text) == "there are 2 curves, and --pick names one: left, right");
  CHECK(read_any_path(text, {}, {false, "right"}).path ==
        read_any_path("20 0.5 4.75\n31 -3.5 5.5\n").path);
  CHECK(read_any_path(text, {}, {false, "#1"}).name == "left");
  CHECK(refusal(vertices + "o left\nl 1 2\no right\nl 2 3\n") ==
        "there are 2 curves, and --pick names one: left, right");
  CHECK(refusal(vertices + "o a\nl 1 2\nl 3 4\n") ==
        "there are 2 curves, and --pick names one: a#1, a#2");
}

TEST_CASE("polyline: of PLY the edges, or else all vertices, are the points") {
  const Path wanted = read_any_path(table).path;
  CHECK(read_any_path(test::read_data("polyline.ply")).path == wanted);
  CHECK(read_any_path(ply("")).path == wanted);
  CHECK(read_any_path(ply(edge, "1 2\n0 1\n2 3\n")).path == wanted);
  CHECK(refusal(ply("element face 1\nproperty list uchar int vertex_indices\n", "3 0 1 2\n")) ==
        "line 1: there is no polyline in the file: an element \"edge\" is wanted");
  CHECK(refusal(ply(edge, "1 2\n")) == "line 16: the file ends at edge 1 of 3");
  CHECK(refusal(ply(edge, "1 2\n0 1\n2 4\n")) == "line 18: there is no vertex 4");
  CHECK(refusal("ply\nformat binary_little_endian 1.0\n") ==
        "line 2: the format is binary: save it as ASCII");
  CHECK(refusal("ply\nformat ascii 1.0\n") == "line 2: the header has no end");
  CHECK(refusal("ply\nelement vertex 1\nproperty float x\nend_header\n1\n") ==
        "line 5: the element vertex has no property y");
}

TEST_CASE("polyline: what is wrong is told with its line") {
  CHECK(refusal(vertices) == "line 1: there is no polyline in the file: elements \"l\" are wanted");
  CHECK(refusal(vertices + "l 1 5\n") == "line 5: there is no vertex 5 of 4");
  CHECK(refusal(vertices + "l 1 x\n") == "line 5: \"x\" is not a whole number");
  CHECK(refusal("v 0 0\nv 1 2 3\nl 1 2\n") == "line 1: a vertex has three coordinates");
  CHECK(refusal("v 0 0 nan\n").starts_with("line 1: \"nan\" is not a number"));
  CHECK(refusal(vertices + "l 1 2\nl 2 3\nl 2 4\n") ==
        "line 7: three lines meet in vertex 2: this is no curve");
  const std::string twice = "v 0 0 0\nv 0 0 0\nv 1 2 3\nl 1 2 3\n";
  CHECK(refusal(twice).starts_with("line 2: the point (0, 0, 0) is that before it"));
  CHECK(read_any_path(twice, {}, {true, ""}).path.segments().size() == 1);
}

}  // namespace polyline_file_test
