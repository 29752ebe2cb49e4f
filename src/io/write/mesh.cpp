#include "phrame/io/write/mesh.hpp"

#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/mesh_writer.hpp"

namespace phrame::inline v0 {
namespace {

std::string file_of(const Mesh& mesh, MeshWriter& writer) {
  for (const Vector<double>& point : mesh.points) writer.add_point(point);
  for (const auto& triangle : mesh.triangles) {
    const auto& [i, j, k] = triangle;
    writer.add_triangle(triangle, {&mesh.points[i], &mesh.points[j], &mesh.points[k]});
  }
  std::string file;
  writer.finish(mesh.origin, mesh.remark, [&](const std::string& bytes) { file += bytes; });
  return file;
}

}  // namespace

std::string to_obj(const Mesh& mesh) { return file_of(mesh, *obj_writer(Spool::in_memory)); }
std::string to_ply(const Mesh& mesh) { return file_of(mesh, *ply_writer(Spool::in_memory)); }
std::string to_stl(const Mesh& mesh) { return file_of(mesh, *stl_writer(Spool::in_memory)); }
std::string to_glb(const Mesh& mesh) { return file_of(mesh, *glb_writer(Spool::in_memory)); }

std::string sweep_remark(const SweepQuery& query) {
  return query.through ? "the frame has the orientations that come with the path"
                       : start_comment(query.start, query.up);
}

}  // namespace phrame
