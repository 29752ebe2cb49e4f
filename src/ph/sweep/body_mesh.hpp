#pragma once
#include "phrame/ph/sweep/mesh_sink.hpp"
#include "phrame/ph/sweep/sweep_section.hpp"

namespace phrame::inline v0 {

/// The mesh of a body, made of one section after the other.
class BodyMesh {
 public:
  /// Of a path that is closed or not, which goes along e₁ or against it. The profile and `out` must
  /// outlive this.
  BodyMesh(const Profile& profile, bool is_closed, bool is_against, MeshSink& out);

  /// The last section of a closed path is the first one again. Throws Undecided where there would
  /// be more points than have numbers.
  void add(const SweepSection& section);
  /// All sections are there.
  void finish();

  std::size_t sections() const { return sections_; }  ///< of the mesh
  long folds() const { return folds_; }               ///< of these

 private:
  struct Ring {
    SweepSection section = {};
    std::vector<std::uint32_t> numbers = {};  ///< of the points of the mesh at the corners
    std::vector<Vector<double>> points = {};  ///< these, which may be those of a ring before
  };
  void add_ring(SweepSection section, bool is_at_joint);
  void add_strip(const Ring& here, const Ring& there);
  void add_triangle(const Ring& a, std::size_t i, const Ring& b, std::size_t j, const Ring& c,
                    std::size_t k);

  const Profile& profile_;
  bool is_closed_;
  bool is_against_;
  MeshSink& out_;
  std::vector<SweepSection> waiting_ = {};  ///< of a closed path the last two
  std::uint32_t points_ = 0;
  std::size_t sections_ = 0;
  long folds_ = 0;
  Ring first_ = {};
  Ring last_ = {};
};

}  // namespace phrame
