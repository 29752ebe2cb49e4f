#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

// What the program says is read in tests/gcode.
TEST_CASE("G-code: endings choose it, those of other formats are refused") {
  const Workshop here;
  const std::string call = "interpolate quintic.json --feed 1 --period 1 ";
  for (const std::string ending : {"nc", "ngc", "gcode", "tap", "NC"}) {
    CHECK(here.run(call + "-o path." + ending).status == 0);
    CHECK(bytes_of(here.file("path." + ending)).starts_with("%\n("));
  }
  for (const std::string ending : {"glb", "gltf", "py", "obj", "stl", "step", "tex", "m"})
    check_failure(here.run(call + "-o out." + ending), 2,
                  "\"." + ending + "\" is no format of interpolate");
}

TEST_CASE("G-code: what makes none is refused in a line") {
  const Workshop here;
  const auto refused = [&](const std::string& options, int status, const std::string& reason) {
    CAPTURE(options);
    check_failure(here.run("interpolate quintic.json --format gcode " + options), status, reason);
  };
  refused("--feed 1 --period 1 --tool f4", 2, "--tool: \"f4\"");
  refused("--feed 1 --period 1 --places 10", 2, "--places");
  refused("--feed 1 --period 1 --tool e1 --theta0 1", 2,
          "--theta0: e1, which the tool is along, does not depend on it");
  refused("--feed 1 --period 1 --start-normal 2,2,1", 2, "--start-normal: ");
  refused("--feed 1e-9 --period 1e9 --places 2", 2,
          "--places: the feed, 1/minutes of a move, is 0");
  refused("--feed 1 --period 1e-9", 2, "--period: 1e-9 asks for 4733333335 rows");
  refused("--feed s-1 --period 1", 3, "feed");
  check_failure(here.run("interpolate quintic.json --feed 1 --period 1 --tool e1"), 2,
                "--tool: needs --format gcode");
}
