#pragma once
#include <functional>
#include <memory>
#include <string>

#include "phrame/algebra/spool.hpp"
#include "phrame/ph/sweep/mesh_sink.hpp"

namespace phrame::inline v0 {

/// Makes a file of a mesh whose points and triangles come one after the other. It keeps bytes, in
/// spools, since what stands before them in the file is known when all of them are there.
class MeshWriter : public MeshSink {
 public:
  using Write = std::function<void(const std::string&)>;
  using NewSpool = Spool (*)();  ///< gives one without bytes

  /// The bytes of both are in such spools.
  MeshWriter(Spool of_points, Spool of_triangles)
      : of_points_(std::move(of_points)), of_triangles_(std::move(of_triangles)) {}

  void add_point(const Vector<double>& point) final;
  void add_triangle(const Triangle& triangle, const Corners& corners) final;
  /// Calls write() for parts of the file, when all is there, of a mesh with this origin and remark.
  /// Throws DomainError where there is more than the format can have, before it writes.
  virtual void finish(const Vector<Rational>& origin, const std::string& remark,
                      const Write& write) const = 0;

  std::size_t points() const { return points_; }
  std::size_t triangles() const { return triangles_; }

 protected:
  const Spool& of_points() const { return of_points_; }
  const Spool& of_triangles() const { return of_triangles_; }

 private:
  virtual void append_point(std::string& bytes, const Vector<double>& point) = 0;
  virtual void append_triangle(std::string& bytes, const Triangle& triangle,
                               const Corners& corners) = 0;

  Spool of_points_;
  Spool of_triangles_;
  std::size_t points_ = 0;
  std::size_t triangles_ = 0;
};

// What to_obj() and the others write.

std::unique_ptr<MeshWriter> obj_writer(MeshWriter::NewSpool spool);
std::unique_ptr<MeshWriter> ply_writer(MeshWriter::NewSpool spool);
std::unique_ptr<MeshWriter> stl_writer(MeshWriter::NewSpool spool);
std::unique_ptr<MeshWriter> glb_writer(MeshWriter::NewSpool spool);

}  // namespace phrame
