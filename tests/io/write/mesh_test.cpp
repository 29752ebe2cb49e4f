#include "phrame/io/write/mesh.hpp"

#include <cstring>
#include <sstream>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/sweep_stream.hpp"
#include "phrame/io/write/mesh_writer.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

using namespace phrame;

namespace {

const Mesh tetrahedron{{{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, -2.5}},
                       {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};

/// A number at a place among the bytes, on machines whose first byte is the least.
template <class Number>
Number at(const std::string& bytes, std::size_t place) {
  REQUIRE(place + sizeof(Number) <= bytes.size());
  Number x;
  std::memcpy(&x, bytes.data() + place, sizeof x);
  return x;
}

}  // namespace

TEST_CASE("mesh files: OBJ counts from 1 and keeps the doubles") {
  CHECK(to_obj(tetrahedron) ==
        "v 0 0 0\nv 0.1 0 0\nv 0 1 0\nv 0 0 -2.5\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n");
}

TEST_CASE("mesh files: comments have the origin and where the frame starts, as readers take them") {
  Mesh mesh = tetrahedron;
  mesh.origin = {1, Rational(1, 2), 0};
  const SweepQuery query{rectangle_profile(1, 1), StartNormal({0, 0, 1})};
  mesh.remark = sweep_remark(query);
  const std::string start = "f2 at the start is along [0, 0, 1], projected to the normal plane";
  CHECK(to_obj(mesh).starts_with("# " + start + "\n# origin 1 1/2 0\nv 0 0 0\n"));
  CHECK(to_ply(mesh).find("\ncomment " + start + "\ncomment origin 1 1/2 0\nelement") !=
        std::string::npos);
  CHECK(to_stl(mesh).starts_with("phrame; origin 1 1/2 0 "));
  const std::string bytes = to_glb(mesh);
  const auto json = test::Json::parse(bytes.substr(20, at<std::uint32_t>(bytes, 12)));
  CHECK(json["asset"]["extras"]["frame"] == start);
}

TEST_CASE("mesh files: PLY has doubles and lists of three") {
  const std::string bytes = to_ply(tetrahedron);
  const std::size_t data = bytes.find("end_header\n") + 11;
  CHECK(bytes.substr(0, data).find("element vertex 4\n") != std::string::npos);
  CHECK(bytes.substr(0, data).find("element face 4\n") != std::string::npos);
  REQUIRE(bytes.size() == data + 12 * 8 + 4 * 13);
  CHECK(at<double>(bytes, data + 3 * 8) == 0.1);
  CHECK(at<double>(bytes, data + 11 * 8) == -2.5);
  CHECK(bytes[data + 12 * 8 + 13] == 3);
  CHECK(at<std::uint32_t>(bytes, data + 12 * 8 + 14) == 0);
  CHECK(at<std::uint32_t>(bytes, data + 12 * 8 + 18) == 3);
}

TEST_CASE("mesh files: STL has a normal and three points for each triangle") {
  const std::string bytes = to_stl(tetrahedron);
  REQUIRE(bytes.size() == 84 + 4 * 50);
  CHECK_FALSE(bytes.starts_with("solid"));  // or readers take it for text
  CHECK(at<std::uint32_t>(bytes, 80) == 4);
  CHECK(at<float>(bytes, 84 + 8) == 1);  // 0, 1, 2 are counterclockwise from above
  CHECK(at<float>(bytes, 84 + 24) == 0.1F);
  CHECK(at<float>(bytes, 84 + 50 + 4) == -1);  // of 0, 3, 1: away from the point 2
}

TEST_CASE("mesh files: GLB has a JSON chunk that fits its binary chunk") {
  const std::string bytes = to_glb(tetrahedron);
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(at<std::uint32_t>(bytes, 4) == 2);
  CHECK(at<std::uint32_t>(bytes, 8) == bytes.size());
  const auto length = at<std::uint32_t>(bytes, 12);
  CHECK(length % 4 == 0);
  CHECK(bytes.substr(16, 4) == "JSON");
  const auto json = test::Json::parse(bytes.substr(20, length));
  const std::size_t data = 20 + length + 8;
  CHECK(at<std::uint32_t>(bytes, 20 + length) == 4 * 12 + 12 * 4);
  CHECK(bytes.substr(20 + length + 4, 4) == std::string("BIN\0", 4));
  REQUIRE(bytes.size() == data + 96);
  CHECK(json["buffers"][0]["byteLength"] == 96);
  CHECK(json["bufferViews"][1]["byteOffset"] == 48);
  CHECK(json["accessors"][0]["count"] == 4);
  CHECK(json["accessors"][0]["min"] == test::Json({0, 0, -2.5}));
  CHECK(json["accessors"][0]["max"][0].get<float>() == 0.1F);
  CHECK(json["accessors"][1]["count"] == 12);
  CHECK(at<float>(bytes, data + 12) == 0.1F);
  CHECK(at<std::uint32_t>(bytes, data + 48 + 16) == 3);
}

namespace {

/// Two quarters of circles that meet at a corner.
Path angular() {
  return joined({bezier_curve({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {1, 1, 2}),
                 bezier_curve({{2, 2, 0}, {4, 2, 0}, {4, 4, 0}}, {1, 1, 2})});
}

std::string streamed(const NamedPath& path, const SweepQuery& query,
                     std::unique_ptr<MeshWriter> (*writer_of)(MeshWriter::NewSpool)) {
  const auto writer = writer_of(Spool::with_file);
  const SweepAnswer found = answer(path, query, *writer);
  CHECK(found.body.mesh.points.empty());
  std::string bytes;
  writer->finish(found.body.mesh.origin, "a remark",
                 [&](const std::string& part) { bytes += part; });
  return bytes;
}

}  // namespace

// Of megabytes, which are in temporary files.
TEST_CASE("mesh files: what is written while the mesh is made is what is written of a whole one") {
  for (const NamedPath& path :
       {NamedPath{"", PhPath(Curve({{1, 2}, {0, 1}, {3}, {1, -1}}))},
        NamedPath{"", PhPath(test::chain(test::quarters()))}, NamedPath{"", angular()}}) {
    SweepQuery query{circle_profile(Rational(1, 100), Rational(1, 10000))};
    query.tolerance_or_sections = 900L;
    query.numbers = Coordinates::floats;
    SweepAnswer whole = answer(path, query);
    whole.body.mesh.remark = "a remark";
    CHECK(streamed(path, query, obj_writer) == to_obj(whole.body.mesh));
    CHECK(streamed(path, query, ply_writer) == to_ply(whole.body.mesh));
    CHECK(streamed(path, query, stl_writer) == to_stl(whole.body.mesh));
    CHECK(streamed(path, query, glb_writer) == to_glb(whole.body.mesh));
  }
}

TEST_CASE("mesh files: what is no body is refused while it is made, as a whole one is") {
  const NamedPath path{"", PhPath(Curve({{1}, {}, {}, {}}))};
  SweepQuery query{rectangle_profile(1, 1)};
  query.tolerance_or_sections = 20000L;
  query.numbers = Coordinates::floats;
  query.origin = {-1000000, 0, 0};
  CHECK_THROWS_AS(answer(path, query), Undecided);
  CHECK_THROWS_AS(streamed(path, query, glb_writer), Undecided);
}
