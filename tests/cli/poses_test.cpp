#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace poses_test {

namespace {

constexpr auto poses =
    R"({"phrame": "poses/1", "name": "three", "points": [[0, 0, 0], [1, 0, 0], [2, 1, 0]],
    "orientations": [[0, 0, 0, 1], [[1, 0, 0], [0, 0, -1], [0, 1, 0]], {"e1": [0, 1, 0], "e3": [0, 0, 1]}],
    "turns": [0, 1]})";
constexpr auto table =
    "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n1,0,0,0.5,0.5,0.5,0.5\n2,1,0,0,0,0.6,0.8\n";

/// The numbers of the rows of a table below its header.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    std::string cell;
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("poses: quaternions, matrices and axes of poses/1 are met, in the axes of the body") {
  const Workshop here;
  here.write("poses.json", poses);
  const Run run = here.run("construct poses.json -o path.json");
  check_success(run);
  CHECK(contains(run.out, "orientations    met exactly; tangent: x; between them: the least turn"));
  const Json file = Json::parse(bytes_of(here.file("path.json")));
  CHECK(file["phrame"] == "spline/1");
  CHECK(file["frame"]["through"][1] == Json({{"t", 1}, {"f2", {"0", "0", "1"}}}));
  CHECK(file["frame"]["through"][2]["turns"] == 1);
  const Run frames = here.run("frames path.json --frame mtf-exact --at 0,1,2");
  check_success(frames);
  const auto rows = rows_of(frames.out);
  CHECK(Numbers(rows[0].begin() + 4, rows[0].end()) == Numbers{1, 0, 0, 0, 1, 0, 0, 0, 1});
  CHECK(Numbers(rows[1].begin() + 4, rows[1].end()) == Numbers{1, 0, 0, 0, 0, 1, 0, -1, 0});
  CHECK(Numbers(rows[2].begin() + 4, rows[2].end()) == Numbers{0, 1, 0, -1, 0, 0, 0, 0, 1});
  const Run mtf = here.run("mtf path.json --print json --at 1/2");
  check_success(mtf);
  const Json answer = Json::parse(mtf.out);
  CHECK(answer["phrame"] == "twist-through/1");
  CHECK(answer["twist_kind"] == "even");
  CHECK(answer["legs"].size() == 2);
  CHECK(std::stod(answer["legs"][1]["twist"].get<std::string>()) > 3.1415);  // a turn more
}

TEST_CASE("poses: of a table by --tangent-axis, whose quaternions and matrices come out again") {
  const Workshop here;
  here.write("poses.csv", table);
  for (const std::string axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    CAPTURE(axis);
    CHECK(here.run("construct poses.csv --tangent-axis=" + axis + " -o path.json").status == 0);
    const Run frames =
        here.run("frames path.json --frame mtf-exact --at 0,1,2 --columns quaternion,matrix");
    check_success(frames);
    const auto rows = rows_of(frames.out);
    CHECK(Numbers(rows[0].begin() + 13, rows[0].begin() + 17) == Numbers{0, 0, 0, 1});
    CHECK(Numbers(rows[1].begin() + 13, rows[1].begin() + 17) == Numbers{0.5, 0.5, 0.5, 0.5});
    CHECK(Numbers(rows[2].begin() + 13, rows[2].begin() + 17) == Numbers{0, 0, 0.6, 0.8});
    const std::array<double, 9> matrix{0, 0, 1, 1, 0, 0, 0, 1, 0};
    for (std::size_t k = 0; k < 9; ++k) CHECK(rows[1][17 + k + k / 3] == matrix[k]);
  }
  // Without it the orientations are skipped, as they were.
  const Run plain = here.run("construct poses.csv --print curve");
  CHECK_FALSE(contains(plain.out, "\"frame\""));
  // Matrices without names, a TUM trajectory, and the other order.
  here.write("kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n0 0 1 1 1 0 0 0 0 1 0 0\n");
  CHECK(here.run("construct kitti.txt --tangent-axis z -o kitti.json").status == 0);
  here.write("tum.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0.5 0.5 0.5 0.5\n");
  CHECK(here.run("construct tum.txt --tangent-axis x -o tum.json").status == 0);
  const auto of = [&](const std::string& file) {
    return rows_of(
               here.run("frames " + file + " --frame mtf-exact --at 1 --columns quaternion").out)
        .at(0);
  };
  CHECK(of("tum.json")[13] == 0.5);
  CHECK(of("kitti.json")[16] == 0.5);
  here.write("wxyz.txt", "0 0 0 0 1 0 0 0\n1 1 0 0 0.8 0 0 0.6\n");
  CHECK(here.run("construct wxyz.txt --tangent-axis x --quaternion wxyz -o wxyz.json").status == 0);
  CHECK(of("wxyz.json")[15] == 0.6);
  CHECK(here.run("construct wxyz.txt --tangent-axis x --quaternion wxyz --inverse -o inverse.json")
            .status == 0);
  CHECK(of("inverse.json")[15] == -0.6);
}

TEST_CASE("poses: rounded matrices are said to be off, and another axis that may have been meant") {
  const Workshop here;
  here.write("rounded.txt",
             "0.866 -0.5 0 0 0.5 0.866 0 0 0 0 1 0\n0.866 -0.5 0 1 0.5 0.866 0 0.6 0 0 1 0\n");
  const Run run = here.run("construct rounded.txt --tangent-axis x --print json");
  CHECK(run.status == 0);
  const Json report = Json::parse(run.out);
  // √(0.866² + 0.5²) is 1 − 2.2e-5, about.
  CHECK(std::stod(report["orientations"]["off"].get<std::string>()) ==
        doctest::Approx(2.2e-5).epsilon(0.05));
  CHECK_FALSE(contains(run.err, "--tangent-axis"));
  CHECK(contains(here.run("construct rounded.txt --tangent-axis z").err,
                 "--tangent-axis x takes that"));
}

TEST_CASE(
    "poses: rational frames from pose to pose meet the orientations, and are near the exact one") {
  const Workshop here;
  here.write("poses.csv", table);
  check_success(here.run("construct poses.csv --tangent-axis x -o path.json"));
  const Run both = here.run("frames path.json --frame mtf,mtf-exact --degree 3 --at 0,1/2,1,3/2,2");
  check_success(both);
  const auto rows = rows_of(both.out);
  for (const std::size_t joint : {0U, 2U, 4U})
    CHECK(Numbers(rows[joint].begin() + 7, rows[joint].begin() + 13) ==
          Numbers(rows[joint].begin() + 13, rows[joint].begin() + 19));
  for (const std::size_t middle : {1U, 3U})
    for (std::size_t k = 7; k < 13; ++k)
      CHECK(std::abs(rows[middle][k] - rows[middle][k + 6]) < 0.05);
  check_success(here.run("construct poses.csv --tangent-axis x --smooth-twist -o smooth.json"));
  const Run none = here.run("frames smooth.json --frame mtf --at 0");
  CHECK(none.status == 3);
  CHECK(contains(none.err, "that of a smooth twist is not known"));
}

TEST_CASE("poses: a machine follows them with the tool along an axis of the body") {
  const Workshop here;
  // From tip to spindle z of the tool is up, then tilted by 45 degrees about x, the way.
  here.write(
      "tool.csv",
      "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n10,0,0,0.3826834323650898,0,0,0.9238795325112867\n");
  check_success(here.run("construct tool.csv --tangent-axis x -o tool.json"));
  const Run code = here.run("interpolate tool.json --feed 1 --period 5 --format gcode");
  check_success(code);
  CHECK(contains(code.out, "X0.0000 Y0.0000 Z0.0000 A0.0000"));
  CHECK(contains(code.out, "X5.0000 Y0.0000 Z0.0000 A22.5000"));
  CHECK(contains(code.out, "X10.0000 Y0.0000 Z0.0000 A45.0000"));
  CHECK(contains(here.run("frames poses.json --samples 2").err, "cannot be read"));
  here.write("poses.json", poses);
  CHECK(contains(here.run("frames poses.json --samples 2").err,
                 "phrame construct makes a curve of them"));
}

TEST_CASE("poses: a closed list gives a closed path, with a body that closes") {
  const Workshop here;
  here.write("ring.csv",
             "x,y,z,qx,qy,qz,qw\n1,0,0,0,0,1,1\n0,1,0,0,0,1,0\n-1,0,0,0,0,-1,1\n0,-1,0,0,0,0,1\n1,"
             "0,0,0,0,-2,-2\n");
  check_success(here.run(
      "construct ring.csv --tangent-axis x --closed --smooth-twist --turns 1,0,0,0 -o ring.json"));
  const Run body = here.run("sweep ring.json --profile rectangle:1/4,1/8 -o ring.stl");
  check_success(body);
  CHECK(contains(body.out, "closed by a turn of 6.28319"));
  const Run page = here.run("page ring.json -o ring.html");
  CHECK((page.status == 0 || has_no_pages(page)));
}

// Rows 2 and 5 miss a number each, one of the position, one of the orientation.
TEST_CASE("poses: points and orientations of different rows are never taken together") {
  const Workshop here;
  here.write("gaps.csv",
             "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n,0,0,0,0,1,1\n1,0,0,0,0,0,1\n"
             "2,0,0,0,0,0,1\n3,1,0,,0,0,1\n4,1,0,0,0,0,1\n");
  check_failure(here.run("construct gaps.csv --tangent-axis x --skip-invalid"), 2,
                "4 rows with orientations, but 5 points");
  here.write("both.csv",
             "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n,0,0,,0,1,1\n1,0,0,0,0,0,1\n2,0,0,0,0,0,0\n");
  check_failure(here.run("construct both.csv --tangent-axis x --skip-invalid"), 2, "line 5");
}

TEST_CASE("poses: what is none is refused with its place") {
  const Workshop here;
  const auto refused = [&](const std::string& name, const std::string& content,
                           const std::string& options, const std::string& reason) {
    here.write(name, content);
    const Run run = here.run("construct " + name + options);
    CAPTURE(run.err);
    CHECK(run.status == 2);
    CHECK(contains(run.err, reason));
  };
  const auto with = [](const std::string& orientation) {
    return R"({"phrame": "poses/1", "points": [[0, 0, 0], [1, 0, 0]], "orientations": [[0, 0, 0, 1], )" +
           orientation + "]}";
  };
  refused("a.json", with("[0, 0, 0, 0]"), "", "/orientations/1: the quaternion is 0");
  refused("b.json", with("[[1, 0, 0], [0, 1, 0], [0, 0, -1]]"), "",
          "/orientations/1: this is no rotation");
  refused("c.json", with(R"({"e1": [1, 0, 0]})"), "", "two of the axes");
  refused("d.json", with("[1, 2]"), "", "2 items here: a quaternion has 4 numbers");
  refused("e.json", with("[0, 0, 0, 1]"), " --kind c2", "takes no orientations");
  refused("i.json", with("[0, 0, 0, 1]"), " --turns 1,2",
          "--turns: 2 for 2 points; 1 is wanted, one for each segment");
  refused("f.csv", "x,y,z\n0,0,0\n1,0,0\n", " --tangent-axis x", "columns f2x, f2y, f2z or qw");
  refused("g.csv", "x,y,z\n0,0,0\n1,0,0\n", " --smooth-twist", "--tangent-axis says");
  refused("h.csv", "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0\n1,0,0,0,0,0,1\n", " --tangent-axis x",
          "line 2: the quaternion is 0");
  const auto frame = [&](const std::string& through) {
    here.write(
        "spline.json",
        R"({"phrame": "spline/1", "segments": [{"control_points": [[0, 0, 0], [1, 0, 0]]}], "frame": {"through": )" +
            through + "}}");
    const Run run = here.run("frames spline.json --frame mtf-exact --at 0");
    CHECK(run.status != 0);
    return run.err;
  };
  CHECK(contains(frame(R"([{"t": 0, "f2": [0, 0, 1]}])"), "there is none at both ends"));
  CHECK(contains(frame(R"([{"t": 0, "f2": [0, 0, 1]}, {"t": 2, "f2": [0, 0, 1]}])"),
                 "/frame/through/1/t: 2 is no joint"));
  CHECK(contains(frame(R"([{"t": 0, "f2": [1, 0, 0]}, {"t": 1, "f2": [0, 0, 1]}])"),
                 "the orientation at t = 0: the vector (1, 0, 0) has no part"));
}

TEST_CASE("roll: as a formula, a list and a column it is the same") {
  const Workshop here;
  here.write("bank.csv", "x,y,z,bank\n0,0,0,0\n1,0,0,30\n2,1,0,60\n");
  const Run formula = here.run("frames bank.csv --samples 5 --roll '30*t deg'");
  const Run list = here.run("frames bank.csv --samples 5 --roll 0,30deg,pi/3");
  const Run column = here.run("frames bank.csv --samples 5 --roll-column bank:deg");
  check_success(column);
  CHECK(column.out == list.out);
  CHECK(column.out == formula.out);
  CHECK(column.out != here.run("frames bank.csv --samples 5").out);
  const Run body =
      here.run("sweep bank.csv --roll-column bank:deg --profile rectangle:1/2,1/9 -o a.obj");
  check_success(body);
  CHECK(here.run("sweep bank.csv --roll '30*t deg' --profile rectangle:1/2,1/9 -o b.obj").status ==
        0);
  CHECK(bytes_of(here.file("a.obj")) == bytes_of(here.file("b.obj")));
  const Run few = here.run("frames bank.csv --samples 5 --roll 0,1");
  CHECK(few.status == 2);
  CHECK(contains(few.err, "--roll: the roll has 2 values for 3 joints"));
  CHECK(contains(here.run("sweep bank.csv --roll '1/(t-1)' --profile circle:1/9").err,
                 "--roll: the roll is not finite at t = 1\n"));
}

}  // namespace poses_test
