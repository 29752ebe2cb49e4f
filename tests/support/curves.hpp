#pragma once
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0::test {

/// The quintic of [Farouki 2003], §5.
inline const Curve quintic({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                            from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});

/// The preimage of a curve with a rational rotation-minimizing frame, of class I:
/// A₀ = 1, A₁ = 1 + 2i − j + 3k, A₂ = −5 + 7i − 14j + 2k.
inline const QuaternionPolynomial class_one{from_bernstein({1, 1, -5}), from_bernstein({0, 2, 7}),
                                            from_bernstein({0, -1, -14}),
                                            from_bernstein({0, 3, 2})};

}  // namespace phrame::test
