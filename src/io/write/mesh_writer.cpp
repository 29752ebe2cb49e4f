#include "phrame/io/write/mesh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/nearest_float.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/bytes.hpp"
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
std::string origin_text(const Vector<Rational>& origin) {
  const auto& [x, y, z] = origin;
  if (origin == Vector<Rational>{}) return "";
  return fmt::format("origin {} {} {}", to_string(x), to_string(y), to_string(z));
}

/// Lines that begin with `mark`: the remark and the origin, where there are any.
std::string comments(const Vector<Rational>& origin, const std::string& remark, const char* mark) {
  std::string lines;
  for (const std::string& text : {remark, origin_text(origin)})
    if (!text.empty()) lines += fmt::format("{} {}\n", mark, text);
  return lines;
}

/// Throws where a format has 32 bits for what is more.
void require_32_bits(const char* format, std::uint64_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw DomainError(std::string("sweep: the mesh is too large for ") + format +
                      "; OBJ and PLY have no limit");
}

/// As JSON.
std::string text_of(const Vector<float>& point) {
  return fmt::format("[{},{},{}]", point[0], point[1], point[2]);
}

class ObjWriter : public MeshWriter {
 public:
  using MeshWriter::MeshWriter;
  void finish(const Vector<Rational>& origin, const std::string& remark,
              const Write& write) const override {
    write(comments(origin, remark, "#"));
    of_points().read(write);
    of_triangles().read(write);
  }

 private:
  void append_point(std::string& bytes, const Vector<double>& point) override {
    fmt::format_to(std::back_inserter(bytes), "v {} {} {}\n", point[0], point[1], point[2]);
  }
  void append_triangle(std::string& bytes, const Triangle& triangle,
                       const Corners& /*corners*/) override {
    const auto& [i, j, k] = triangle;
    fmt::format_to(std::back_inserter(bytes), "f {} {} {}\n", std::uint64_t{i} + 1,
                   std::uint64_t{j} + 1, std::uint64_t{k} + 1);
  }
};

class PlyWriter : public MeshWriter {
 public:
  using MeshWriter::MeshWriter;
  void finish(const Vector<Rational>& origin, const std::string& remark,
              const Write& write) const override {
    write(
        fmt::format("ply\nformat binary_little_endian 1.0\n{}element vertex {}\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                    comments(origin, remark, "comment"), points(), triangles()));
    of_points().read(write);
    of_triangles().read(write);
  }

 private:
  void append_point(std::string& bytes, const Vector<double>& point) override {
    for (const double x : point) append_number(bytes, std::bit_cast<std::uint64_t>(x));
  }
  void append_triangle(std::string& bytes, const Triangle& triangle,
                       const Corners& /*corners*/) override {
    bytes += '\3';
    for (const std::uint32_t k : triangle) append_number(bytes, k);
  }
};

class StlWriter : public MeshWriter {
 public:
  using MeshWriter::MeshWriter;
  void finish(const Vector<Rational>& origin, const std::string& /*remark*/,
              const Write& write) const override {
    std::string bytes = "phrame";
    if (const std::string text = origin_text(origin); !text.empty()) bytes += "; " + text;
    if (bytes.size() > 80) bytes = "phrame; origin not 0";
    bytes.resize(80, ' ');
    require_32_bits("STL", triangles());
    append_number(bytes, static_cast<std::uint32_t>(triangles()));
    write(bytes);
    of_triangles().read(write);
  }

 private:
  void append_point(std::string& /*bytes*/, const Vector<double>& /*point*/) override {}
  void append_triangle(std::string& bytes, const Triangle& /*triangle*/,
                       const Corners& corners) override {
    const std::array<Vector<float>, 3> points{floats_of(*corners[0]), floats_of(*corners[1]),
                                              floats_of(*corners[2])};
    for (const float x : normal_of(points)) append_float(bytes, x);
    for (const Vector<float>& point : points)
      for (const float x : point) append_float(bytes, x);
    append_number(bytes, std::uint16_t{0});
  }
};

class GlbWriter : public MeshWriter {
 public:
  using MeshWriter::MeshWriter;
  void finish(const Vector<Rational>& origin, const std::string& remark,
              const Write& write) const override;

 private:
  void append_point(std::string& bytes, const Vector<double>& point) override;
  void append_triangle(std::string& bytes, const Triangle& triangle,
                       const Corners& /*corners*/) override {
    for (const std::uint32_t k : triangle) append_number(bytes, k);
  }

  Vector<float> least_{};     ///< of each coordinate
  Vector<float> greatest_{};  ///< likewise
};

void GlbWriter::append_point(std::string& bytes, const Vector<double>& point) {
  const Vector<float> floats = floats_of(point);
  if (points() == 0) least_ = greatest_ = floats;
  for (std::size_t k = 0; k < 3; ++k) {
    least_[k] = std::min(least_[k], floats[k]);
    greatest_[k] = std::max(greatest_[k], floats[k]);
    append_float(bytes, floats[k]);
  }
}

void GlbWriter::finish(const Vector<Rational>& origin, const std::string& remark,
                       const Write& write) const {
  const std::uint64_t size = of_points().size() + of_triangles().size();
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"phrame"{8}}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0{7}}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},)"
      R"("indices":1}}]}}],"buffers":[{{"byteLength":{0}}}],"bufferViews":[)"
      R"({{"buffer":0,"byteLength":{1},"target":34962}},)"
      R"({{"buffer":0,"byteOffset":{1},"byteLength":{2},"target":34963}}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":{3},"type":"VEC3","min":{4},"max":{5}}},)"
      R"({{"bufferView":1,"componentType":5125,"count":{6},"type":"SCALAR"}}]}})",
      size, of_points().size(), of_triangles().size(), points(), text_of(least_),
      text_of(greatest_), 3 * triangles(),
      translation_json(
          {round_to_double(origin[0]), round_to_double(origin[1]), round_to_double(origin[2])}),
      remark.empty() ? "" : fmt::format(R"(,"extras":{{"frame":"{}"}})", remark));
  require_32_bits("GLB", size + json.size() + 64);
  write(glb_head(json, size));
  of_points().read(write);
  of_triangles().read(write);
}

template <class Writer>
std::unique_ptr<MeshWriter> writer(MeshWriter::NewSpool spool) {
  return std::make_unique<Writer>(spool(), spool());
}

}  // namespace

void MeshWriter::add_point(const Vector<double>& point) {
  of_points_.append([&](std::string& bytes) { append_point(bytes, point); });
  ++points_;
}

void MeshWriter::add_triangle(const Triangle& triangle, const Corners& corners) {
  of_triangles_.append([&](std::string& bytes) { append_triangle(bytes, triangle, corners); });
  ++triangles_;
}

std::unique_ptr<MeshWriter> obj_writer(MeshWriter::NewSpool spool) {
  return writer<ObjWriter>(spool);
}
std::unique_ptr<MeshWriter> ply_writer(MeshWriter::NewSpool spool) {
  return writer<PlyWriter>(spool);
}
std::unique_ptr<MeshWriter> stl_writer(MeshWriter::NewSpool spool) {
  return writer<StlWriter>(spool);
}
std::unique_ptr<MeshWriter> glb_writer(MeshWriter::NewSpool spool) {
  return writer<GlbWriter>(spool);
}

}  // namespace phrame
