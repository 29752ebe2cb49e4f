#pragma once
#include <functional>
#include <optional>

#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// What is nearer to a path in a plane z = const than |d|.
class PathDistance {
 public:
  /// Precondition: the path is in such a plane, d ≠ 0.
  PathDistance(const PhPath& path, const Rational& d);

  /// A point of the path that is nearer to this one than |d|, if there is any: decided exactly, at
  /// a distance of |d| to some points, too.
  std::optional<Vector<Rational>> nearer_point(const Vector<Rational>& at) const;
  /// The same, where it is known that segment is at the distance |d| at t, along the normal there.
  std::optional<Vector<Rational>> nearer_point(const Vector<Rational>& at, std::size_t segment,
                                               const Rational& t) const;
  /// Is one point of the path seen to be nearer than |d| to all points of the box? Doubles, with
  /// their errors, decide that; false says nothing.
  bool covers(const PlaneBox& box) const;

 private:
  struct Part {
    Polynomial x;                               ///< of the position
    Polynomial y;                               ///< likewise
    std::vector<std::array<double, 2>> points;  ///< some of its points, rounded
    PlaneBox box;                               ///< all of it
  };

  void add_boxes(std::size_t node, std::size_t first, std::size_t last);
  bool any_within(const PlaneBox& box, double reach,
                  const std::function<bool(std::size_t part)>& is_wanted) const;
  std::optional<Vector<Rational>> nearer_point(const Vector<Rational>& at, std::size_t segment,
                                               const Polynomial& known) const;

  Rational squared_;  ///< d²
  double reach_;      ///< a little more than |d|
  double certain_;    ///< a little less than d²
  double error_;      ///< of the square of a distance, by rounding
  std::vector<Part> parts_;
  std::vector<PlaneBox> boxes_;  ///< of all parts, of each half of them, and so on, as in a heap
};

}  // namespace phrame
