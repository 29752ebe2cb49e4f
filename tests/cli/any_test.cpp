// What is no PH curve, in all commands that answer it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;
using Json = nlohmann::json;

namespace {

// Closed, its curvature jumps where it closes.
const std::string loop = R"({"phrame": "curve/1", "name": "loop",
    "control_points": [[0,0,0], [3,1,2], [2,4,-3], [-2,1,4], [-3,-1,-2], [0,0,0]]})";

}  // namespace

// The values are those of tests/answer/smooth_answers_test.cpp.
TEST_CASE("any curve: info and totals, as text, JSON and LaTeX") {
  const Workshop here;
  here.write("loop.json", loop);
  const Run text = here.run("totals loop.json --digits 10");
  check_success(text);
  CHECK(text.out.starts_with("loop: polynomial curve of degree 5, closed\n\n  v = ("));
  CHECK(contains(text.out, "\n  length ∫ ds\n    ≈ 8.249525101\n"));
  CHECK(contains(text.out, "\n  holonomy\n    ≈ 1.347523495\n"));
  CHECK(contains(text.out, "\n  self-linking number: the Frenet frame is not defined"));
  const auto totals = Json::parse(here.run("totals loop.json --digits 10 --print json").out);
  CHECK(totals["phrame"] == "totals/1");
  CHECK(totals["name"] == "loop");
  CHECK(totals["torsion"]["value"] == "0.7935976973");
  CHECK(totals["closing_turn_per_length"]["value"] == "-0.1633455840");
  CHECK(totals["rotation_index"]["value"].is_null());
  CHECK(totals["rotation_index"]["reason"] == "not a plane curve");
  CHECK_FALSE(totals.contains("erf_twist"));
  CHECK(contains(here.run("totals loop.json --digits 10 --print latex").out,
                 "\\text{holonomy} &\\approx 1.347523495\n"));

  const Run info = here.run("info loop.json --digits 10");
  check_success(info);
  CHECK(contains(info.out, "  X₁                     −10t⁵ + 25t⁴ + 10t³ − 40t² + 15t\n"));
  CHECK(contains(info.out, "  length ∫ |r′|          8.249525101\n"));
  const auto json = Json::parse(here.run("info loop.json --digits 10 --print json").out);
  CHECK(json["phrame"] == "info/1");
  CHECK(json["closed"] == true);
  CHECK(json["arc_length"]["value"] == "8.249525101");
  CHECK(json["segments"].size() == 1);
  CHECK(json["plane_normal"].is_null());
  CHECK(json["numerator"][0] == Json::array({"0", "15", "-40", "10", "25", "-10"}));
  CHECK(contains(here.run("info loop.json --digits 10 --print latex").out,
                 "\\text{holonomy} &\\approx 1.347523495\n"));
}

TEST_CASE("any curve: points at equal times, at a constant speed") {
  const Workshop here;
  here.write("loop.json", loop);
  const Run run = here.run("interpolate loop.json --period 1 --feed 2");
  check_success(run);
  CHECK(contains(run.out, "\n1,1,0.173894744280928,2,1.4727009538360893,"));
  check_failure(here.run("interpolate loop.json --period 1 --feed '1 + s'"), 2,
                "--feed: a speed that is no constant needs a Pythagorean-hodograph curve");
  check_failure(here.run("interpolate loop.json --period 1 --feed 0"), 3,
                "feedrate: the speed is 0");
  check_failure(here.run("interpolate loop.json --period 1e-9 --feed 1"), 2, "--period: ");
}

TEST_CASE("any curve: batch answers as angle does") {
  const Workshop here;
  here.write("loop.json", loop);
  here.write("lines.jsonl", std::string(R"({"curve": )") + loop.substr(0, loop.size()) + "}\n");
  std::string line = bytes_of(here.file("lines.jsonl"));
  line.erase(std::remove(line.begin(), line.end() - 1, '\n'), line.end() - 1);
  here.write("lines.jsonl", line);
  const Run batch = here.run("batch lines.jsonl --at 1/3");
  check_success(batch);
  auto one = Json::parse(batch.out);
  one.erase("id");
  CHECK(one == Json::parse(here.run("angle loop.json --at 1/3 --print json").out));
}
