// What is no PH curve, in all commands that answer it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

// Closed, its curvature jumps where it closes.
const std::string loop = R"({"phrame": "curve/1", "name": "loop",
    "control_points": [[0,0,0], [3,1,2], [2,4,-3], [-2,1,4], [-3,-1,-2], [0,0,0]]})";

}  // namespace

// The parabola x = 4t, y = 4t(1 − t).
TEST_CASE("info: the box around a curve, and where it is nearest to a point") {
  const Workshop here;
  here.write("parabola.json",
             R"({"phrame": "curve/1", "control_points": [[0,0,0], [2,2,0], [4,0,0]]})");
  const Run text = here.run("info parabola.json --box --nearest 2,3,0 --digits 5");
  check_success(text);
  CHECK(contains(text.out, "y from"));
  CHECK(contains(text.out, "0 to 1"));
  CHECK(contains(text.out, "nearest point at t     0.50000"));
  const auto json =
      Json::parse(here.run("info parabola.json --box --nearest 2,3,0 --print json").out);
  CHECK(json["box"]["x"][1]["value"] == "4.0000000000000000");
  CHECK(json["box"]["y"][1]["value"] == "1.0000000000000000");
  CHECK(json["nearest"]["t"]["value"] == "0.50000000000000000");
  CHECK(json["nearest"]["distance"]["value"] == "2.0000000000000000");
  check_failure(here.run("info parabola.json --nearest 1,2"), 2,
                "--nearest: \"1,2\" is not a vector x,y,z");
}

// The values are those of tests/answer/any_path_test.cpp.
// w = (1 + i)(1 + it): of 1 + it, a = 1/3 with the focus i/3, times (1 + i)² = 2i.
TEST_CASE("info and totals: a plane curve by complex numbers") {
  const Workshop here;
  here.write("turn.json",
             R"({"phrame": "curve/1", "basis": "power", "complex": [[1, 1], [-1, 1]]})");
  const Json info = Json::parse(here.run("info turn.json --print json").out);
  CHECK(info["complex"]["root"] == Json{{"re", {"1", "-1"}}, {"im", {"1", "1"}}});
  CHECK(info["tschirnhausen"]["scale"] == "2/3");
  CHECK(info["tschirnhausen"]["focus"] == Json{"-2/3", "0", "0"});
  CHECK(info["tschirnhausen"]["axis"] == Json{"-1", "0", "0"});
  CHECK(info["curvature_places"].empty());
  const Json totals = Json::parse(here.run("totals turn.json --print json").out);
  CHECK(totals["signed_rotation_index"]["exact"] == "1/4");
  here.write("s.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [-1, 2], "y": [-1, 6, -12, 8]}})");
  CHECK(contains(here.run("info s.json --digits 5").out, "0 at t = 1/2, an inflection"));
  CHECK(Json::parse(here.run("totals s.json --print json").out)["signed_rotation_index"]["exact"] ==
        "0");
}

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

// Gauss's integral of the constructed spline by the formula for polygons with 1100 and 2200 sides
// [Klenin, Langowski 2000] in numpy: 0.0022376 and 0.0022393, extrapolated 0.0022399.
TEST_CASE("any curve: a closed C2 PH spline has a writhe and a self-linking number") {
  const Workshop here;
  here.write("ring.csv",
             "x,y,z\n10.0,1.0,0.4\n4.1,9.1,1.5\n-5.8,8.1,-1.9\n-10.0,-1.0,0.4\n"
             "-4.1,-9.1,1.5\n5.8,-8.1,-1.9\n");
  check_success(here.run("construct ring.csv --kind c2 --closed -o ring.json"));
  const auto totals = Json::parse(here.run("totals ring.json --digits 5 --print json").out);
  CHECK(std::stod(totals["writhe"]["value"].get<std::string>()) ==
        doctest::Approx(0.0022399).epsilon(1e-4));
  CHECK(totals["self_linking"]["value"] == "0");
  CHECK(totals["self_linking"]["radius"] == "0");
}

TEST_CASE("any curve: points at equal times") {
  const Workshop here;
  here.write("loop.json", loop);
  const Run run = here.run("interpolate loop.json --period 1 --feed 2");
  check_success(run);
  CHECK(contains(run.out, "\n1,1,0.173894744280928,2,1.4727009538360893,"));
  // e − 1 at time 1.
  CHECK(contains(here.run("interpolate loop.json --period 1 --feed '1 + s'").out,
                 "\n1,1,0.1364853451495639,1.7182818284590453,"));
  check_failure(here.run("interpolate loop.json --period 1 --feed '5 - s'"), 3,
                "feedrate: the speed is 0 at s = 5");
  check_failure(here.run("interpolate loop.json --period 1 --feed kappa"), 3, "in one plane");
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

// The twist is that of tests/ph/twist/minimal_twist_test.cpp.
TEST_CASE("any curve: frames of minimal twist, the exact ones") {
  const Workshop here;
  here.write("loop.json", loop);
  const std::string ends = " --up 5,-9,11 --from 1/4 --to 3";
  const Run text = here.run("mtf loop.json --digits 12 --at 1/2" + ends);
  check_success(text);
  CHECK(contains(text.out, "The minimal twist frame is the frame of v = (5, −9, 11) turned by θ"));
  CHECK(contains(text.out, "\n  length S                         ≈ 8.24952510079\n"));
  CHECK(contains(text.out, "\nNo rational frame: the curve is not Pythagorean-hodograph\n"));
  here.write("arc.json",
             R"({"phrame": "curve/1", "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]],
                             "weights": [1, 1, 2]})");
  REQUIRE(here.run("transform arc.json --whole-line -o circle.json").status == 0);
  CHECK(contains(here.run("mtf circle.json --closed").out,
                 "\nNo rational frame: it is of polynomial Pythagorean-hodograph curves"));
  const auto json = Json::parse(
      here.run("mtf loop.json --digits 12 --at 1/2 --exact-only --print json" + ends).out);
  CHECK(json["phrame"] == "mtf/1");
  CHECK(json["up"] == Json::array({"5", "-9", "11"}));
  CHECK(json["twist"]["up"]["value"] == "-1.34752349495");
  CHECK(json["length"]["value"] == "8.24952510079");
  CHECK_FALSE(json.contains("no_rational"));
  CHECK(contains(here.run("mtf loop.json --print latex" + ends).out,
                 "frame of $v = \\left(5, -9, 11\\right)$ turned by $\\theta$"));
  // Closed, it ends as it starts.
  CHECK(here.run("frames loop.json --frame mtf-exact --from 1/4 --closed --samples 2 -o t.csv")
            .status == 0);
  std::istringstream table(bytes_of(here.file("t.csv")));
  std::string header, first, last;
  std::getline(table, header);
  std::getline(table, first);
  std::getline(table, last);
  CHECK(
      header.ends_with(",exact_mtf2x,exact_mtf2y,exact_mtf2z,exact_mtf3x,exact_mtf3y,exact_mtf3z"));
  CHECK(first.substr(1) == last.substr(1));
  check_failure(here.run("mtf loop.json --degree 2" + ends), 2, "--degree: is of rational frames");
  check_failure(here.run("mtf loop.json --from 0 --to-vector 3,1,2"), 2, "--to-vector: ");
  const auto least = Json::parse(here.run("mtf loop.json --print json").out);
  CHECK(least["start"] == "least rotation");
  // Closed, both ends have the same tangent, and so the same frame.
  CHECK(least["from"] == least["to"]);
  check_failure(here.run("mtf loop.json --from 0 --to 1 --up 0,0,0"), 2, "--up: ");
  check_failure(here.run("mtf loop.json --wronskian"), 2, "this is no PH curve");
  check_failure(here.run("frames loop.json --frame mtf --from 0 --to 0 --at 0"), 2,
                "--frame: \"mtf\" needs a Pythagorean-hodograph");
}

// Its direction (1, 1, 0) has no rational length, so that PH curves are but near it.
TEST_CASE("any curve: of a straight line no PH curve is spoken of") {
  const Workshop here;
  here.write("line.json",
             R"({"phrame": "curve/1", "control_points": [[0,0,0], [1,1,0], [3,3,0]]})");
  const Run run = here.run("info line.json");
  check_success(run);
  CHECK(contains(run.out, "any frame that does not turn is right"));
}

// A PH curve has the frame of a vector, too: what depends on the curve alone is the same by both.
TEST_CASE("any curve: PH curves have the frame of v, as curves of any kind") {
  const Workshop here;
  const auto rows = [&](const std::string& command) {
    const Run run = here.run(command + " --format json");
    check_success(run);
    return Json::parse(run.out)["rows"];
  };
  const std::string samples = " --samples 5";
  const Json plain = rows("frames quintic.json --frame rmf,erf,frenet" + samples);
  const Json both = rows("frames quintic.json --frame rmf,erf,frenet,up --up 3,-3,2" + samples);
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(Json(std::vector<Json>(both[k].begin(), both[k].begin() + 25)) == plain[k]);
  // At the start e₁ = (2, 2, 1)/3: v × e₁ = (−7, 1, 12)/3.
  CHECK(both[0][25].get<double>() * 12 == doctest::Approx(both[0][27].get<double>() * -7));
  const auto theta = [&](const std::string& options) {
    const Run run = here.run("angle quintic.json --at 1 --print json --start least " + options);
    check_success(run);
    return Json::parse(run.out);
  };
  // Each to its frame: the frame itself is one, so that the angles differ by that of the two.
  const Json up = theta("--up 3,-3,2");
  const Json erf = theta("");
  const auto angle_of = [](const Json& x) {
    return std::stod(x["values"][0]["theta"].get<std::string>());
  };
  const auto f2 = [&](const Json& row, std::size_t first, double angle, std::size_t axis) {
    return std::cos(angle) * row[first + axis].get<double>() +
           std::sin(angle) * row[first + 3 + axis].get<double>();
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CHECK(f2(both[4], 13, angle_of(erf), axis) == doctest::Approx(both[4][7 + axis].get<double>()));
    CHECK(f2(both[4], 25, angle_of(up), axis) == doctest::Approx(both[4][7 + axis].get<double>()));
  }
  const std::string closed = here.run("angle quintic.json --frame up").out;
  CHECK(contains(closed, "θ′ = −2h/σ + Im(g′/g) = "));
  CHECK(contains(closed, "Checked: the derivative of this θ is θ′, exactly."));
  check_success(here.run("mtf quintic.json --from 0 --to 1 --up 0,0,1"));
  check_success(here.run("compile quintic.json --frame up"));
  check_success(here.run(
      "interpolate quintic.json --period 1 --feed 1 --format gcode --start up --up 0,0,1"));
}

// Its ends are at angles to the Euler–Rodrigues frame, of which it is a turn, as by itself.
TEST_CASE("any curve: the rational frame of minimal twist is tabulated beside that of v") {
  const Workshop here;
  const auto rows = [&](const std::string& frames) {
    const Run run = here.run("frames quintic.json --samples 4 --format json --frame " + frames);
    check_success(run);
    return Json::parse(run.out)["rows"];
  };
  const Json all = rows("up,mtf,mtf-exact --up 0,1,2 --from 1 --to pi/8");
  const Json up = rows("up --up 0,1,2");
  const Json twist = rows("mtf,mtf-exact --from 1 --to pi/8");
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t k = 0; k < 25; ++k) {
      CAPTURE(k);
      CHECK(all[row][k] == (k < 13 ? up[row][k] : twist[row][k - 6]));
    }
}

TEST_CASE("any curve: in a path of several kinds PH segments keep their Euler-Rodrigues frame") {
  const Workshop here;
  here.write("mixed.json", R"({"phrame": "spline/1", "segments": [
      {"preimage": {"u": [1], "v": [0, 1], "p": [0, 2], "q": [0]}, "basis": "power"},
      {"control_points": [[0, "4/3", -2], [-1, "10/3", -4], [-2, 4, -5], [-2, 4, -7]]}]})");
  const Run info = here.run("info mixed.json");
  check_success(info);
  const Run frames = here.run("frames mixed.json --frame rmf,erf --skip-undefined --samples 5");
  CHECK(frames.status == 0);
  CHECK(contains(frames.err, "segment 2 is no Pythagorean-hodograph curve"));
  check_failure(here.run("frames mixed.json --frame erf --samples 5"), 3, "segment 2 is no");
}

// The second ring crosses the disc that the first one goes around once, at 0, downwards.
TEST_CASE("any curve: two rings are linked once, by both orders, and not with one far away") {
  const Workshop here;
  const auto ring = [](const std::string& x, const std::string& y, const std::string& z) {
    return R"json({"phrame": "curve/1", "from": 0, "to": "2*pi", "expressions": {"x": ")json" + x +
           R"json(", "y": ")json" + y + R"json(", "z": ")json" + z + "\"}}";
  };
  here.write("a.json", ring("cos(s)", "sin(s)", "0"));
  here.write("b.json", ring("1 + cos(s)", "0", "sin(s)"));
  here.write("c.json", ring("9 + cos(s)", "0", "sin(s)"));
  here.write("open.json",
             R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 0, 0], [1, 1, 1]]})");
  const auto linking = [&](const std::string& files) {
    const Run run = here.run("totals " + files + " --print json");
    check_success(run);
    return Json::parse(run.out)["linking"];
  };
  CHECK(linking("a.json --linked-with b.json")["exact"] == "-1");
  CHECK(linking("b.json --linked-with a.json")["exact"] == "-1");
  CHECK(linking("a.json --linked-with c.json")["exact"] == "0");
  CHECK(linking("a.json --linked-with open.json")["reason"] ==
        "linking number: the second curve is not closed");
  CHECK(
      linking("a.json --linked-with a.json")["reason"].get<std::string>().starts_with("undecided"));
}
