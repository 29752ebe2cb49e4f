#pragma once
#include "phrame/ph/curve.hpp"

namespace phrame::test {

/// The quintic of [Farouki 2003], §5.
inline const Curve quintic({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                            from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});

}  // namespace phrame::test
