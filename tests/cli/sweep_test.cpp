#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

TEST_CASE("sweep: the ending chooses the format, and a line on stderr says what is there") {
  const Workshop here;
  const Run run = here.run("sweep quintic.json --profile rectangle:1/5,1/10 -o body.stl");
  check_success(run);
  CHECK(contains(run.out, " sections, within "));
  CHECK(run.out.ends_with(" of the surface, proved\n"));
  const std::string stl = bytes_of(here.file("body.stl"));
  CHECK((stl.size() - 84) % 50 == 0);
  CHECK(here.run("sweep quintic.json --profile circle:1/10 -o body.glb").status == 0);
  CHECK(bytes_of(here.file("body.glb")).starts_with("glTF"));
  CHECK(here.run("sweep quintic.json --profile circle:1/10 --format ply").out.starts_with("ply\n"));
  const Run obj = here.run("sweep line.json --profile rectangle:2,2 --sections 2");
  check_success(obj);
  CHECK(obj.out.starts_with("# at the start the least rotation that takes the x axis to e1"));
  CHECK(contains(obj.out, " f2\nv 0 1 1\nv 0 -1 1\n"));
  CHECK(here.run("sweep line.json --profile rectangle:2,2 --sections 2 -o box.obj").out ==
        "8 points, 12 triangles, 2 sections\n");
  const Run folded = here.run("sweep quintic.json --profile circle:9 --sections 9 -o folded.obj");
  CHECK(folded.status == 0);
  CHECK(contains(folded.err, "folds over itself"));
}

TEST_CASE("sweep: normals have a tolerance of their own, profiles too") {
  const Workshop here;
  const Run round =
      here.run("sweep quintic.json --profile circle:1/10 --normal-tolerance 1/50 -o pipe.obj");
  check_success(round);
  const std::string words = " of the surface, its normals within ";
  const std::size_t at = round.out.find(words);
  REQUIRE(at != std::string::npos);
  CHECK(round.out.ends_with(" rad, proved\n"));
  CHECK(std::stod(round.out.substr(at + words.size())) <= 0.02);
  // A profile that turns must be nearer to its circle than one that does not.
  for (const std::string more : {"--twist 360deg", "--scale 1+t", "--twist -90deg --scale 2-t"})
    CHECK(here.run("sweep line.json --profile circle:1/2 --normal-tolerance 15deg -o p.obj " + more)
              .status == 0);
  const std::string pipe = "sweep quintic.json --profile circle:1/10 --normal-tolerance ";
  check_failure(here.run(pipe + "90deg"), 2, "--normal-tolerance: \"90deg\" is not between");
  check_failure(here.run(pipe + "0"), 2, "--normal-tolerance: ");
  check_failure(here.run(pipe + "1deg --sections 7"), 2, "--normal-tolerance");
  check_failure(here.run(pipe + "1deg --exact --end-normal 0,0,1"), 2, "--normal-tolerance");
  check_failure(here.run(pipe + "1e-9"), 2, "10000");
  for (const std::string options : {"", " -o body.glb"})  // whose floats do not tell so much
    check_failure(
        here.run("sweep quintic.json --profile circle:9 --normal-tolerance 9deg" + options), 4,
        "folds over itself");
}

TEST_CASE("sweep: profiles come from files, starts and ends from options") {
  const Workshop here;
  here.write("l.csv", "x,y\n0,0\n2,0\n2,1\n1,1\n1,2\n0,2\n");
  here.write("d.svg", R"(<svg><path d="M 0 0 L 1 0 C 1 1 0 1 0 0 Z"/></svg>)");
  CHECK(here.run("sweep line.json --profile l.csv -o l.obj").status == 0);
  CHECK(here.run("sweep quintic.json --profile d.svg --tolerance 0.01 -o d.obj").status == 0);
  const auto first = [&](const std::string& options) {
    const Run run = here.run("sweep line.json --profile l.csv --sections 3 " + options);
    CHECK(run.status == 0);
    return run.out;
  };
  CHECK(contains(first("--start-normal 0,0,1"), "v 0 0 2\n"));
  CHECK(contains(first("--theta0 90deg"), "v 0 "));
  CHECK(first("--twist 90deg") != first(""));
  CHECK(contains(first("--scale 1+t"), "v 1 4 0\n"));
  CHECK(contains(first("--start-normal 0,0,1"), "v 1 0 2\n"));
}

TEST_CASE("sweep: outlines within another are holes") {
  const Workshop here;
  here.write("frame.svg", R"(<svg><path d="M 0 0 H 3 V 3 H 0 Z M 1 1 H 2 V 2 H 1 Z"/></svg>)");
  here.write("frame.csv", "0,0\n3,0\n3,3\n0,3\n\n1,1\n2,1\n2,2\n1,2\n");
  // 8 corners twice; 8 quadrilaterals, and 8 triangles for each cap.
  for (const std::string profile : {"frame.svg", "frame.csv"})
    CHECK(here.run("sweep line.json -o frame.ply --profile " + profile)
              .out.starts_with("16 points, 32 triangles, 2 sections, within "));
  for (const std::string profile : {"frame.svg", "frame.csv"}) {
    const Run exact = here.run("sweep line.json --exact --format json --profile " + profile);
    check_success(exact);
    CHECK(Json::parse(exact.out)["rings"] == Json({0, 4}));
    CHECK(Json::parse(exact.out)["patches"].size() == 8);
  }
  here.write("two.csv", "0,0\n3,0\n3,3\n\n5,1\n6,1\n6,2\n");
  check_failure(here.run("sweep line.json --profile two.csv"), 2, "two bodies");
}

TEST_CASE("sweep: the exact surface is written as fractions, or as free-form OBJ") {
  const Workshop here;
  here.write("d.svg", R"(<svg><path d="M 0 0 L 1 0 C 1 1 0 1 0 0 Z"/></svg>)");
  here.write("plane.json", bytes_of(root("/examples/curves/plane-cubic.json")));
  const Run run = here.run("sweep plane.json --exact --profile circle:1/2 -o body.json");
  check_success(run);
  CHECK(run.out == "4 rational Bezier patches, exact\n");
  const Json surface = Json::parse(bytes_of(here.file("body.json")));
  CHECK(surface["phrame"] == "surface/1");
  CHECK(surface["frame"] == "rotation-minimizing");
  CHECK(surface["patches"].size() == 4);
  CHECK(surface["patches"][0]["weights"][0] == Json({"1", "1", "2"}));
  const Run obj = here.run("sweep line.json --exact --profile rectangle:2,2");
  check_success(obj);
  CHECK(obj.out.starts_with("cstype rat bezier\nv 0 1 1 1\nv 0 -1 1 1\nv 1 1 1 1\n"));
  const Run outline = here.run("sweep plane.json --exact --profile d.svg --format json");
  check_success(outline);
  CHECK(Json::parse(outline.out)["sides"] == 2);
  CHECK(Json::parse(outline.out)["patches"][0]["degree_u"] == 3);
  const Json twisted = Json::parse(
      here.run("sweep quintic.json --exact --end-normal 0,0,1 --profile circle:1 --format json")
          .out);
  CHECK(twisted["frame"] == "minimal twist");
  CHECK(twisted["twist_degree"] == 2);
}

// What Open CASCADE reads in it is for tests/step.
TEST_CASE("sweep: the exact surface as a solid in STEP, or what that needs") {
  const Workshop here;
  here.write("plane.json", bytes_of(root("/examples/curves/plane-cubic.json")));
  const Run run = here.run("sweep plane.json --exact --profile circle:1/2 -o body.step");
  if (run.status == 0) {
    const std::string bytes = bytes_of(here.file("body.step"));
    CHECK(bytes.starts_with("ISO-10303-21;"));
    CHECK(contains(bytes, "MANIFOLD_SOLID_BREP"));
    CHECK(here.run("sweep plane.json --exact --profile circle:1/2 --format step")
              .out.starts_with("ISO-10303-21;"));
  } else {
    check_failure(run, 2, "--format: \"step\" needs Open CASCADE");
  }
  check_failure(here.run("sweep plane.json --profile circle:1/2 -o body.step"), 2,
                "\"step\" is not one of obj, stl, ply, glb");
}

TEST_CASE("sweep: what has no exact surface is refused, with what helps") {
  const Workshop here;
  here.write("plane.json", bytes_of(root("/examples/curves/plane-cubic.json")));
  const std::string exact = " --exact --profile circle:1/10 ";
  const auto refused = [&](const std::string& curve, const std::string& options, int status,
                           const std::string& reason) {
    check_failure(here.run("sweep " + curve + exact + options), status, reason);
  };
  refused("quintic.json", "", 3, "residues");
  refused("quintic.json", "", 3, "--end-normal X,Y,Z takes");
  refused("quintic.json", "", 3, "construct --kind rmf");
  refused("plane.json", "--twist 90deg", 2, "--twist: a turn that is even per length");
  refused("plane.json", "--theta0 45deg", 3, "sine and cosine are not rational");
  refused("plane.json", "--degree 3", 2, "--degree: ");
  refused("plane.json", "-o body.stl", 2, "--format: \"stl\" is not one of obj, json, step");
  refused("plane.json", "--scale t", 2, "--scale: the scale is 0 at t = 0");
  here.write("slanted.svg", R"(<svg><path d="M0 0 l1 1"/></svg>)");
  refused("slanted.svg", "", 3, "a rational function times sqrt(2)");
  refused("slanted.svg", "", 3, "; --near 1.0e-30 takes lines and arcs so near");
  const Run near = here.run("sweep slanted.svg --near 1e-20 -o pipe.obj" + exact);
  CHECK(near.out == "4 rational Bezier patches, exact\n");
  CHECK(contains(near.err, "lines and arcs with rational tangents are taken, within "));
  // Standard input is read once, whichever way it is read.
  here.write("near.json", R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 0, 0],
                              [2, "1/3", 0], [3, 1, 0]]})");
  CHECK(here.run("sweep - --near 1 -o p.obj" + exact + " < near.json").status == 0);
  here.write("corner.svg", R"(<svg><path d="M0 0 l1 1 v4"/></svg>)");
  const Run far = here.run("sweep corner.svg --near 1e-20 -o pipe.obj" + exact);
  CHECK(far.status == 2);
  CHECK(contains(far.err, "--near: lines and arcs that are smooth at joints"));
  here.write("cubic.svg", R"(<svg><path d="M0 0 h1 c1 0 2 1 3 3"/></svg>)");
  refused("cubic.svg", "", 3, "segment 2 is not PH: its unit tangent is no rational function");
  here.write("ring.svg", R"(<svg><circle r="2"/></svg>)");
  refused("ring.svg", "--degree 2", 2,
          "--degree: the rational frame of minimal twist needs a polynomial Pyth");
  refused("ring.svg", "--start up", 3, "no Euler-Rodrigues frame to start from");
  check_failure(here.run("sweep plane.json --profile circle:1 -o body.json"), 2,
                "--format: \"json\"");
}

TEST_CASE("sweep: what cannot be swept is refused by name") {
  const Workshop here;
  here.write("l.csv", "0,0\n2,0\n2,x\n");
  check_failure(here.run("sweep quintic.json"), 2, "--profile");
  check_failure(here.run("sweep quintic.json --profile none.csv"), 2, "No such file");
  check_failure(here.run("sweep quintic.json --profile l.csv"), 2, "--profile: l.csv:line 3");
  check_failure(here.run("sweep quintic.json --profile circle:0"), 2, "--profile: ");
  check_failure(here.run("sweep quintic.json --profile circle:1 -o body.step"), 2, "step");
  check_failure(here.run("sweep quintic.json --profile circle:1 --tolerance 0"), 2, "--tolerance");
  check_failure(here.run("sweep quintic.json --profile circle:1 --scale 2t"), 2, "--scale");
  check_failure(here.run("sweep quintic.json --profile circle:1 --scale t-1/2"), 2,
                "--scale: the scale");
  check_failure(here.run("sweep quintic.json --profile circle:1 --tolerance 1e-12"), 2, "10000");
  check_failure(here.run("sweep quintic.json --profile circle:1 --start-normal 2,2,1"), 2,
                "--start-normal");
}

TEST_CASE("sweep: the scale may be a list, or a column of the table of points") {
  const Workshop here;
  here.write("points.csv", "x,y,z,radius\n0,0,0,1\n1,0,0,2\n2,0,0,1\n");
  const std::string call = "sweep points.csv --kind polyline --profile rectangle:1,1 --format obj ";
  const Run list = here.run(call + "--scale 1,2,1");
  CHECK(list.status == 0);
  const Run column = here.run(call + "--scale-column radius");
  CHECK(column.out == list.out);
  CHECK(column.err.empty());
  CHECK(contains(list.err, "skipped is the column radius"));
  const Run missing = here.run(call + "--scale-column width");
  CHECK(missing.status == 2);
  CHECK(contains(missing.err,
                 "points.csv:line 1: there is no column \"width\", but x, y, z, radius\n"));
  const Run short_list = here.run(call + "--scale 1,2");
  CHECK(short_list.status == 2);
  CHECK(contains(short_list.err, "--scale: the scale has 2 values for 3 joints, 0 to 2"));
  for (const auto& [scale, reason] :
       std::vector<std::pair<std::string, std::string>>{{"1/(t-1)^2", "not finite at t = 1"},
                                                        {"2-t", "0 at t = 2"},
                                                        {"t-1", "negative at t = 0"}})
    CHECK(contains(here.run(call + "--scale '" + scale + "'").err,
                   "--scale: the scale is " + reason + "\n"));
}
