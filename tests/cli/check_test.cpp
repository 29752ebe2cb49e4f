#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

TEST_CASE("check: the program's own frames pass, others are told what they are") {
  const Workshop here;
  CHECK(here.run("frames quintic.json --samples 21 -o frames.csv").status == 0);
  const Run pass = here.run("check quintic.json frames.csv --tol 1e-15");
  check_success(pass);
  CHECK(contains(pass.out, "\npass: f2 is at most "));
  const std::string table = here.run("frames quintic.json --samples 21 --frame frenet").out;
  std::string renamed = table;
  for (const auto& [from, to] : {std::pair("nx,ny,nz", "f2x,f2y,f2z"), {"bx,by,bz", "f3x,f3y,f3z"}})
    renamed.replace(renamed.find(from), 8, to);
  here.write("frenet.csv", renamed);
  const Run fail = here.run("check quintic.json frenet.csv --print json");
  CHECK(fail.status == 1);
  CHECK(fail.err.empty());
  const auto out = nlohmann::json::parse(fail.out);
  CHECK(out["phrame"] == "check/1");
  CHECK(out["verdict"] == "fail");
  CHECK(out["max_error"]["lower"] == "2.99504");
  CHECK(out["max_error"]["upper"] == "2.99505");
  CHECK(out["findings"][0]["kind"] == "frenet");
  CHECK(out["samples"].size() == 21);
  CHECK(contains(here.run("check quintic.json frenet.csv").out, "  - these are Frenet frames"));
}

// Half a circle at 0, 1/2 and 1, by hand: the axes of the body are e1, f2, f3 or, of a camera,
// which looks along its z axis, f2, f3, e1.
TEST_CASE("check: matrices are placed by their positions, and another tangent axis is found") {
  const Workshop here;
  here.write("circle.json", R"json({"phrame": "curve/1", "expressions": {"x": "cos(s)",
      "y": "sin(s)", "z": "0"}, "from": 0, "to": "pi"})json");
  here.write("poses.txt",
             "0 -1 0 1 1 0 0 0 0 0 1 0\n-1 0 0 0 0 -1 0 1 0 0 1 0\n0 1 0 -1 -1 0 0 0 0 0 1 0\n");
  const Run pass = here.run("check circle.json poses.txt");
  CHECK(pass.status == 0);
  CHECK(contains(pass.err, "12 columns without names are taken for 3 × 4 matrices, row by row"));
  CHECK(contains(pass.err, "t is taken from the positions: equal steps"));
  here.write("camera.txt",
             "-1 0 0 1 0 0 1 0 0 1 0 0\n0 0 -1 0 -1 0 0 1 0 1 0 0\n1 0 0 -1 0 0 -1 0 0 1 0 0\n");
  const Run other = here.run("check circle.json camera.txt");
  CHECK(other.status == 1);
  CHECK(contains(other.out, "It passes by another reading of the table: --tangent-axis z."));
  CHECK(here.run("check circle.json camera.txt --tangent-axis z").status == 0);
  here.write("away.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 5 0 0 1 0\n");
  check_failure(here.run("check circle.json away.txt"), 2, "a column t is wanted");
}

// What is on standard input is read as a whole.
TEST_CASE("check: of a long file the rows that decide are judged, and the report is that of all") {
  const Workshop here;
  const std::string table = here.run("frames quintic.json --samples 361").out;
  here.write("long.csv", table);
  for (const std::string options : {"", " --tol 15e-17", " --theta0 pi/7"}) {
    CAPTURE(options);
    const Run few = here.run("check quintic.json long.csv --by t" + options);
    const Run all = here.run("check quintic.json - --by t" + options, table);
    CHECK(contains(few.out, "361 frames, t from 0 to 1"));
    CHECK(few.out == all.out);
    CHECK(few.err == all.err);
    CHECK(few.status == all.status);
  }
  here.write("bad.csv", table + "1,0,0,0,1,0,0,0,zero,0,0,0,1\n");
  check_failure(here.run("check quintic.json bad.csv --by t"), 2, "bad.csv:line 363, f2y: ");
}

TEST_CASE("check: bad input is refused with its place") {
  const Workshop here;
  here.write("bad.csv", "t,f2x,f2y,f2z\n0,1,zero,0\n");
  check_failure(here.run("check quintic.json bad.csv"), 2, "bad.csv:line 2, f2y: ");
  check_failure(here.run("check quintic.json nowhere.csv"), 2, "nowhere.csv: ");
  check_failure(here.run("check quintic.json bad.csv --tol -1"), 2, "--tol: -1 is negative");
  check_failure(here.run("check quintic.json bad.csv --tangent-axis w"), 2,
                "--tangent-axis: \"w\" is not one of x, y, z, -x, -y, -z");
  check_failure(here.run("check - - < quintic.json"), 2, "check: the curve and the frames");
  here.write("names.json", R"({"phrame": "frames/1", "columns": ["t"], "rows": [[0, 1]]})");
  check_failure(here.run("check quintic.json names.json"), 2,
                "names.json:/columns: 1 name for rows of 2\n");
}

TEST_CASE("check: the program reads its own tables in every form") {
  const Workshop here;
  const std::string negative = R"({"phrame": "curve/1", "basis": "bernstein", "multiplier": [-1],
      "preimage": {"u": [2, 0, 2], "v": [1, 1, 0], "p": [0, -2, 0], "q": [1, 2, 1]}})";
  here.write("negative.json", negative);
  for (const std::string curve : {"quintic.json", "negative.json"}) {
    CAPTURE(curve);
    for (const std::string options :
         {"", " --format npy", " --format json", " --frame rmf,rmf", " --frame rmf,erf,frenet",
          " --frame rmf,erf --columns s --format npy",
          " --frame mtf,mtf-exact,rmf --from 0 --to pi/4"}) {
      CAPTURE(options);
      CHECK(here.run("frames " + curve + " --samples 6 -o table" + options).status == 0);
      const Run pass = here.run("check " + curve + " table --tol 1e-15");
      check_success(pass);
      CHECK(contains(pass.out, "at most"));
    }
  }
  CHECK(contains(here.run("check quintic.json - <table").out, "at most"));
}

// A constant rate is a drift; a start angle that is not 0 is an offset.
TEST_CASE("check: the findings name what is off, and by how much") {
  const Workshop here;
  CHECK(here.run("frames quintic.json --samples 6 -o table").status == 0);
  const Run offset = here.run("check quintic.json table --theta0 1/8 --tol 1e-9");
  CHECK(offset.status == 1);
  CHECK(contains(offset.out, "  - the frame is rotation-minimizing, to within "));
  CHECK(contains(offset.out, " but starts at another angle: −0.1250000000 radians off\n"));
  const auto json =
      nlohmann::json::parse(here.run("check quintic.json table --theta0 1/8 --print json").out);
  CHECK(json["findings"][0]["kind"] == "constant-offset");
  CHECK(json["better_reading"].is_null());
  here.write("left.csv", "t,f2x,f2y,f2z,f3x,f3y,f3z\n0,0,1,0,0,0,-0.1\n1,0,1,0,0,0,0.1\n");
  const Run left = here.run("check line.json left.csv --tol 2");
  CHECK(left.status == 1);
  CHECK(contains(left.out, "left-handed: det(tangent, f2, f3) < 0 at sample 0, t = 0\n"));
  CHECK_FALSE(contains(left.out, "= −1"));
}

TEST_CASE("check: one sample is no verdict, unless it has something to be compared with") {
  const Workshop here;
  CHECK(here.run("frames quintic.json --at 1/2 -o one").status == 0);
  check_failure(here.run("check quintic.json one"), 2, "one: all samples are at t = 1/2");
  const Run pass = here.run("check quintic.json one --theta0 0");
  check_success(pass);
  CHECK(contains(pass.out, "1 frame, t = 1/2\n"));
}

TEST_CASE("check: a t of any size is answered") {
  const Workshop here;
  here.write("huge.csv", "t,f2x,f2y,f2z\n0,0,1,0\n1e30000,1,0,0\n");
  const Run run = here.run("check quintic.json huge.csv");
  CHECK(run.status == 1);
  CHECK(run.err.empty());
  CHECK(contains(run.out, "2 frames, t from 0 to 1000000"));
  CHECK(here.run("check quintic.json huge.csv --print json").status == 1);
}

TEST_CASE("check: what is abridged is said to be so, and --full prints it") {
  const Workshop here;
  const std::string hint = "\nLong parts are abridged (--full prints it all).\n";
  const std::string t = "1" + std::string(1000, '0');
  here.write("huge.csv", "t,f2x,f2y,f2z\n0,0,1,0\n1e1000,1,0,0\n");
  const Run huge = here.run("check quintic.json huge.csv");
  CHECK(contains(huge.out, "t from 0 to 1000000"));
  CHECK_FALSE(contains(huge.out, t));
  CHECK(huge.out.ends_with(hint));
  const Run full = here.run("check quintic.json huge.csv --full");
  CHECK(contains(full.out, "t from 0 to " + t + "\n"));
  CHECK(contains(full.out, "at sample 1, t = " + t + "\n"));
  CHECK_FALSE(contains(full.out, "characters"));
  CHECK_FALSE(contains(full.out, hint));
  // Ten samples with f2 = 0, the first at a long t.
  std::string table = "t,f2x,f2y,f2z\n0,0,1,0\n";
  for (int k = 1; k <= 10; ++k) table += "1e" + std::to_string(1000 * k) + ",0,0,0\n";
  here.write("zero.csv", table);
  const Run ten = here.run("check quintic.json zero.csv");
  CHECK(contains(ten.out, " at 10 samples, the first is 1, t = 1000000"));
  CHECK(ten.out.ends_with(hint));
  CHECK(contains(here.run("check quintic.json zero.csv --full").out,
                 " at samples 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, the first at t = " + t + "\n"));
  // A tolerance and a start angle.
  here.write("line.csv", "t,f2x,f2y,f2z\n0,0,1,0\n1,0,1,0\n");
  const std::string options = " --theta0 1e-100 --tol 2e-100";
  CHECK(here.run("check line.json line.csv" + options).out.ends_with(hint));
  CHECK(contains(here.run("check line.json line.csv --full" + options).out,
                 "  tolerance        1/5" + std::string(99, '0') + "\n"));
}

// A = 1 + tk is the frame as a quaternion; the table has it in the order x, y, z, w.
TEST_CASE("check: another convention that is right is named") {
  const Workshop here;
  here.write("plane.json", R"({"phrame": "curve/1", "basis": "power",
                               "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 1]}})");
  here.write("poses.txt", "0 0 0 0 1\n0.5 0 0 0.5 1\n1 0 0 1 1\n");
  const Run fail = here.run("check plane.json poses.txt");
  CHECK(fail.status == 1);
  CHECK(contains(fail.out, "\nIt passes by another reading of the table: --quaternion xyzw.\n"));
  const auto json = nlohmann::json::parse(here.run("check plane.json poses.txt --print json").out);
  CHECK(json["better_reading"]["options"] == "--quaternion xyzw");
  CHECK(json["better_reading"]["passes"] == true);
  check_success(here.run("check plane.json poses.txt --quaternion xyzw"));
  check_success(here.run("check plane.json poses.txt --header t,qx,qy,qz,qw"));
  CHECK(here.run("frames plane.json --samples 3 -o table").status == 0);
  for (const std::string option :
       {"--quaternion xyzw", "--tangent-axis z", "--tangent-axis x", "--inverse"})
    check_failure(here.run("check plane.json table " + option), 2,
                  option.substr(0, option.find(' ')) + ": is for quaternions");
  check_failure(here.run("check plane.json poses.txt --header t,f2x,f2y,f2z"), 2,
                "--header: 4 names for 5 columns\n");
}

TEST_CASE("check: frames of a curve of any kind are judged, by angles to the frame of v") {
  const Workshop here;
  here.write("cubic.json", R"({"phrame": "curve/1", "name": "cubic",
      "control_points": [[0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 2, 3]]})");
  CHECK(
      here.run("frames cubic.json --frame rmf,up,frenet --up 0,0,1 --samples 9 -o table").status ==
      0);
  const Run pass = here.run("check cubic.json table --tol 1e-15");
  check_success(pass);
  CHECK(contains(pass.out, "cubic: 9 frames, t from 0 to 1\n\npass: f2 is at most "));
  std::string table = here.run("frames cubic.json --frame up --up 0,0,1 --samples 9").out;
  for (const auto& [from, to] :
       {std::pair("up2x,up2y,up2z", "f2x,f2y,f2z"), {"up3x,up3y,up3z", "f3x,f3y,f3z"}})
    table.replace(table.find(from), 14, to);
  here.write("up.csv", table);
  // −∫ τ ds by mpmath's quad: -1.65740642390110…; n and b are this frame at both ends.
  const Run fail = here.run("check cubic.json up.csv --start up --up 0,0,1 --print json");
  CHECK(fail.status == 1);
  CHECK(fail.err.empty());
  const auto out = nlohmann::json::parse(fail.out);
  CHECK(out["name"] == "cubic");
  CHECK(out["up"] == nlohmann::json::array({"0", "0", "1"}));
  CHECK(out["max_error"]["lower"] == "1.65740");
  CHECK(out["max_error"]["upper"] == "1.65741");
  CHECK(out["findings"][0]["kind"] == "fixed-up");
  CHECK(contains(here.run("check cubic.json table --up 0,0,1 --start up --theta0 1/8").out,
                 "that starts at the angle 1/8 to v × T, v = (0, 0, 1)\n"));
  CHECK(here.run("check cubic.json table --up 0,0,1 --start-normal 3,1,0 --tol 1e-15").status == 0);
  check_failure(here.run("check cubic.json table --up 0,0,0"), 2, "--up: the up vector is 0\n");
  check_failure(here.run("check cubic.json table --up 1,0,0"), 2,
                "--up: the up vector (1, 0, 0) is along the tangent at t = 0\n");
  check_failure(here.run("check cubic.json table --start-normal 1,0,0"), 2, "--start-normal: ");
}

// A table of quaternions of frames of the plane parabola, whose scalar is last.
TEST_CASE("check: a better reading is found for curves of any kind") {
  const Workshop here;
  here.write("parabola.json", R"({"phrame": "curve/1",
      "position": {"x": [0, 1], "y": [0, 0, 0.5]}, "basis": "power"})");
  here.write("poses.csv", "0 0 0 0 1\n1 0 0 0.41421356237309503 1\n");
  const auto json =
      nlohmann::json::parse(here.run("check parabola.json poses.csv --print json").out);
  CHECK(json["better_reading"]["options"] == "--quaternion xyzw");
  CHECK(json["better_reading"]["passes"] == true);
}

TEST_CASE("check: tangents that are off at the right places fail, whatever t may be") {
  const Workshop here;
  // Frames of t + 1/20 at the places of t, on a circle by degrees: r and the frame at 0, 1/2, 1.
  here.write("arc.json", R"json({"phrame": "curve/1", "from": 0, "to": 1,
      "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "0"}})json");
  std::string table = "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z\n";
  for (const double t : {0.0, 0.5, 1.0}) {
    const double off = t + (t == 0.5 ? 0.05 : 0);
    table += fmt::format("{},{},{},0,{},{},0,{},{},0,0,0,1\n", t, std::cos(t), std::sin(t),
                         -std::sin(off), std::cos(off), -std::cos(off), -std::sin(off));
  }
  here.write("off.csv", table);
  for (const char* by : {"", " --by t"}) {
    const Run run = here.run(std::string("check arc.json off.csv --print json") + by);
    CHECK(run.status == 1);
    CHECK(nlohmann::json::parse(run.out)["parameters"].is_null());
  }
}

// Along a straight line the exact frame stands still, so that the errors are those written here:
// step²/5.
TEST_CASE("check: the order of a method is found from its tables at several steps") {
  const Workshop here;
  fs::create_directory(here.file("mine"));
  for (const int n : {4, 8, 16}) {
    std::string table = "t,f2x,f2y,f2z\n";
    for (int k = 0; k <= n; ++k) {
      const double angle = k / 5.0 / n / n / n;
      table += fmt::format("{},0,{},{}\n", 1.0 * k / n, std::cos(angle), std::sin(angle));
    }
    here.write(fmt::format("mine/{}.csv", n), table);
  }
  const Run run = here.run("check line.json mine --order");
  check_success(run);
  CHECK(contains(run.out, "order about 2.00\n"));
  const auto json =
      nlohmann::json::parse(here.run("check line.json mine --order --print json").out);
  CHECK(json["phrame"] == "order/1");
  CHECK(json["steps"].size() == 3);
  CHECK(std::stod(json["steps"][0]["error"]["upper"].get<std::string>()) ==
        doctest::Approx(0.0125).epsilon(1e-5));
  CHECK(json["steps"][0]["rate"].is_null());
  CHECK(json["steps"][2]["rate"]["value"].get<std::string>().starts_with("2.00000"));
  CHECK(here.run("check line.json mine --order --print latex")
            .out.starts_with("\\begin{tabular}{lrrr}\n"));
  CHECK(here.run("check line.json mine --order -o order.html").status == 0);
  CHECK(std::filesystem::file_size(here.file("order.html")) ==
        here.run("check line.json mine --order --print html").out.size());
  CHECK(contains(here.run("check line.json mine --order --print html").out,
                 "<table>\n<tr><th>frames</th><th style=\"text-align:right\">step</th>"));
  check_failure(here.run("check line.json --order"), 2, "FRAMES: is required");
  check_failure(here.run("check line.json mine --suite"), 2,
                "FRAMES: does not apply with --suite\n");
  check_failure(here.run("check line.json mine/4.csv --order"), 2, "mine/4.csv: is no folder");
  check_failure(here.run("check line.json mine/4.csv --print latex"), 2,
                "--print: \"latex\" is for --suite and --order");
  check_failure(here.run("check line.json mine/4.csv --print html"), 2,
                "--print: \"html\" is for --suite and --order");
  fs::create_directory(here.file("empty"));
  check_failure(here.run("check --suite empty"), 2, "empty: no tables are in it");
  check_failure(here.run("check --suite mine"), 2, "mine/16.csv: no curve of the collection");
  const Run line = here.run("batch", R"({"question": "check", "curve": {"phrame": "curve/1", )"
                                     R"("control_points": [[0, 0, 0], [1, 0, 0]]}, )"
                                     R"("frames": "mine", "order": true})");
  CHECK(contains(line.out, "a folder has no place in a line of a batch"));
}
