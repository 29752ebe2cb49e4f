#pragma once
#include "phrame/algebra/polynomial.hpp"

namespace phrame::inline v0 {

/// The same polynomial in as little memory as it needs, to be kept: FLINT gives a number the room
/// that greater ones had before in its place.
Polynomial compact(Polynomial p);

}  // namespace phrame
