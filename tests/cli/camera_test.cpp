#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

// What is in the files is read in tests/camera.
TEST_CASE("camera paths: the ending chooses the format, others are refused") {
  const Workshop here;
  CHECK(here.run("frames quintic.json --samples 3 -o camera.glb").status == 0);
  CHECK(bytes_of(here.file("camera.glb")).starts_with("glTF"));
  CHECK(here.run("frames quintic.json --samples 3 -o camera.gltf").status == 0);
  CHECK(bytes_of(here.file("camera.gltf")).starts_with("{\"asset\""));
  CHECK(here.run("frames quintic.json --samples 3 -o camera.py --fps 25").status == 0);
  CHECK(contains(bytes_of(here.file("camera.py")), "\nFPS = 25\n"));
  for (const std::string ending : {"obj", "stl", "ply", "step", "tex", "m", "html", "blend"})
    check_failure(here.run("frames quintic.json --samples 3 -o out." + ending), 2,
                  "\"." + ending + "\" is no format of frames");
}

TEST_CASE("camera paths: what makes none is refused in a line") {
  const Workshop here;
  const auto refused = [&](const std::string& options, const std::string& reason) {
    CAPTURE(options);
    check_failure(here.run("frames quintic.json " + options), 2, reason);
  };
  refused("--at 1/2 --format glb", "frames: a camera path needs two rows");
  refused("--at 1,0 --format glb", "row 2 is not after the one before");
  refused("--at 1/2,1/2 --format gltf", "row 2 is not after the one before");
  refused("--at 0,1,1.00000000001 --format blender --duration 1e9", "as a float, that of the row");
  refused("--at 1,1e9 --format glb", "-5.99999998e+44 of row 2 does not fit a float");
  refused("--at 0,1 --format glb --duration 1e39", "1e+39 of row 2 is, as a float, infinite");
  refused("--samples 3 --format glb --duration -1", "--duration: \"-1\" is not > 0");
  refused("--samples 3 --format blender --fps 1e9", "--fps: is not between");
  refused("--samples 3 --format glb --frame rmf,erf", "--frame: a camera path has one frame");
  refused("--samples 3 --format glb --columns s", "--columns: does not apply");
}
