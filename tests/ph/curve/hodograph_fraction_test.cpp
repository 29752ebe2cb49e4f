#include "phrame/ph/curve/hodograph_fraction.hpp"

#include <doctest/doctest.h>

#include "phrame/ph/curve/rational_ph.hpp"
#include "support/curves.hpp"
#include "support/rational_curves.hpp"

using namespace phrame;

// ((1 − t²)/(1 + t²))′ = −4t/(1 + t²)², (2t/(1 + t²))′ = (2 − 2t²)/(1 + t²)².
TEST_CASE("hodograph_fraction: in lowest terms, however W was chosen") {
  const Curve arc = test::quarter_circle();
  const Vector<Polynomial> rate{Polynomial{0, -4}, Polynomial{2, 0, -2}, Polynomial{}};
  for (const Polynomial& c : {Polynomial{1}, Polynomial{3, 1}, Polynomial{-2, 0, Rational(1, 7)}}) {
    const HodographFraction r = hodograph_fraction(test::with_factor(arc, c));
    CHECK(r.numerator == rate);
    CHECK(r.denominator == Polynomial{1, 0, 2, 0, 1});
    CHECK(hodograph_content(test::with_factor(arc, c)).is_constant());
  }
}

// A i A* = (1 + t² − t⁴, 2t², 2t³) over (t + 2)⁶; r has the weight (t + 2)⁵, so that W²r′ has the
// factor (t + 2)⁴.
TEST_CASE("hodograph_fraction: the denominator may be less than the square of the weight") {
  const QuaternionPolynomial a{{1}, {0, 1}, {}, {0, 0, 1}};
  const Curve curve =
      rational_ph_curve(a, RationalFunction(Polynomial{1}, pow(Polynomial{2, 1}, 6)));
  REQUIRE(curve.weight().degree() == 5);
  const HodographFraction r = hodograph_fraction(curve);
  CHECK(Rational(64) * r.denominator == pow(Polynomial{2, 1}, 6));
  CHECK(Rational(64) * r.numerator[0] == Polynomial{1, 0, 1, 0, -1});
  CHECK(hodograph_content(curve).is_constant());
  const HodographFraction polynomial = hodograph_fraction(test::quintic);
  CHECK(polynomial.numerator == hodograph(test::quintic));
  CHECK(polynomial.denominator == Polynomial{1});
}
