#include "phrame/io/read/three_scene.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace three_scene_test {

using namespace phrame;
using test::refusal;

namespace {

const std::string line = R"({"type": "LineCurve3", "v1": [0, 0, 0], "v2": [2, 0, 0]})";
const std::string cubic = R"({"type": "CubicBezierCurve3", "v0": [0, 0, 0], "v1": [1, 0, 0],
                              "v2": [2, 1, 0], "v3": [2, 2, 1]})";

std::string tube(const std::string& uuid, const std::string& curve) {
  return fmt::format(R"({{"uuid": "{}", "type": "TubeGeometry", "path": {}, "radius": 1}})", uuid,
                     curve);
}

/// With an object called "pipe" that has the geometry "a".
std::string scene(const std::string& geometries, const std::string& more = "") {
  return fmt::format(
      R"({{"metadata": {{"version": 4.6, "type": "Object", "generator": "Object3D.toJSON"}},
           "geometries": [{{"uuid": "box", "type": "BoxGeometry", "width": 1}}{}], {}
           "object": {{"uuid": "s", "type": "Scene", "children": [
             {{"uuid": "m", "type": "Mesh", "name": "pipe", "geometry": "a"}}]}}}})",
      geometries, more);
}

}  // namespace

TEST_CASE("three.js scene: its only curve is read, under the name of its object") {
  const NamedPath named = read_any_path(scene("," + tube("a", cubic)));
  CHECK(named.name == "pipe");
  CHECK(named.path == read_any_path(cubic).path);
  CHECK(named.notes ==
        std::vector<std::string>{"the curve is \"pipe\", in the coordinates of its geometry"});
  const std::string extruded = R"(, {"uuid": "e", "type": "ExtrudeGeometry", "shapes": [],
                                     "options": {"depth": 1, "extrudePath": )" +
                               cubic + "}}";
  CHECK(read_any_path(scene(extruded)).path == named.path);
  CHECK(
      read_any_path(R"({"uuid": "0", "type": "TubeBufferGeometry", "path": )" + cubic + "}").path ==
      named.path);
}

TEST_CASE("three.js scene: of several curves one is picked, by its name or uuid") {
  const std::string text = scene("," + tube("a", cubic) + "," + tube("b", line));
  CHECK(refusal(text) == "/: there are 2 curves, and --pick names one: pipe, b");
  const FileReading a{false, "a"};
  const FileReading b{false, "b"};
  const FileReading pipe{false, "pipe"};
  CHECK(read_any_path(text, {}, b).path == read_any_path(line).path);
  CHECK(read_any_path(text, {}, pipe).path == read_any_path(text, {}, a).path);
  CHECK(refusal(text, {false, "c"}) == "/: there is no curve \"c\"; there are pipe, b");
  CHECK(refusal(scene("," + tube("b", cubic) + "," + tube("b", line)), b) ==
        "/: 2 curves are called \"b\"");
}

TEST_CASE("three.js scene: one without curves is refused, and so is a choice where there is none") {
  CHECK(refusal(scene("")) ==
        "/: there is no curve in the scene: no TubeGeometry, no ExtrudeGeometry along a path, no "
        "shape");
  CHECK(refusal(cubic, {false, "b"}) ==
        "--pick: it is for files of several curves that have names, and this is one curve");
  CHECK(refusal(cubic, {true, ""}) ==
        "--skip-invalid: it is for rows of points, and this is no table");
  CHECK(refusal("x,y\n0,0\n1,1\n", {false, "b"}).ends_with("and this is a table"));
  CHECK(refusal("M0 0L1 1", {true, ""}).ends_with("and this is an SVG path"));
}

}  // namespace three_scene_test
