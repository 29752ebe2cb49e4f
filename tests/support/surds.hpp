#pragma once
#include <doctest/doctest.h>

#include "phrame/algebra/ball.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame::inline v0::test {

inline RealBall value(const Surd& x, long bits) {
  RealBall sum;
  for (const auto& [d, c] : x.terms())
    sum = add(sum, multiply(RealBall(c, bits), sqrt(RealBall(d, bits), bits), bits), bits);
  return sum;
}

/// The product of the conjugates in field_of(x).
template <class C>
C norm(SurdSum<C> x) {
  for (const RootField& fixed : fields_without_a_root(field_of(x))) x = x * conjugate(x, fixed);
  CHECK(x.is_rational());
  return x.rational_part();
}

}  // namespace phrame::test
