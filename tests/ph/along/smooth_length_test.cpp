#include "phrame/ph/along/smooth_length.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

namespace smooth_length_test {

using namespace phrame;

namespace {

/// The part of (9/32·t², 9/64·t³, 0) from a to b: |r′| = 9/16·t·√(1 + 9/16·t²), s = ((1 +
/// 9/16·t²)^{3/2} − 1)/3.
Segment part(const Rational& a, const Rational& b) {
  const Polynomial t{a, b - a};
  return RationalCurve({Rational(9, 32) * t * t, Rational(9, 64) * t * t * t, Polynomial()});
}

}  // namespace

// (5/4)³ = 125/64: the length is 61/192.
TEST_CASE("smooth length: what is elementary is exact, and told from what is given") {
  const SmoothLength length{Path(part(0, 1))};
  const Rational whole(61, 192);
  CHECK(length.total().exact() == whole);
  const Place end = length.point(whole);
  CHECK(end.t.exact() == Rational(1));
  CHECK(length.point(whole - power_of_two(-20000)).t.exact() == std::nullopt);
  CHECK(length.point(whole + power_of_two(-20000)).t.exact() == Rational(1));  // the same double
  CHECK_THROWS_AS(length.point(whole + power_of_two(-50)), DomainError);
  CHECK(length.value({0, Rational(1, 3)}).origin().is_irrational);
}

// √(1 + 9/16·4/25) = √109/10 is in the lengths of both parts.
TEST_CASE("smooth length: roots cancel where a curve is cut, and so does a parameter in a part") {
  const SmoothLength length(joined({part(0, Rational(2, 5)), part(Rational(2, 5), 2)}));
  CHECK_FALSE(length.before(1).exact());
  CHECK(length.value({1, Rational(3, 8)}).exact() == Rational(61, 192));  // t = 1
  const SmoothLength to_end(joined({part(0, Rational(2, 5)), part(Rational(2, 5), 1)}));
  CHECK(to_end.total().exact() == Rational(61, 192));
  CHECK(to_end.point(Rational(61, 192)).segment == 1);
}

}  // namespace smooth_length_test
