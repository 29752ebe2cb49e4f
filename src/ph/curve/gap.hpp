#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

/// How far apart two places may be that are one but for rounding, beside places of such
/// coordinates: 2^−48 of the greatest of these, some units in the last place of doubles.
Rational rounding_gap(const std::vector<Vector<Rational>>& places);

/// Is b at most so far from a?
bool are_within(const Rational& gap, const Vector<Rational>& a, const Vector<Rational>& b);

/// Is it small beside the way from the first of these places to some other, by a factor of 32?
bool is_small_beside(const Vector<Rational>& way, const std::vector<Vector<Rational>>& places);

/// Where the last of the points, of a closed curve, is the first one but for rounding, and
/// that is_small_beside() them, it becomes that. Was it another before?
bool close_to_rounding(std::vector<Vector<Rational>>& points);

}  // namespace phrame
