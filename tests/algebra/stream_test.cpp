// What operator<< prints of numbers.
#include <doctest/doctest.h>

#include <sstream>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/algebra/rational_function.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/rounding.hpp"

using namespace phrame;

namespace {

template <class T>
std::string printed(const T& x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

}  // namespace

TEST_CASE("<<: integers, fractions and decimals as they are written") {
  CHECK(printed(Integer(-12)) == "-12");
  CHECK(printed(Rational(-6, 14)) == "-3/7");
  CHECK(printed(round_to_decimal(Rational(1, 3), 4)) == "0.3333");
}

TEST_CASE("<<: complex numbers without what is 0 or 1") {
  const Rational half(1, 2);
  CHECK(printed(GaussianRational{0, 0}) == "0");
  CHECK(printed(GaussianRational{half, 0}) == "1/2");
  CHECK(printed(GaussianRational{half, -3}) == "1/2 - 3*i");
  CHECK(printed(GaussianRational{-2, half}) == "-2 + 1/2*i");
  CHECK(printed(GaussianRational{0, -1}) == "-i");
  CHECK(printed(GaussianRational{0, half}) == "1/2*i");
  CHECK(printed(GaussianInteger{2, 1}) == "2 + i");
}

TEST_CASE("<<: polynomials and their quotients") {
  const Polynomial p{-1, 0, 1};
  CHECK(printed(p) == "t^2 - 1");
  CHECK(printed(RationalFunction(p, Polynomial{3, 1})) == "(t^2 - 1)/(t + 3)");
  CHECK(printed(RationalFunction(Polynomial{-2}, Polynomial{3, 1})) == "-2/(t + 3)");
  CHECK(printed(RationalFunction(Polynomial{Rational(1, 2)}, p)) == "(1/2)/(t^2 - 1)");
  CHECK(printed(RationalFunction(p)) == "t^2 - 1");
  CHECK(printed(RationalFunction()) == "0");
  CHECK(printed(GaussianPolynomial{p, Polynomial{0, 2}}) == "(t^2 - 1) + (2*t)*i");
}

TEST_CASE("<<: angles and intervals") {
  CHECK(printed(Angle(Rational(1, 4), Rational(1, 3))) == "1/3 + pi/4");
  CHECK(printed(closed_interval(0, Rational(1, 2))) == "[0, 1/2]");
}

TEST_CASE("<<: a ball by digits and a bound of what they are off") {
  CHECK(printed(RealBall()) == "0");
  // 1/3 − 0.333333333333333 = 10⁻¹⁵/3, rounded up.
  CHECK(printed(RealBall(Rational(1, 3), 64)) == "[0.333333333333333 +/- 3.34e-16]");
  // π = 3.14159265358979323846…
  CHECK(printed(pi(64)) == "[3.14159265358979 +/- 3.24e-15]");
  const std::string third = printed(RealBall(Rational(1, 3), 64));
  CHECK(printed(ComplexBall(RealBall(), RealBall(Rational(1, 3), 64))) == "0 + " + third + "*i");
}

TEST_CASE("<<: a real number exactly where it is exact, else as a ball") {
  CHECK(printed(Real(Rational(1, 3))) == "1/3");
  CHECK(printed(to_real(Angle(1, 0))) == printed(pi(72)));
}

TEST_CASE("<<: a real algebraic number by its polynomial and its interval") {
  CHECK(printed(RealAlgebraic(Rational(1, 2))) == "1/2");
  const RealAlgebraic root = real_root(Polynomial{-2, 0, 1}, closed_interval(1, 2));
  CHECK(printed(root) == "root of t^2 - 2 in " + to_string(root.interval()));
}
