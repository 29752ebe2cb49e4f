#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

// Example 1 of Farouki and Moon, with the angle at the end that its results need.
TEST_CASE("mtf: twist and angles of an example of the paper") {
  const Workshop here;
  here.write("example.json", R"({"phrame": "curve/1", "basis": "bernstein", "quaternions": [
      [-0.9515, 0.9515, 0.3941, -0.3941], [-0.2085, 1.4435, -0.2981, 1.0472],
      [1.2294, 0.6264, 1.3768, -0.0915]]})");
  const Run run =
      here.run("mtf example.json --from pi/8 --to -pi/2 --at 1/2 --digits 20 --print json");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["phrame"] == "mtf/1");
  CHECK(answer["length"] == "2796746489/1500000000");
  CHECK(answer["twist"]["erf"]["value"] == "-2.4067125535993797160");
  CHECK(answer["twist"]["total"]["value"] == "-4.3702079620930004900");
  CHECK(answer["twist"]["minimal"]["value"] == "1.9129773450865859869");
  CHECK(answer["mean_rate"]["value"] == "1.0260014731102354770");
  // θ − θ_i = 2.391898772922595071…
  const Rational theta = rational(answer["exact"]["values"][0]["theta"]);
  const Rational start = rational(answer["from"]["value"]);
  CHECK(abs(theta - start - parse_rational("2.391898772922595071493908")) < power_of_ten(-18));
  CHECK(contains(here.run("mtf example.json --from 0 --to 0 --turns -3").out, "\n  twist T"));
}

TEST_CASE("mtf: by vectors, and closing up") {
  const Workshop here;
  // r′(0) = (4, 4, 2); by the frames at 0 and 1, e2 itself is at angle 0.
  std::istringstream table(here.run("frames quintic.json --frame erf --at 0,1 --format csv").out);
  std::string header;
  std::string options = "mtf quintic.json --print json";
  std::getline(table, header);
  CHECK(header == "t,x,y,z,e1x,e1y,e1z,e2x,e2y,e2z,e3x,e3y,e3z");
  for (const char* option : {" --from-vector ", " --to-vector "}) {
    std::string line;
    std::getline(table, line);
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    options += option + fields.at(7) + "," + fields.at(8) + "," + fields.at(9);
  }
  const Run straight = here.run(options);
  check_success(straight);
  for (const char* end : {"from", "to"})  // the table has doubles
    CHECK(abs(rational(Json::parse(straight.out)[end]["value"])) < power_of_ten(-15));
  here.write("closed.json", bytes_of(PHRAME_TEST_DATA "/../../examples/curves/closed-spline.json"));
  const Run closed = here.run("mtf closed.json --from 1/3 --closed --digits 15 --print json");
  check_success(closed);
  // The twist that undoes the holonomy, 1.13263544456406872 by an ODE solver (docs/splines.md).
  CHECK(Json::parse(closed.out)["twist"]["minimal"]["value"] == "-1.13263544456407");
}

TEST_CASE("mtf: where f < 0 the report says what e1 is") {
  const Workshop here;
  here.write("back.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [-1],
                              "preimage": {"u": [1], "v": [0, 1], "p": [0, 2], "q": [0]}})");
  const Run run = here.run("mtf back.json --from 0 --to 1");
  check_success(run);
  CHECK(contains(run.out, "f < 0 on [0, 1]: there e₁ = A i A*/σ is −r′/|r′|"));
}

TEST_CASE("mtf: bad input is refused with its place") {
  const Workshop here;
  check_failure(here.run("mtf quintic.json --from 0"), 2, "--to: the angle is missing");
  check_failure(here.run("mtf quintic.json --from 0 --to 1 --to-vector 1,0,0"), 2,
                "--to: the angle is given twice");
  check_failure(here.run("mtf quintic.json --from pie --to 1"), 2,
                "--from: \"pie\" is not an angle");
  check_failure(here.run("mtf quintic.json --from 0 --to-vector 1,2"), 2,
                "--to-vector: \"1,2\" is not a vector x,y,z");
  check_failure(here.run("mtf quintic.json --from-vector 2,2,1 --to 0"), 2,
                "--from-vector: the vector (2, 2, 1) has no part in the normal plane");
  check_failure(here.run("mtf quintic.json --from 0 --closed"), 3,
                "--closed: the curve is not closed");
}
