#include "phrame/integrate/taylor_integral.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/numerical_integral.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// By Gauss's and Legendre's rule.
RealBall by_quadrature(const RootQuotient& f, const Rational& t, long bits) {
  const auto integrand = [&f](const ComplexBall& z, long precision) {
    const ComplexBall root = integrand_sqrt(evaluate(f.radicand, z, precision), precision);
    return divide(evaluate(f.numerator, z, precision),
                  multiply(evaluate(f.denominator, z, precision), root, precision), precision);
  };
  return numerical_integral(integrand, RealBall(), RealBall(t, bits + 30),
                            {bits, 3 * bits, 1000000});
}

void check_against_quadrature(const RootQuotient& f, long bits) {
  const TaylorIntegral F(f);
  for (const Rational& t : {Rational(1, 3), Rational(1)}) {
    CAPTURE(t);
    const RealBall value = F.enclose(t, bits);
    const RealBall other = by_quadrature(f, t, bits);
    CHECK(value.overlaps(other));
    CHECK(value.is_accurate(bits - 10));
    CHECK(other.is_accurate(bits - 20));
  }
}

/// > 0 on [0, 1], with roots that may be close to it.
Polynomial positive(test::Random& random, long factors) {
  Polynomial product{Rational(random.integer(1, 9), random.integer(1, 9))};
  for (long k = 0; k < factors; ++k) {
    const Rational re(random.integer(-8, 16), 8);
    const Rational im(random.integer(1, 20), random.integer(1, 30));
    product *= Polynomial{re * re + im * im, -2 * re, 1};
  }
  return product;
}

}  // namespace

TEST_CASE("Taylor integral: ∫ dt/√(1 + t²) = arsinh t, ∫ √(1 + t²) dt, ∫ dt/(1 + t²) = arctan t") {
  const Polynomial s{1, 0, 1};
  // mpmath: asinh(1), (asinh(1) + sqrt(2))/2.
  CHECK(round_to_decimal(TaylorIntegral({{1}, {1}, s}).value(1), 50).value ==
        "0.88137358701954302523260932497979230902816032826164");
  CHECK(round_to_decimal(TaylorIntegral({s, {1}, s}).value(1), 50).value ==
        "1.1477935746963190370171490245947451937989161018193");
  CHECK(TaylorIntegral({{4}, s}).enclose(Rational(1), 1000).overlaps(pi(1000)));
  CHECK(TaylorIntegral({{4}, s}).enclose(Rational(1), 1000).is_accurate(990));
}

TEST_CASE("Taylor integral: where S is a square it is that of a rational function") {
  const Polynomial g{Rational(-3), 1};  // < 0
  const TaylorIntegral F({g, {1}, g * g});
  CHECK(F.value(Rational(1, 3)).exact() == Rational(-1, 3));
  CHECK(TaylorIntegral({{}, {1}, {5, 1}}).value(1).exact() == Rational(0));
  CHECK(TaylorIntegral({Polynomial{0, 2}, {3}, {4}}).value(1).exact() == Rational(1, 6));
}

TEST_CASE("Taylor integral: what it is not defined for is refused") {
  CHECK_THROWS_AS(TaylorIntegral({{1}, {1}, {-1, 1}}), DomainError);
  CHECK_THROWS_AS(TaylorIntegral({{1}, {1}, {-1, -1}}), DomainError);
  CHECK_THROWS_AS(TaylorIntegral({{1}, {-1, 2}, {1}}), DomainError);
  CHECK_THROWS_AS(TaylorIntegral({{1}, {1}, {}}), DomainError);
  CHECK_THROWS_AS(TaylorIntegral({{1}, {1}, {1, 1}}).value(2), DomainError);
  // A zero that cancels is no matter.
  CHECK(TaylorIntegral({{-1, 2}, {-1, 2}, {4}}).value(1).exact() == Rational(1, 2));
}

TEST_CASE("Taylor integral: as Arb's quadrature") {
  test::Random random(20260);
  for (long k = 0; k < 4 * test::multiplier(); ++k) {
    const RootQuotient f{random.nonzero_polynomial(6), positive(random, random.integer(0, 4)),
                         positive(random, random.integer(0, 2))};
    CAPTURE(f.numerator);
    CAPTURE(f.denominator);
    CAPTURE(f.radicand);
    check_against_quadrature(f, 80);
  }
}

TEST_CASE("Taylor integral: next to a singularity, ∫ dt/√((t − a)² + e²) [arsinh]") {
  // mpmath: asinh((1-a)/e) + asinh(a/e) for a = 1/3, e = 1e-12.
  const Rational a(1, 3);
  const Rational e = power_of_ten(-12);
  const TaylorIntegral F({{1}, {1}, {a * a + e * e, -2 * a, 1}});
  CHECK(round_to_decimal(F.value(1), 30).value == "55.1442591962007129618930036155");
}

TEST_CASE("Taylor integral: F on a ball holds F on it, and F′ is the rate") {
  const TaylorIntegral F({{1, -2, 5}, {3, 1}, {1, -1, 1}});
  const RealBall wide = hull(Rational(2, 5), Rational(3, 5), 100);
  const RealBall there = F.enclose(wide, 100);
  for (const Rational& t : {Rational(2, 5), Rational(1, 2), Rational(3, 5)})
    CHECK(there.overlaps(F.enclose(t, 100)));
  const Rational h = power_of_two(-40);
  const RealBall step = subtract(F.enclose(Rational(Rational(1, 3) + h), 200),
                                 F.enclose(Rational(Rational(1, 3) - h), 200), 200);
  const RealBall slope = times_power_of_two(step, 39);
  CHECK(absolute(subtract(slope, F.rate(RealBall(Rational(1, 3), 200), 200), 200)).upper() <
        power_of_two(-60));
}

TEST_CASE("Taylor integral: huge and small coefficients change the scale only") {
  const Rational huge = power_of_ten(1000);
  const TaylorIntegral F({{1}, {1}, {1, 0, 1}});
  const TaylorIntegral G({{huge}, {1}, {1, 0, 1}});
  const TaylorIntegral H({{1}, {1}, {huge, 0, huge}});
  const RealBall f = F.enclose(Rational(1), 100);
  const RealBall g = G.enclose(Rational(1), 100);
  CHECK(g.accuracy_bits() > 90);
  CHECK(g.overlaps(multiply(RealBall(huge, 120), f, 120)));
  const RealBall h = H.enclose(Rational(1), 100);
  CHECK(h.accuracy_bits() > 90);
  CHECK(multiply(h, RealBall(power_of_ten(500), 120), 120).overlaps(f));
}
