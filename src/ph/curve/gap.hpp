#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// The distance that may be due to rounding between two places with such coordinates: 2^−48 of the
/// greatest coordinate, some units in the last place of doubles.
Rational rounding_gap(const std::vector<Vector<Rational>>& places);

/// Is the distance from a to b at most this?
bool are_within(const Rational& gap, const Vector<Rational>& a, const Vector<Rational>& b);

/// Is the vector shorter than the way from the first of these places to some other, by a factor of
/// 32?
bool is_small_beside(const Vector<Rational>& way, const std::vector<Vector<Rational>>& places);

/// Makes the last point of a closed curve equal to the first, where they differ by rounding only
/// and the difference is_small_beside() the points. Was it another point before?
bool close_to_rounding(std::vector<Vector<Rational>>& points);

}  // namespace phrame
