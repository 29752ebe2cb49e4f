#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// The hodographs of a polynomial curve and of another near it, on [0, 1], by their Bernstein
/// coefficients in the same degree.
struct HodographPair {
  std::vector<Vector<Rational>> given;  ///< of the curve that is given
  std::vector<Vector<Rational>> other;  ///< of the one near it
};

/// A number that bounds, for all t of the pieces, the angle between the rotation-minimizing frames
/// of the two curves, which agree at the start; frames of different tangents are compared, there
/// and here, by the shortest rotation of one tangent to the other. The pieces are run through one
/// after another. The tangent of the other curve is continuous where they join; that of the given
/// one may break a little, and its frame goes on by the shortest rotation.
///
/// No value where the speed of the other curve is not proved to be > 0, or not to be greater than
/// the difference of the hodographs.
std::optional<Rational> rmf_difference_bound(const std::vector<HodographPair>& pieces);

}  // namespace phrame
