#include "phrame/io/write/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "phrame/algebra/nearest_float.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/bytes.hpp"
#include "phrame/io/write/frame_start.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

Vector<float> floats_of(const Vector<double>& point) {
  return {as_float(point[0]), as_float(point[1]), as_float(point[2])};
}

/// The unit normal of a triangle, 0 where it has no area.
Vector<float> normal_of(const std::array<Vector<float>, 3>& triangle) {
  const auto to_corner = [&triangle](std::size_t corner) {
    Vector<double> side{};
    for (std::size_t k = 0; k < 3; ++k)
      side[k] = static_cast<double>(triangle[corner][k]) - static_cast<double>(triangle[0][k]);
    return side;
  };
  const Vector<double> n = cross(to_corner(1), to_corner(2));
  const double size = std::hypot(n[0], n[1], n[2]);
  if (size == 0) return {};
  return floats_of(1 / size * n);
}

/// "origin 1 0 0", or nothing where that is 0.
std::string origin_text(const Mesh& mesh) {
  const auto& [x, y, z] = mesh.origin;
  if (mesh.origin == Vector<Rational>{}) return "";
  return fmt::format("origin {} {} {}", to_string(x), to_string(y), to_string(z));
}

/// Lines that begin with `mark`: the remark and the origin, where there are any.
std::string comments(const Mesh& mesh, const char* mark) {
  std::string lines;
  for (const std::string& text : {mesh.remark, origin_text(mesh)})
    if (!text.empty()) lines += fmt::format("{} {}\n", mark, text);
  return lines;
}

/// The least or the greatest coordinates, as JSON.
template <class Choose>
std::string extreme_of(const Mesh& mesh, Choose choose) {
  Vector<float> extreme{};
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) {
      const float x = as_float(mesh.points[n][k]);
      extreme[k] = n == 0 ? x : choose(extreme[k], x);
    }
  return fmt::format("[{},{},{}]", extreme[0], extreme[1], extreme[2]);
}

}  // namespace

std::string to_obj(const Mesh& mesh) {
  std::string text = comments(mesh, "#");
  const auto out = std::back_inserter(text);
  for (const auto& [x, y, z] : mesh.points) fmt::format_to(out, "v {} {} {}\n", x, y, z);
  for (const auto& [i, j, k] : mesh.triangles)
    fmt::format_to(out, "f {} {} {}\n", i + 1, j + 1, k + 1);
  return text;
}

std::string to_ply(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}element vertex {}\n"
      "property double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      comments(mesh, "comment"), mesh.points.size(), mesh.triangles.size());
  for (const auto& point : mesh.points)
    for (const double x : point) append_number(bytes, std::bit_cast<std::uint64_t>(x));
  for (const auto& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t k : triangle) append_number(bytes, k);
  }
  return bytes;
}

std::string to_stl(const Mesh& mesh) {
  std::string bytes = "phrame";
  if (const std::string origin = origin_text(mesh); !origin.empty()) bytes += "; " + origin;
  if (bytes.size() > 80) bytes = "phrame; origin not 0";
  bytes.resize(80, ' ');
  append_number(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector<float>, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = floats_of(mesh.points[triangle[k]]);
    for (const float x : normal_of(corners)) append_float(bytes, x);
    for (const Vector<float>& corner : corners)
      for (const float x : corner) append_float(bytes, x);
    append_number(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string to_glb(const Mesh& mesh) {
  std::string data;
  for (const auto& point : mesh.points)
    for (const double x : point) append_float(data, as_float(x));
  const std::size_t of_points = data.size();
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t k : triangle) append_number(data, k);
  const auto least = [](float a, float b) { return std::min(a, b); };
  const auto greatest = [](float a, float b) { return std::max(a, b); };
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"phrame"{8}}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0{7}}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},)"
      R"("indices":1}}]}}],"buffers":[{{"byteLength":{0}}}],"bufferViews":[)"
      R"({{"buffer":0,"byteLength":{1},"target":34962}},)"
      R"({{"buffer":0,"byteOffset":{1},"byteLength":{2},"target":34963}}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":{3},"type":"VEC3","min":{4},"max":{5}}},)"
      R"({{"bufferView":1,"componentType":5125,"count":{6},"type":"SCALAR"}}]}})",
      data.size(), of_points, data.size() - of_points, mesh.points.size(), extreme_of(mesh, least),
      extreme_of(mesh, greatest), 3 * mesh.triangles.size(),
      translation_json({round_to_double(mesh.origin[0]), round_to_double(mesh.origin[1]),
                        round_to_double(mesh.origin[2])}),
      mesh.remark.empty() ? "" : fmt::format(R"(,"extras":{{"frame":"{}"}})", mesh.remark));
  return glb_file(json, data);
}

std::string sweep_remark(const SweepQuery& query) {
  return query.through ? "the frame has the orientations that come with the path"
                       : start_comment(query.start, query.up);
}

}  // namespace phrame
