#pragma once
#include <optional>

#include "phrame/algebra/spool.hpp"
#include "phrame/ph/sweep/mesh_sides.hpp"
#include "phrame/ph/sweep/mesh_sink.hpp"

namespace phrame::inline v0 {

/// Sees of a mesh, while it is made and passed on, what is_watertight() and require_apart() see of
/// a whole one, in some 20 MB however long it is: triangles are looked at some thousands at a time,
/// and points by 64 bits of each, which are apart where the points are, but for accidents.
class MeshSieve : public MeshSink {
 public:
  MeshSieve(Coordinates numbers, MeshSink& out);

  void add_point(const Vector<double>& point) override;
  void add_triangle(const Triangle& triangle, const Corners& corners) override;
  void keep_points(std::span<const std::uint32_t> some,
                   std::span<const std::uint32_t> others) override;
  /// When all is there: is all of it proved? Where it is not, only the whole mesh tells.
  bool is_proved();

 private:
  void look_at_sides(std::vector<std::uint32_t> kept);
  std::optional<std::uint32_t> place_of(std::uint32_t point) const;
  bool are_apart() const;

  double greatest_;  ///< that a coordinate can be
  MeshSink& out_;
  bool is_sound_ = true;  ///< all that has been looked at
  std::uint32_t points_ = 0;
  Spool hashes_ = Spool::with_file();
  // Of the triangles that have been looked at, the points below first_ that others may have, and
  // the sides between these. The last triangles, since then.
  std::vector<std::uint32_t> kept_{};
  std::uint32_t first_ = 0;
  std::vector<MeshSides::Side> open_{};
  std::vector<Triangle> last_{};
};

}  // namespace phrame
