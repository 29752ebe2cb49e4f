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
  CHECK(obj.out.starts_with("v 0 1 1\nv 0 -1 1\n"));
  CHECK(here.run("sweep line.json --profile rectangle:2,2 --sections 2 -o box.obj").out ==
        "8 points, 12 triangles, 2 sections\n");
  const Run folded = here.run("sweep quintic.json --profile circle:9 --sections 9 -o folded.obj");
  CHECK(folded.status == 0);
  CHECK(contains(folded.err, "folds over itself"));
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
  check_failure(here.run("sweep quintic.json --profile circle:1 --scale t-1/2"), 3, "scale");
  check_failure(here.run("sweep quintic.json --profile circle:1 --tolerance 1e-12"), 2, "10000");
  check_failure(here.run("sweep quintic.json --profile circle:1 --start-normal 2,2,1"), 2,
                "--start-normal");
}
