#include "phrame/io/read/gltf_file.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "io/reference.hpp"
#include "phrame/ph/curve/place.hpp"

namespace gltf_file_test {

using namespace phrame;
using test::refusal;

namespace {

/// The floats were packed by Python's struct and base64: times, then values.
std::string gltf(const std::string& data, const std::string& bytes, const std::string& split,
                 const std::string& counts, const std::string& interpolation) {
  return R"({"asset": {"version": "2.0"}, "nodes": [{"name": "camera"}], "animations": [{"name": "fly",
      "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
      "samplers": [{"input": 0, "output": 1, "interpolation": ")" +
         interpolation + R"("}]}], "accessors": [
      {"bufferView": 0, "componentType": 5126, "type": "SCALAR", "count": )" +
         counts.substr(0, 1) +
         R"(}, {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": )" +
         counts.substr(2) + R"(}], "bufferViews": [{"buffer": 0, "byteLength": )" + split +
         R"(}, {"buffer": 0, "byteOffset": )" + split + R"(}], "buffers": [{"byteLength": )" +
         bytes + R"(, "uri": "data:application/octet-stream;base64,)" + data + R"("}]})";
}

// 0.5, 1, 3; (0, 0, 0), (1, 2, 0), (3, 1, 2).
const std::string lines = "AAAAPwAAgD8AAEBAAAAAAAAAAAAAAAAAAACAPwAAAEAAAAAAAABAQAAAgD8AAABA";
// 0, 2; tangent in, place, tangent out: 0, (0, 0, 0), (1.5, 0, 0); (0, 3, 0), (3, 3, 0), 0.
const std::string cubic =
    "AAAAAAAAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAMA/"
    "AAAAAAAAAAAAAAAAAABAQAAAAAAAAEBAAABAQAAAAAAAAAAAA"
    "AAAAAAAAAA=";

}  // namespace

TEST_CASE("glTF: the way of a node by the times of its animation, by lines or cubic curves") {
  const NamedPath named = read_any_path(gltf(lines, "48", "12", "3 3", "LINEAR"));
  CHECK(named.name == "camera");
  CHECK(named.path == read_any_path(R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0,0,0],[1,2,0]]}, {"control_points": [[1,2,0],[3,1,2]]}]})")
                          .path);
  CHECK(native_place(named, 2).t.exact() == Rational(1, 2));
  CHECK(named.notes.front() ==
        "the curve is the way of \"camera\" in the coordinates of its parent");
  // Of the Hermite data the Bézier points are p, p + 2/3·m, q − 2/3·n, q.
  const NamedPath smooth = read_any_path(gltf(cubic, "80", "8", "2 6", "CUBICSPLINE"));
  CHECK(smooth.path == read_any_path(R"({"phrame": "curve/1",
      "control_points": [[0,0,0],[1,0,0],[3,1,0],[3,3,0]]})")
                           .path);
}

TEST_CASE("glTF: buffers in other files, and data that are not base64") {
  const std::string embedded = gltf(lines, "48", "12", "3 3", "LINEAR");
  const auto uri = embedded.find("data:");
  const auto with_uri = [&](const std::string& other) {
    return embedded.substr(0, uri) + other + embedded.substr(embedded.find('"', uri));
  };
  const float numbers[] = {0.5F, 1, 3, 0, 0, 0, 1, 2, 0, 3, 1, 2};
  const std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
  FileReading reading;
  reading.beside = [&](const std::string& name) {
    CHECK(name == "my fly.bin");
    return bytes;
  };
  const Path path = read_any_path(embedded).path;
  CHECK(read_any_path(with_uri("my%20fly.bin"), {}, reading).path == path);
  std::string percents = "data:application/octet-stream,";
  for (const char c : bytes) percents += fmt::format("%{:02x}", static_cast<unsigned char>(c));
  CHECK(read_any_path(with_uri(percents)).path == path);
  CHECK(refusal(with_uri("fly.bin")).starts_with("/buffers/0/uri: the data is in another file"));
  for (const char* outside : {"../fly.bin", "/fly.bin", "file:fly.bin", "%2ffly.bin"})
    CHECK_THROWS_AS(read_any_path(with_uri(outside), {}, reading), InputError);
}

TEST_CASE("glTF: what is no curve is refused by its place") {
  CHECK(refusal(gltf(lines, "48", "12", "3 3", "STEP")) ==
        "/animations/0/samplers/0: the node moves by STEP, which is no curve");
  CHECK(refusal(gltf(lines, "48", "12", "3 9", "LINEAR")) ==
        "/accessors/1: the buffer ends before the data of the accessor");
  std::string packed = gltf(lines, "48", "12", "3 3", "LINEAR");
  packed.insert(packed.find(R"("byteLength": 12)"), R"("byteStride": 0, )");
  CHECK(refusal(packed) == "/bufferViews/0/byteStride: an element has 4 bytes");
  CHECK(refusal(gltf("!" + lines, "48", "12", "3 3", "LINEAR")) ==
        "/buffers/0/uri: the data is not base64");
  CHECK(refusal(R"({"asset": {"version": "2.0"}})") ==
        "/: there is no animation in the file that moves a node");
  CHECK(refusal(std::string("glTF\1\0\0\0", 8)) ==
        "header: the binary glTF is cut off, or not of version 2");
}

}  // namespace gltf_file_test
