#include "cli/workshop.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/axis_file.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/refusal.hpp"

namespace envelope_cli_test {

using namespace phrame;
using namespace phrame::test;

namespace {

/// 4 by 2, from its lower left corner.
const char* const rectangle = R"({"phrame": "mph/1", "name": "rectangle", "segments": [
    {"control_points": [[0, 0, 0], [1, 1, 1]]}, {"control_points": [[0, 2, 0], [1, 1, 1]]},
    {"control_points": [[1, 1, 1], [3, 1, 1]]}, {"control_points": [[3, 1, 1], [4, 0, 0]]},
    {"control_points": [[3, 1, 1], [4, 2, 0]]}]})";

std::string refusal(const std::string& file) {
  return refusal_of<InputError>([&] { read_axis(file); });
}

}  // namespace

TEST_CASE("envelope: the boundary of a rectangle is its sides, from corner to corner") {
  const Workshop here;
  here.write("axis.json", rectangle);
  const Run json = here.run("envelope axis.json --trim --print json");
  check_success(json);
  const Json answer = Json::parse(json.out);
  CHECK(answer["undecided"].empty());
  REQUIRE(answer["branches"].size() == 1);
  CHECK(answer["branches"][0]["closed"] == true);
  CHECK(answer["segments"].size() == 5);
  for (const Json& part : answer["branches"][0]["parts"]) CHECK(part["on"] != "arc");
  check_success(here.run("envelope axis.json --trim -o box.json"));
  const NamedPath back = read_any_path(bytes_of(here.file("box.json")));
  CHECK(back.name == "rectangle");
  CHECK(back.path.corners().size() == 3);  // and one where it closes
  Rational area;
  for (const Segment& segment : back.path.segments()) {
    const Curve& curve = *ph_curve(segment);
    const Vector<Rational> a = curve.start();
    const Vector<Rational> b = evaluate(position(curve), 1);
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  CHECK(area == 8);
  check_success(here.run("envelope axis.json --trim -o box.svg"));
  CHECK(contains(bytes_of(here.file("box.svg")), "<path id=\"envelope-1\""));
  check_success(here.run("envelope axis.json --trim -o box.nc --tol 1/10"));
  std::string sides = bytes_of(here.file("box.nc"));
  sides.erase(0, sides.find("N1 "));
  // Corners, and the feet of the branch points (1, 1) and (3, 1) of the axis.
  CHECK(sides ==
        "N1 G90\nN2 G0 X0.00 Y0.00\nN3 G1 X1.00 Y0.00\nN4 G1 X3.00 Y0.00\nN5 G1 X4.00 Y0.00\n"
        "N6 G1 X4.00 Y1.00\nN7 G1 X4.00 Y2.00\nN8 G1 X3.00 Y2.00\nN9 G1 X1.00 Y2.00\n"
        "N10 G1 X0.00 Y2.00\nN11 G1 X0.00 Y1.00\nN12 G1 X0.00 Y0.00\nN13 M30\n%\n");
  check_success(here.run("envelope axis.json --trim -o box.html"));
  const std::string page = bytes_of(here.file("box.html"));
  CHECK(contains(page, "<title>rectangle</title>"));
  CHECK(contains(page, "class=\"offset layer-0\""));
  CHECK(contains(page, "<td>joint</td>"));
  check_success(here.run("envelope axis.json -o all.dxf"));
  CHECK(contains(bytes_of(here.file("all.dxf")), "\nenvelope-5\n"));
}

TEST_CASE("envelope: control points, coefficients and a preimage are one curve") {
  // x′ = 4 − 1 + … of u = 2, v = p = t, q = 1: (3, 2t, 2t), from (0, 0, 1).
  const std::string start = R"({"phrame": "mph/1", )";
  const NamedAxis axis = read_axis(start + R"("basis": "power", "start": [0, 0, 1],
      "preimage": {"u": [2], "v": [0, 1], "p": [0, 1], "q": [1]}})");
  for (const char* same : {R"("control_points": [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]})",
                           R"("basis": "power", "x": [0, 3], "y": [0, 0, 1], "r": [1, 0, 1]})"})
    CHECK(position(read_axis(start + same).segments[0]) == position(axis.segments[0]));
  CHECK(position(axis.segments[0]) ==
        Vector<Polynomial>{Polynomial{0, 3}, Polynomial{0, 0, 1}, Polynomial{1, 0, 1}});
  const NamedAxis two = read_axis(start + R"("segments": [
      {"control_points": [[0, 0, 1], [5, 0, 4]]},
      {"basis": "power", "preimage": {"u": [2], "v": [0, 1], "p": [0, 1], "q": [1]}}]})");
  CHECK(two.segments[1].start == Vector<Rational>{5, 0, 4});
}

TEST_CASE("envelope: bad files are refused in one line, with the place") {
  CHECK(refusal(R"({"phrame": "curve/1"})") == "/phrame: the format is \"mph/1\", not \"curve/1\"");
  CHECK(refusal(R"({"phrame": "mph/1", "control_points": [[0, 0, 1], [1, 1, 1], [2, 0, 1]]})") ==
        "/: this is no Minkowski PH curve: x'^2 + y'^2 - r'^2 is no square: it is 2*(2*t^2 - 2*t + "
        "1) times "
        "a square");
  CHECK(
      refusal(R"({"phrame": "mph/1", "segments": [{"control_points": [[0, 0, 1], [3, 4, 6]]}]})") ==
      "/segments/0: x'^2 + y'^2 - r'^2 is 0: each disc touches the "
      "next ones from inside, and there is no envelope");
  CHECK(refusal(R"({"phrame": "mph/1", "basis": "power", "x": [1], "y": [2], "r": [3]})") ==
        "/: all discs are one, so that there is no curve");
  CHECK(refusal(R"({"phrame": "mph/1", "segments": []})") ==
        "/segments: there is at least one segment");
  CHECK(
      refusal(
          R"({"phrame": "mph/1", "basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})") ==
      "/: the key \"start\" is missing");
  const Workshop here;
  here.write("axis.json", R"({"phrame": "mph/1", "control_points": [[0, 0, 2], [5, 0, -1]]})");
  const Run run = here.run("envelope axis.json --trim -o never.json");
  CHECK(run.status == 3);
  CHECK(run.err == "phrame: envelope: the radius is -1 at t = 1 in segment 1\n");
  CHECK(!fs::exists(here.file("never.json")));
}

}  // namespace envelope_cli_test
