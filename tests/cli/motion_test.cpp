#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// A plane cubic, r′ = (1 − t², 2t, 0), κ = 2/(1 + t²)², and a line on which f changes sign.
void add_curves(const Workshop& here) {
  here.write("plane.json", R"({"phrame": "curve/1", "basis": "power",
                               "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 1]}})");
  here.write("turning.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [-1, 2],
                                 "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})");
}

std::string line(const std::string& text, long number) {
  std::istringstream lines(text);
  std::string result;
  for (long k = 0; k <= number; ++k) std::getline(lines, result);
  return result;
}

/// Of a row of numbers.
std::vector<std::string> fields(const std::string& row) {
  std::vector<std::string> found;
  std::istringstream numbers(row);
  for (std::string number; std::getline(numbers, number, ',');) found.push_back(number);
  return found;
}

}  // namespace

// t at s = 71/30 by mpmath, as in the tests of ArcLength: 0.46768000073524704372747…, in the
// shortest digits of its double
TEST_CASE("frames: --by arc-length: equal steps along the curve, or the lengths given") {
  const Workshop here;
  const Run run = here.run("frames quintic.json --by arc-length --samples 3 --columns s");
  check_success(run);
  CHECK(line(run.out, 0) == "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z,s");
  CHECK(line(run.out, 1).starts_with("0,0,0,0,"));
  CHECK(line(run.out, 2).starts_with("0.46768000073524707,0.24309850894116092,"));
  CHECK(line(run.out, 2).ends_with(",2.3666666666666667"));
  CHECK(line(run.out, 3).starts_with("1,0.06666666666666667,"));
  const Run one = here.run("frames quintic.json --by arc-length --at 71/30 --columns s");
  CHECK(line(one.out, 1) == line(run.out, 2));
  // 71/15, rounded up, is the same double: the end.
  CHECK(
      line(here.run("frames quintic.json --by arc-length --at 4.7333333333333334 --columns s").out,
           1) == line(run.out, 3));
  // The same point at its rounded t is not quite the same.
  CHECK(line(here.run("frames quintic.json --by t --samples 2").out, 1) ==
        line(here.run("frames quintic.json --samples 2").out, 1));
}

// An arc length that was asked for is known, also where it is half way between two doubles, here
// 1 + 2^-53, and t is irrational; the fewest and so many rows go different ways.
TEST_CASE("frames: --by arc-length: the column s is the number asked for") {
  const Workshop here;
  here.write("bent.json",
             R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [2, 1, 0], [3, 3, 1]]})");
  const Run run =
      here.run("frames bent.json --by arc-length --at 9007199254740993/9007199254740992");
  check_success(run);
  CHECK(line(run.out, 1).ends_with(",1"));
  const std::string some = here.run("frames bent.json --by arc-length --samples 3").out;
  const std::string many = here.run("frames bent.json --by arc-length --samples 1001").out;
  CHECK(line(some, 2) == line(many, 501));
  CHECK(line(some, 3) == line(many, 1001));
}

TEST_CASE("frames: --columns: curvature, torsion and the rate of the Frenet frame") {
  const Workshop here;
  const Run run =
      here.run("frames quintic.json --frame erf --at 0 --columns curvature,torsion,frenet_rate");
  check_success(run);
  CHECK(line(run.out, 0).ends_with(",e3z,curvature,torsion,frenet_rate"));
  // √720/36, −1/45 and √(720/1296 + 1/2025)
  CHECK(line(run.out, 1).ends_with(",0.7453559924999299,-0.022222222222222223,0.745687188247223"));
  const Json json = Json::parse(
      here.run("frames quintic.json --at 1 --columns s --columns torsion --format json").out);
  CHECK(json["columns"].back() == "torsion");
  CHECK(json["rows"][0].size() == 15);
}

// As e₁ = (2, 2, 1)/3 and e₂ = (−2, 1, 2)/3 at t = 0: A = 2 + i + k, of the length √6.
TEST_CASE("frames: --columns: quaternions and matrices") {
  const Workshop here;
  const Run run = here.run("frames quintic.json --frame erf --at 0 --columns matrix,quaternion,s");
  check_success(run);
  CHECK(contains(line(run.out, 0), ",e3z,erf_qx,erf_qy,erf_qz,erf_qw,erf_m11,erf_m12,"));
  CHECK(line(run.out, 0).ends_with(",erf_m43,erf_m44,s"));
  CHECK(contains(line(run.out, 1), ",0.408248290463863,0,0.408248290463863,0.816496580927726,"));
  CHECK(line(run.out, 1).ends_with(",0,0,0,1,0"));
  // What check reads are the vectors.
  here.write("frames.csv",
             here.run("frames quintic.json --samples 5 --columns quaternion,matrix").out);
  CHECK(here.run("check quintic.json frames.csv").status == 0);
}

// s goes from 0 to π/4: s = 1/2 is t = 2/π, and x = cos(1/2).
TEST_CASE("--by native: t of angle, mtf and frames is the parameter of the file") {
  const Workshop here;
  const std::string arc =
      R"json({"phrame": "curve/1", "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "0.3*s"}, )json"
      R"("from": 0, "to": "pi/4"})";
  here.write("arc.json", arc);
  const Run angle = here.run("angle arc.json --by native --at 0.5 --print json --values-only");
  check_success(angle);
  CHECK(contains(angle.out, "\"by\": \"native\""));
  CHECK(contains(angle.out, "\"native\": \"1/2\""));
  CHECK(contains(angle.out, "\"value\": \"0.63661977236758134\""));
  CHECK(contains(here.run("mtf arc.json --exact-only --by native --at 0.5").out,
                 "1/2      0.63661977236758134"));
  const Run frames = here.run("frames arc.json --by native --at 0.5");
  CHECK(line(frames.out, 0).ends_with(",f3z,native"));
  CHECK(line(frames.out, 1).starts_with("0.6366197723675814,0.8775825618903728,"));
  CHECK(line(frames.out, 1).ends_with(",0.5"));
  check_failure(here.run("angle arc.json --by native --at 1"), 3,
                "1 is outside [0, 0.785398163], what the parameter of the file goes through");
  check_failure(here.run("angle arc.json --by unit --at 1"), 2,
                "--by: \"unit\" is t itself along one segment");
  add_curves(here);
  check_failure(here.run("angle quintic.json --by native --at 1"), 2,
                "--by: the file of the path has no parameter of its own but t");
  // A batch has the same key.
  here.write("lines.jsonl",
             R"({"id": 1, "by": "native", "at": "1/2", "digits": 5, "curve": )" + arc + "}\n");
  CHECK(contains(here.run("batch lines.jsonl").out, "0.63662"));
}

// Half of the length 71/15 of the quintic is at t = 0.46768000073524707 (docs/motion.md).
TEST_CASE("--by: places of all commands are told by any parameter") {
  const Workshop here;
  add_curves(here);
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const Run parts = here.run("transform quintic.json --by fraction --split 1/2 -o halves.jsonl");
  CHECK(parts.status == 0);
  CHECK(contains(parts.err, "quintic.json: it is cut at irrational t, rounded"));
  const std::string halves = bytes_of(here.file("halves.jsonl"));
  CHECK(lines(halves) == 2);
  const Run lengths = here.run("batch halves.jsonl --question info --digits 15");
  CHECK(lines(lengths.out) == 2);
  CHECK(contains(lengths.out, "\"id\":\"quintic-1\""));
  const Run mtf = here.run("mtf quintic.json --from 0 --to 1 --subdivide 1/2 --by fraction");
  CHECK(contains(mtf.out, "  0           0.46768000  "));
  CHECK(contains(here.run("compile quintic.json --by fraction --to 1/2").out,
                 "For 0 <= t <= 0.46768000073524707;"));
  CHECK(here.run("certify quintic.json --by fraction --at 1").out ==
        here.run("certify quintic.json --at 1").out);
  check_failure(
      here.run("certify quintic.json --by arc-length --at 1"), 2,
      "--by: the t of the place 1 is irrational, and this command takes t that are fractions");
  CHECK(here.run("prove quintic.json --by fraction --at 1").out ==
        here.run("prove quintic.json --at 1").out);
  check_failure(here.run("prove quintic.json --by fraction --at 0"), 2, "--at: 0 is the start");
}

TEST_CASE("frames: --by time: rows are where a motion is at its times") {
  const Workshop here;
  add_curves(here);
  const std::string feed = " --feed '1 + s/2' ";
  const Run motion = here.run("interpolate quintic.json --period 1/2" + feed);
  const Run frames = here.run("frames quintic.json --by time --at 0,1/2,1" + feed);
  check_success(frames);
  for (long k = 0; k < 3; ++k) {  // k, time, t, s, x, y, z
    const auto points = fields(line(motion.out, k + 1));
    const auto row = fields(line(frames.out, k + 1));
    CHECK(row.front() == points[2]);
    CHECK(row[3] == points[6]);
    CHECK(row.back() == points[1]);
  }
  const Run samples = here.run("frames quintic.json --by time --samples 3" + feed);
  CHECK(line(samples.out, 3).ends_with(",2.427846270358208"));  // 2 log(1 + 71/30)
  CHECK(line(samples.out, 3).starts_with("1,"));
  check_failure(here.run("frames quintic.json --by time --at 3" + feed), 3, "3");
  check_failure(here.run("frames quintic.json --by time --at 1"), 2, "\"time\" needs --feed");
  check_failure(here.run("frames quintic.json --at 1" + feed), 2, "--feed: needs --by time");
}

TEST_CASE("frames: arc lengths and columns that make no sense are refused by name") {
  const Workshop here;
  add_curves(here);
  check_failure(here.run("frames quintic.json --by arc-length"), 2,
                "--by: needs --at, --samples or --subdivide");
  check_failure(here.run("frames quintic.json --by length --at 0"), 2,
                "--by: \"length\" is not one of t, native, unit, arc-length, fraction");
  check_failure(
      here.run("frames quintic.json --at 0 --columns speed"), 2,
      "--columns: \"speed\" is not one of s, curvature, torsion, frenet_rate, bishop, "
      "omega, signed_curvature, twist_rate, twist_omega, twist_alpha, quaternion, matrix");
  check_failure(here.run("frames quintic.json --by arc-length --at x"), 2,
                "--at: \"x\" is not a number");
  check_failure(here.run("frames quintic.json --by arc-length --at 5"), 3,
                "5 is outside [0, 71/15]");
  check_failure(here.run("frames quintic.json --by arc-length --at 5.0000000001"), 3,
                "5.0000000001 is outside [0, 71/15]");
  check_failure(here.run("frames turning.json --by arc-length --at 1"), 3, "1 is outside [0, 1/2]");
  check_failure(here.run("frames line.json --at 0 --columns torsion"), 3, "straight line");
}

// r′ = (2t − 1, 0, 0): s = t − t² up to 1/2, where the point turns back.
TEST_CASE("frames: by arc length where the multiplier changes sign") {
  const Workshop here;
  add_curves(here);
  const Run run = here.run(
      "frames turning.json --by arc-length --frame erf --at 0.1875,0.25,0.3125 --columns s");
  check_success(run);
  CHECK(line(run.out, 1) == "0.25,-0.1875,0,0,-1,0,0,0,1,0,0,0,-1,0.1875");
  CHECK(line(run.out, 2) == "0.5,-0.25,0,0,-1,0,0,0,1,0,0,0,-1,0.25");
  CHECK(line(run.out, 3) == "0.75,-0.1875,0,0,-1,0,0,0,1,0,0,0,-1,0.3125");
}

// By mpmath: t at the times 0.2 and 1 of the motion with V = 1 + 2s, and T(1) = ½ log(157/15).
TEST_CASE("interpolate: points at equal times, and the end") {
  const Workshop here;
  const Run run = here.run("interpolate quintic.json --period 0.2 --feed '1 + 2*s'");
  check_success(run);
  CHECK(line(run.out, 0) == "k,time,t,s,x,y,z");
  CHECK(line(run.out, 1) == "0,0,0,0,0,0,0");
  CHECK(line(run.out, 2).starts_with("1,0.2,0.04261324819385755,0.24591234882063515,"));
  CHECK(line(run.out, 6).starts_with("5,1,0.6439910419180356,3.194528049465325,"));
  CHECK(line(run.out, 7) ==
        "6,1.174097802123049,1,4.733333333333333,0.06666666666666667,2.533333333333333,3.4");
  CHECK(line(run.out, 8).empty());
}

// T(1) = 4/15 + π/5, t at the times 1/4 and 1/2 by mpmath.
TEST_CASE("interpolate: a speed that depends on the curvature of a plane curve") {
  const Workshop here;
  add_curves(here);
  const std::string command = "interpolate plane.json --period 1/4 --format json --feed ";
  const Json json = Json::parse(here.run(command + "'5/(1 + 2*kappa)'").out);
  CHECK(json["phrame"] == "interpolation/1");
  CHECK(json["rows"].size() == 5);
  CHECK(json["rows"][1][2] == 0.253083165528683677079537739732);
  CHECK(json["rows"][2][2] == 0.523408547735559133078429335257);
  CHECK(json["rows"][4][1] == 0.894985197384625314359195343323);
  CHECK(here.run(command + "'5/(1+2*κ)'").out == here.run(command + "'5/(1 + 2*kappa)'").out);
}

TEST_CASE("interpolate: what is typed wrongly is refused by name") {
  const Workshop here;
  const auto run = [&](const std::string& options) {
    return here.run("interpolate quintic.json " + options);
  };
  check_failure(run(""), 2, "required");
  check_failure(run("--feed 1"), 2, "--period is required");
  check_failure(run("--period 1"), 2, "--feed is required");
  check_failure(run("--period x --feed 1"), 2, "--period: \"x\" is not a number");
  check_failure(run("--period 0 --feed 1"), 2, "--period: 0 is not positive");
  check_failure(run("--period=-1/2 --feed 1"), 2, "--period: -1/2 is not positive");
  check_failure(run("--period 1e-9 --feed 1"), 2,
                "--period: 1e-9 asks for 4733333335 rows, the limit is 10000000");
  check_failure(run("--period 1 --feed '2s'"), 2, "--feed, column 2: ");
  check_failure(run("--period 1 --feed 'x'"), 2, "--feed: \"x\" is not one of s (arc length)");
  check_failure(run("--period 1 --feed '1' --format xls"), 2, "--format: \"xls\"");
  check_failure(here.run("interpolate missing.json --period 1 --feed 1"), 2, "missing.json");
}

TEST_CASE("interpolate: speeds that are no speeds have status 3 and their reason") {
  const Workshop here;
  add_curves(here);
  const auto run = [&](const std::string& curve, const std::string& feed) {
    return here.run("interpolate " + curve + ".json --period 1 --feed '" + feed + "'");
  };
  check_failure(run("quintic", "1 - 2*t"), 3, "the speed is 0 at t = 1/2");
  check_failure(run("quintic", "s"), 3, "the speed is 0 at t = 0");
  check_failure(run("quintic", "1/(t-1/3)"), 3, "the speed is infinite at t = 1/3");
  check_failure(run("quintic", "0-7"), 3, "the speed is negative");
  check_failure(run("quintic", "0"), 3, "the speed is 0");
  check_failure(run("quintic", "1/kappa"), 3, "not plane");
  check_success(run("plane", "1/kappa"));
}

// s = t − t² up to t = 1/2, and 1/2 − t + t² behind it; with V = 1 + t by mpmath.
TEST_CASE("interpolate: where the multiplier changes sign the motion goes on, back") {
  const Workshop here;
  add_curves(here);
  const Run constant = here.run("interpolate turning.json --period 0.125 --feed 3/2");
  check_success(constant);
  CHECK(line(constant.out, 2) == "1,0.125,0.25,0.1875,-0.1875,0,0");
  CHECK(line(constant.out, 3) == "2,0.25,0.8535533905932737,0.375,-0.125,0,0");
  const Run by_t = here.run("interpolate turning.json --period 0.1 --feed '1 + t'");
  check_success(by_t);
  CHECK(line(by_t.out, 4) ==
        "3,0.3,0.8825280359471294,0.3963276982855683,-0.10367230171443167,0,0");
  CHECK(line(by_t.out, 5) == "4,0.35334910696915034,1,0.5,0,0,0");
}
