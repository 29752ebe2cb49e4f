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
  CHECK(script.find("(0, (1, 2, 3), (1, 0, 0, 0)),\n    (0.5, (4, 5, 6), (0, 0.6, 0, 0.8)),\n]") !=
        std::string::npos);
}
