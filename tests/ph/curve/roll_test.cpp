#include "phrame/ph/curve/roll.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace roll_test {

using namespace phrame;

TEST_CASE("roll: values at joints are met, and halves between them are means") {
  const Roll roll({Angle(Rational(1, 2), 0), Angle(0, 1), Angle(Rational(1, 3), Rational(1, 5))});
  roll.require_along(2);
  CHECK_FALSE(roll.is_zero());
  CHECK(roll.at(PathParameter{0, 0}) == Angle(Rational(1, 2), 0));
  CHECK(roll.at(PathParameter{0, 1}) == Angle(0, 1));
  CHECK(roll.at(PathParameter{1, 0}) == Angle(0, 1));
  CHECK(roll.at(PathParameter{1, Rational(1, 2)}) == Angle(Rational(1, 6), Rational(3, 5)));
  CHECK(roll.at(PathParameter{1, 1}) == Angle(Rational(1, 3), Rational(1, 5)));
  CHECK_THROWS_AS(roll.require_along(3), DomainError);
}

TEST_CASE("roll: a function is of the parameter of the path, at irrational places as well") {
  const Roll roll(Roll::Piece{RationalFunction(Polynomial{0, 1}),
                              RationalFunction(Polynomial{1}, Polynomial{-9, 0, 1})});
  roll.require_along(2);
  CHECK(roll.at(PathParameter{1, Rational(1, 2)}) == Angle(Rational(3, 2), Rational(-4, 27)));
  CHECK_THROWS_AS(roll.require_along(3), DomainError);  // its pole is t = 3
  // t = 1 + √2/2: π·t + 1/(t² − 9), by t² = 3/2 + √2.
  const Real root = square_root_of(Rational(1, 2));
  const Place at(1, root);
  const long bits = 128;
  const RealBall t = (Real(Rational(1)) + root).enclose(bits);
  const RealBall below = subtract(multiply(t, t, bits), RealBall(Rational(9), bits), bits);
  const RealBall wanted =
      add(multiply(pi(bits), t, bits), divide(RealBall(Rational(1), bits), below, bits), bits);
  CHECK(roll.at(at).enclose(bits).overlaps(wanted));
  CHECK(roll.at(at).enclose(bits).is_accurate(100));
  CHECK(Roll().is_zero());
  CHECK(Roll().at(at).exact() == Rational(0));
}

}  // namespace roll_test
