#include "phrame/io/read/curve_file.hpp"
#include "workshop.hpp"

using namespace phrame;
using test::check_failure;
using test::check_success;
using test::contains;
using test::Json;
using test::Run;
using test::Workshop;

// The quintic of 2003 has e₁ = (2, 2, 1)/3, e₂ = (−2, 1, 2)/3, e₃ = (1, −2, 2)/3 at t = 0. Hence
// (1, 2, −3) is at the angle atan2(−3, −2) to e₂, (0, 0, 1) at atan2(2, 2).

TEST_CASE("start: angle tells where a given normal makes it start") {
  const Workshop here;
  const Run run = here.run("angle quintic.json --start-normal 1,2,-3 --at 0,1 --digits 30");
  check_success(run);
  CHECK(contains(run.out, "θ(0) = atan2(−3, −2)\n"));
  CHECK(contains(run.out, "f₂(0) is along (1, 2, −3), projected to the normal plane\n"));
  // By mpmath: atan2(-3, -2), and θ(1) of the paper, to 50 digits, more.
  CHECK(contains(run.out, "−2.15879893034246417047693277226\n"));
  CHECK(contains(run.out, "−1.87294240024412310847527650946\n"));
  const Run json = here.run("angle quintic.json --start-normal 1,2,-3 --print json");
  CHECK(Json::parse(json.out)["theta0"] == "atan2(-3, -2)");
  CHECK(Json::parse(json.out)["start_normal"] == Json{"1", "2", "-3"});
  CHECK(contains(here.run("angle quintic.json --start-normal 1,2,-3 --print latex").out,
                 "\\theta(0) &= \\operatorname{atan2}(-3, -2)\n"));
  // A special angle is named, and is the same start as that angle.
  Json special =
      Json::parse(here.run("angle quintic.json --start-normal 0,0,0.1 --at 1 --print json").out);
  CHECK(special["theta0"] == "pi/4");
  CHECK(special.erase("start_normal") == 1);
  CHECK(special ==
        Json::parse(here.run("angle quintic.json --theta0 45deg --at 1 --print json").out));
  // By hand, r″ = (−20, −8, 20) at 0; n is along its part across the tangent.
  CHECK(Json::parse(here.run("angle quintic.json --frame frenet --start-normal=-20,-8,20 "
                             "--print json")
                        .out)["theta0"] == "0");
}

TEST_CASE("start: frames start there, and check compares with them") {
  const Workshop here;
  const Run at_zero = here.run("frames quintic.json --start-normal 0,0,1 --at 0 --format json");
  check_success(at_zero);
  // (0, 0, 1) − (2, 2, 1)/9 = (−2, −2, 8)/9, of length √72/9: (−1, −1, 4)/√18.
  const Json row = Json::parse(at_zero.out)["rows"][0];
  CHECK(row[7] == -0.23570226039551584158669428);
  CHECK(row[8] == row[7]);
  CHECK(row[9] == 0.94280904158206336586779248);
  CHECK(here.run("frames quintic.json --samples 7 --start-normal 1,2,-3 -o other.csv").status == 0);
  CHECK(here.run("check quintic.json other.csv --start-normal 1,2,-3 --tol 1e-15").status == 0);
  const Run pass = here.run("check quintic.json other.csv --start-normal 2,4,-6");
  CHECK(contains(pass.out, "frame that starts with f2 along (2, 4, −6)\n"));
  // By mpmath, atan2(-3, -2) - pi/4.
  const Run off = here.run("check quintic.json other.csv --start-normal 0,0,1");
  CHECK(off.status == 1);
  CHECK(contains(off.out, "starts at another angle: −2.944197094 radians off\n"));
  const Json json =
      Json::parse(here.run("check quintic.json other.csv --start-normal 0,0,1 --print json").out);
  CHECK(json["start_normal"] == Json{"0", "0", "1"});
  CHECK(Json::parse(here.run("check quintic.json other.csv --start erf --theta0 pi/4 --print json")
                        .out)["theta0"] == "pi/4");
  CHECK_FALSE(
      Json::parse(here.run("check quintic.json other.csv --print json").out).contains("theta0"));
  // One sample is enough, and one that is elsewhere is said to be.
  CHECK(here.run("frames quintic.json --at 1/2 --theta0 1 -o one.csv").status == 0);
  check_success(here.run("check quintic.json one.csv --theta0 1"));
  CHECK(contains(here.run("check quintic.json one.csv --start-normal 1,0,0").out,
                 "the frame does not start where it is to start: it is "));
}

TEST_CASE("start: compiled headers say it") {
  const Workshop here;
  const Run run = here.run("compile quintic.json --start-normal 1,2,-3");
  check_success(run);
  CHECK(contains(run.out,
                 " *   f2 = cos(theta) e2 + sin(theta) e3, theta(0) = atan2(-3, -2).\n"
                 " *   f2(0) is along (1, 2, -3), projected to the normal plane.\n"
                 " *   Its error is at most "));
}

TEST_CASE("start: what has no direction, is given twice or does not apply is refused") {
  const Workshop here;
  here.write("one.csv", "t,f2x,f2y,f2z\n0,0,1,0\n1,0,1,0\n");
  for (const std::string command : {"angle quintic.json", "frames quintic.json --at 0",
                                    "compile quintic.json", "check quintic.json one.csv"}) {
    CAPTURE(command);
    check_failure(here.run(command + " --start-normal 0,0,0"), 2,
                  "--start-normal: the vector (0, 0, 0) has no part in the normal plane");
    check_failure(
        here.run(command + " --start-normal=-1,-1,-1/2"), 2,
        "--start-normal: the vector (-1, -1, -1/2) has no part in the normal plane: it is "
        "along the tangent");
    check_failure(here.run(command + " --start-normal 1,2"), 2,
                  "--start-normal: \"1,2\" is not a vector x,y,z");
    check_failure(here.run(command + " --start-normal 1,2,y"), 2,
                  "--start-normal: \"y\" is not a number");
    check_failure(here.run(command + " --start-normal 1,0,0 --theta0 0"), 2,
                  "--start-normal: does not apply with --theta0");
  }
  check_failure(here.run("frames quintic.json --at 0 --frame erf --theta0 1"), 2,
                "--theta0: needs --frame rmf");
  check_failure(here.run("angle quintic.json --print sympy --start-normal 1,0,0"), 2,
                "--start-normal: does not apply with --print sympy");
  check_failure(here.run("angle line.json --frame frenet --start-normal 0,1,0"), 3,
                "straight line");
}

TEST_CASE("start: of a batch, for all lines or in one") {
  const Workshop here;
  std::string curve = test::bytes_of(here.file("quintic.json"));
  here.write("lines.jsonl", R"({"id": 1, "curve": )" + curve + R"(}
{"id": 2, "start_normal": ["0", 0, "1/3"], "curve": )" +
                                curve + R"(}
{"id": 3, "theta0": "1/3", "curve": )" +
                                curve + "}\n" + curve + "\n");
  const auto starts = [&](const std::string& options) {
    const Run run = here.run("batch lines.jsonl --at 0 " + options);
    check_success(run);
    std::vector<std::string> found;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);)
      found.push_back(Json::parse(line)["theta0"].get<std::string>());
    return found;
  };
  using Texts = std::vector<std::string>;
  CHECK(starts("") == Texts{"0", "pi/4", "1/3", "0"});
  CHECK(starts("--start-normal 1,2,-3") == Texts{"atan2(-3, -2)", "pi/4", "1/3", "atan2(-3, -2)"});
  CHECK(starts("--theta0 60deg") == Texts{"pi/3", "pi/4", "1/3", "pi/3"});
  const Json answer = Json::parse(here.run("angle quintic.json --start-normal 0,0,1/3 --at 0 "
                                           "--print json")
                                      .out);
  std::istringstream lines(here.run("batch lines.jsonl --at 0").out);
  std::string second;
  for (int k = 0; k < 2; ++k) std::getline(lines, second);
  Json found = Json::parse(second);
  CHECK(found.erase("id") == 1);
  CHECK(found == answer);
}
