#include "phrame/io/write/camera.hpp"

#include "io/reference.hpp"
#include "phrame/io/write/bytes.hpp"

using namespace phrame;

// Section 10 of RFC 4648.
TEST_CASE("camera files: base 64") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xFB\xFF\xFE") == "+//+");
}

TEST_CASE("camera files: keys in Blender have w first") {
  const CameraPath path{{0, 0.5}, {{1, 2, 3}, {4, 5, 6}}, {{0, 0, 0, 1}, {0.6, 0, 0.8, 0}}};
  const std::string script = to_blender(path, 12.5);
  CHECK(script.find("FPS = 12.5\n") != std::string::npos);
  CHECK(script.find("at the start") == std::string::npos);
  CHECK(script.find("(0, (1, 2, 3), (1, 0, 0, 0)),\n    (0.5, (4, 5, 6), (0, 0.6, 0, 0.8)),\n]") !=
        std::string::npos);
}

TEST_CASE("camera files: where the frame starts is said") {
  CameraPath path{{0, 1}, {{1, 2, 3}, {4, 5, 6}}, {{0, 0, 0, 1}, {0, 0, 0, 1}}};
  const auto check = [&](const FrameStart& start, const std::string& words) {
    path.start = start;
    CHECK(to_blender(path, 24).find("\n# " + words + "\nimport") != std::string::npos);
    CHECK(to_gltf(path).find(R"("generator":"phrame","extras":{"start":")" + words + "\"}}") !=
          std::string::npos);
  };
  check(LeastRotation(),
        "at the start the least rotation that takes the x axis to e1 takes the y "
        "axis to f2");
  check(LeastRotation{Angle(Rational(1, 4), 0)},
        "at the start the least rotation that takes the x axis to e1 takes the y axis to f2, which "
        "is then turned about e1 by pi/4");
  check(StartNormal({0, 0, Rational(1, 2)}),
        "f2 at the start is along [0, 0, 1/2], projected to the normal plane");
  check(Angle(1), "f2 at the start is at the angle 1 to e2 of the Euler-Rodrigues frame");
  path.up = Vector<Rational>{1, 2, 3};
  check(Angle(1), "f2 at the start is at the angle 1 to e2 of the frame of v = [1, 2, 3]");
}
