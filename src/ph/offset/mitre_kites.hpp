#pragma once
#include <array>
#include <functional>

#include "phrame/ph/offset/offset.hpp"

namespace phrame::inline v0 {

/// What is between the mitres of an offset and the path: kites with the corner, the tip, and the
/// ends of the offsets of both sides. Two sides of each are mitres, and two are at |d| from the
/// corner at most.
class MitreKites {
 public:
  /// Of that offset; a segment starts in start(k).
  MitreKites(const Offset& offset,
             const std::function<Vector<Rational>(std::size_t segment)>& start);

  /// Is the point inside one of them, not on its boundary?
  bool contain(const Vector<Rational>& at) const;

 private:
  struct Kite {
    std::array<Vector<Rational>, 4> points;  ///< to the left
    std::array<double, 2> center{};          ///< the corner
    double reach = 0;                        ///< nothing of it is farther from that, in x and in y
  };

  std::vector<Kite> kites_;
};

}  // namespace phrame
