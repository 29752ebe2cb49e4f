#pragma once
#include <functional>
#include <optional>

#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/curve/ph_path.hpp"

namespace phrame::inline v0 {

/// A disc of the plane.
struct Disc {
  Vector<Rational> center;  ///< in the plane
  Rational radius;          ///< of any sign
};

/// Discs about (x/w, y/w) of the radius r/w, of any sign, at t from 0 to 1.
struct DiscTrack {
  Polynomial x;
  Polynomial y;
  Polynomial radius;  ///< r, not 0 of all tracks
  Polynomial weight;  ///< w > 0

  Disc at(const Rational& t) const;  ///< in the plane z = 0
};

/// The straight way of discs of one radius that do not turn back.
struct DiscLine {
  Vector<Rational> start;
  Vector<Rational> way;  ///< from there to the end, ≠ 0
};

/// What is inside of discs along tracks: of what is nearer to a path than |d| all have the radius
/// |d|.
class DiscCover {
 public:
  explicit DiscCover(const std::vector<DiscTrack>& tracks);  ///< of these
  /// Of the radius d ≠ 0 about all points of a path in a plane z = const.
  DiscCover(const PhPath& path, const Rational& d);

  /// A disc that the point is inside of, if there is any: decided exactly, on circles, too. `known`
  /// is a factor, ≥ 0 on [0, 1], of |(x, y) − w·at|² − r² of that track: (s − t)² where the
  /// envelope touches the disc of t in that point.
  std::optional<Disc> disc_around(const Vector<Rational>& at, std::size_t track,
                                  const Polynomial& known) const;
  /// The same where nothing is known.
  std::optional<Disc> disc_around(const Vector<Rational>& at) const;
  /// Is one disc seen to have all of the box inside? Doubles, with their errors, decide that; false
  /// says nothing.
  bool covers(const PlaneBox& box) const;
  /// Is any of the tracks wanted of which the point may be inside of a disc? All others are too far
  /// away.
  bool any_near(const Vector<Rational>& at,
                const std::function<bool(std::size_t track)>& is_wanted) const;

 private:
  struct Part {
    DiscTrack track;  ///< of which it is
    /// Those at t = 0, 1/n, …, 1: x, y, a little less than radius².
    std::vector<std::array<double, 3>> discs;
    PlaneBox box;                       ///< of all centers
    std::optional<DiscLine> line = {};  ///< where it is one
  };

  /// A disc of a part that is seen to have all of the box inside, by its number, in doubles.
  static std::optional<std::size_t> covering(const Part& part, const PlaneBox& box);
  void add_boxes(std::size_t node, std::size_t first, std::size_t last);
  bool any_within(const PlaneBox& box, double reach,
                  const std::function<bool(std::size_t part)>& is_wanted) const;

  double reach_ = 0;  ///< a little more than the greatest radius
  std::vector<Part> parts_;
  std::vector<PlaneBox> boxes_;  ///< of all parts, of each half of them, and so on, as in a heap
};

/// Where p < 0 on [0, 1], if anywhere: decided exactly.
std::optional<Rational> negative_place(const Polynomial& p);

/// (s − t)², in s.
Polynomial double_zero(const Rational& t);

}  // namespace phrame
