// Exponents of 10⁶ in front of logarithms made a power with millions of digits: 79 seconds.
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "support/random.hpp"

using namespace phrame;

TEST_CASE("large exponents: σ⁻³ over a field in which σ splits") {
  const Polynomial sigma{5, -22, 82};
  const RationalFunction f(Polynomial{900}, pow(sigma, 3));
  const DefiniteIntegral integral = definite_integral(f, Rational(0), Rational(1));
  REQUIRE(integral.exact.has_value());
  CHECK(integral.exact->arctangents.size() == 1);
  CHECK(integral.value.enclose(100).overlaps(quadrature(f, 0, 1, 60)));
}
