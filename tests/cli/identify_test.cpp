#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// r′ = (1 − t², 2t, 0) from r(0) = (1, 0, 0): A = 1 + t·k.
constexpr auto bezier = R"({"phrame": "curve/1", "name": "cubic",
    "control_points": [[1, 0, 0], ["4/3", 0, 0], ["5/3", "1/3", 0], ["5/3", 1, 0]]})";
constexpr auto parabola = R"({"phrame": "curve/1", "name": "parabola",
    "control_points": [[0, 0, 0], [0.5, 0, 0], [1, 1, 0]]})";

}  // namespace

TEST_CASE("identify: a Bézier curve gives its preimage, in text and JSON") {
  const Workshop here;
  here.write("bezier.json", bezier);
  const Run text = here.run("identify bezier.json");
  check_success(text);
  CHECK(text.out.starts_with("cubic: PH cubic, degree 3 (preimage of degree 1)\n"));
  CHECK(contains(text.out, "Checked"));
  const Run json = here.run("identify bezier.json --print json");
  check_success(json);
  const Json answer = Json::parse(json.out);
  CHECK(answer["ph"] == true);
  CHECK(answer["preimage"]["u"] == Json{"1"});
  CHECK(answer["preimage"]["q"] == Json{"0", "1"});
  CHECK(answer["start"] == Json{"1", "0", "0"});
}

TEST_CASE("identify: --print curve makes a file that the other commands read as the same curve") {
  const Workshop here;
  here.write("bezier.json", bezier);
  CHECK(here.run("identify bezier.json --print curve -o ph.json").status == 0);
  check_success(here.run("info ph.json"));
  CHECK(here.run("info ph.json").out == here.run("info bezier.json").out);
  CHECK(here.run("angle ph.json --at 1").out == here.run("angle bezier.json --at 1").out);
  const Run again = here.run("identify - --print curve", bytes_of(here.file("ph.json")));
  check_success(again);
  CHECK(again.out == bytes_of(here.file("ph.json")));
}

TEST_CASE("identify: the preimage of least degree is found for any curve file") {
  const Workshop here;
  // A = (t + 2i)(1 + t·k)… from the right: α and β have t + 2i in common.
  here.write("common.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [-1],
      "hopf": {"alpha": [[0, 2], [1, 0]], "beta": [[0, 0], [0, 2], [1, 0]]}})");
  const Run run = here.run("identify common.json --print json");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["multiplier"] == Json{"4", "0", "1"});  // |t + 2i|²
  // f = −1 turns A i A* around: of A·j = (1 + t·k)·j = −t·i + j, times i on the right.
  CHECK(answer["preimage"]["u"] == Json{"0", "1"});
  CHECK(answer["preimage"]["v"] == Json::array());
  CHECK(answer["preimage"]["p"] == Json::array());
  CHECK(answer["preimage"]["q"] == Json{"-1"});
  check_success(here.run("identify quintic.json"));
  check_success(here.run("identify line.json"));
}

TEST_CASE("identify: a curve that is not PH has status 1 and a reason") {
  const Workshop here;
  here.write("parabola.json", parabola);
  const Run text = here.run("identify parabola.json");
  CHECK(text.status == 1);
  CHECK(text.err.empty());
  CHECK(contains(text.out, "parabola: not a PH curve"));
  CHECK(contains(text.out, "4t² + 1"));
  const Run json = here.run("identify parabola.json --print json -o answer.json");
  CHECK(json.status == 1);
  CHECK(json.out.empty());
  CHECK(Json::parse(bytes_of(here.file("answer.json")))["ph"] == false);
  check_failure(here.run("identify parabola.json --print curve -o ph.json"), 1,
                "no PH curve: |r'| is no polynomial: |r'|^2 has the factor 4*t^2 + 1");
  CHECK_FALSE(fs::exists(here.file("ph.json")));
  // To the other commands it is bad input.
  check_failure(here.run("angle parabola.json"), 2,
                "phrame: parabola.json:/control_points: this is no PH curve");
}

TEST_CASE("identify: bad files and options are refused") {
  const Workshop here;
  here.write("bezier.json", bezier);
  check_failure(here.run("identify bezier.json --print maple"), 2, "--print: \"maple\" is not one");
  check_failure(here.run("identify bezier.json --max-degree 2"), 2,
                "bezier.json:/control_points: 4 points make a degree beyond the limit 2");
  check_failure(here.run("identify missing.json"), 2, "missing.json: cannot be read");
  here.write("point.json", R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [0, 0, 0]]})");
  check_failure(here.run("identify point.json"), 2, "single point");
}
