#pragma once
#include <span>

#include "phrame/ph/sweep/mesh.hpp"

namespace phrame::inline v0 {

/// The sides of triangles that start at each point, by where they end.
class MeshSides {
 public:
  using Side = std::array<std::uint32_t, 2>;  ///< from, to

  /// Of triangles of so many points, and other sides.
  MeshSides(std::size_t points, std::span<const std::array<std::uint32_t, 3>> triangles,
            std::span<const Side> others = {});

  /// Is each there once, with its opposite, which is another?
  bool are_paired() const {
    return are_paired_but([](std::uint32_t) { return false; }, nullptr);
  }
  /// Likewise, but for those between two points of which is_open(point), which may have their
  /// opposites still to come, and are added to `left`.
  template <class IsOpen>
  bool are_paired_but(const IsOpen& is_open, std::vector<Side>* left) const;

 private:
  using Ends = std::vector<std::uint32_t>;
  Ends::const_iterator begin(std::size_t from) const {
    return ends_.begin() + static_cast<std::ptrdiff_t>(first_[from]);
  }
  Ends::const_iterator end(std::size_t from) const { return begin(from + 1); }
  bool has(std::uint32_t from, std::uint32_t to) const;
  bool has_twice(std::uint32_t from) const;  ///< is one of its sides there twice?

  std::vector<std::size_t> first_;
  Ends ends_;
};

template <class IsOpen>
bool MeshSides::are_paired_but(const IsOpen& is_open, std::vector<Side>* left) const {
  for (std::uint32_t from = 0; from + 1 < first_.size(); ++from) {
    if (has_twice(from)) return false;
    for (auto to = begin(from); to != end(from); ++to) {
      if (*to == from) return false;
      if (is_open(from) && is_open(*to))
        left->push_back({from, *to});
      else if (!has(*to, from))
        return false;
    }
  }
  return true;
}

/// Are the three not on one line? Decided exactly.
bool has_area(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c);

}  // namespace phrame
