#pragma once
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

/// How far apart two places may be that are one but for rounding, beside places of such
/// coordinates: 2^−48 of the greatest of these, some units in the last place of doubles.
Rational rounding_gap(const std::vector<Vector<Rational>>& places);

/// Is b at most so far from a?
bool are_within(const Rational& gap, const Vector<Rational>& a, const Vector<Rational>& b);

/// Where the last of the points, of a closed curve, is the first one but for rounding, and they are
/// some 32 times as far apart, it becomes that. Was it another before?
bool close_to_rounding(std::vector<Vector<Rational>>& points);

}  // namespace phrame
