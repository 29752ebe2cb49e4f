#pragma once
#include <span>

#include "phrame/ph/sweep/mesh.hpp"

namespace phrame::inline v0 {

/// Takes a mesh as it is made.
class MeshSink {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  using Corners = std::array<const Vector<double>*, 3>;

  MeshSink() = default;
  MeshSink(const MeshSink&) = delete;
  MeshSink& operator=(const MeshSink&) = delete;
  virtual ~MeshSink() = default;

  /// The next one.
  virtual void add_point(const Vector<double>& point) = 0;
  /// By the numbers of points that are there, and these.
  virtual void add_triangle(const Triangle& triangle, const Corners& corners) = 0;
  /// Of the points so far only these are corners of triangles to come.
  virtual void keep_points(std::span<const std::uint32_t> /*some*/,
                           std::span<const std::uint32_t> /*others*/) {}
};

}  // namespace phrame
