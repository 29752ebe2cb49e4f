#include "phrame/io/read/godot_file.hpp"

#include <doctest/doctest.h>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace godot_file_test {

using namespace phrame;
using test::refusal;

namespace {

std::string resource(const std::string& points, const std::string& more = "") {
  return "[gd_resource type=\"Curve3D\" format=3]\n\n[resource]\n" + more +
         "_data = {\n\"points\": PackedVector3Array(" + points + "),\n" +
         "\"tilts\": PackedFloat32Array(0, 0)\n}\npoint_count = 2\n";
}

const std::string sub =
    "[sub_resource type=\"Curve3D\" id=\"Curve3D_1\"]\n_data = {\"points\": "
    "PackedVector3Array(0, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 3, 1, 0)}\n\n";
const std::string other =
    "[sub_resource type=\"Curve3D\" id=\"Curve3D_2\"]\nresource_name = \"rail\"\n_data = "
    "{\"points\": PackedVector3Array(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0)}\n\n";

}  // namespace

// The second piece has the control points (5, 6, 12), (9, 5, 15), (12, 3, 15), (12, 3, 20); by
// hand.
TEST_CASE("Godot: a Curve3D is the Bézier curves between its points") {
  const NamedPath named = read_any_path(test::read_data("curve3d.tres"));
  REQUIRE(named.path.segments().size() == 2);
  CHECK(point(*rational_curve(named.path.segments()[0]), 1) == Vector<Rational>{5, 6, 12});
  CHECK(point(*rational_curve(named.path.segments()[1]), Rational(1, 2)) ==
        Vector<Rational>{10, Rational(33, 8), Rational(61, 4)});
  CHECK(named.notes == std::vector<std::string>{"the tilts are left out"});
}

TEST_CASE("Godot: without handles a piece is a line, and a closed curve comes back") {
  const NamedPath line =
      read_any_path(resource("0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2"));
  CHECK(line.path.is_ph());
  CHECK(line.notes.empty());
  const std::string half = "0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1, 0, 0";
  CHECK(read_any_path(resource(half, "closed = true\n")).path.segments().size() == 2);
  CHECK(read_any_path(resource(half)).path.segments().size() == 1);
}

TEST_CASE("Godot: of the curves in a scene one is picked, by its name or id") {
  const std::string scene = "[gd_scene load_steps=3 format=3]\n\n" + sub + other +
                            "[node name=\"Path3D\" type=\"Path3D\"]\ncurve = "
                            "SubResource(\"Curve3D_1\")\n";
  CHECK(refusal(scene) == "there are 2 curves, and --pick names one: Curve3D_1, rail");
  CHECK(read_any_path(scene, {}, {false, "rail"}).path == read_any_path("M0 0L1 2").path);
  CHECK(read_any_path(scene, {}, {false, "Curve3D_1"}).name.empty());
  CHECK_FALSE(read_any_path("[gd_scene format=3]\n\n" + sub).path.is_ph());
}

TEST_CASE("Godot: what is wrong is told with line and column") {
  CHECK(refusal("[gd_scene format=3]\n") == "1:1: there is no Curve3D and no Curve2D in the file");
  CHECK(refusal(resource("0, 0, 0")) ==
        "5:29: 3 numbers are no triples of vectors: in, out, position");
  CHECK(refusal(resource("0, 0, 0, 0, 0, 0, 0, 0, 0")) ==
        "5:29: 1 point; a curve needs two at least");
  CHECK(refusal(resource("0, nan")).starts_with("5:"));
  CHECK(refusal("[gd_resource type=\"Curve3D\"]\n[resource]\n") ==
        "2:10: the curve has no \"points\"");
  CHECK(refusal(resource("0"), {true, ""}).ends_with("and this is a Bézier curve of Godot"));
}

}  // namespace godot_file_test
