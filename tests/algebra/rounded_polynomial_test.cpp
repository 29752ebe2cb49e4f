#include "phrame/algebra/rounded_polynomial.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "phrame/algebra/rounding.hpp"
#include "support/doubles.hpp"

namespace rounded_polynomial_test {

using namespace phrame;
using test::any_double;
using test::for_samples;
using test::Random;

double exactly(const Polynomial& p, double t) { return round_to_double(p(exact_rational(t))); }

Rational power_of_two(long k) {
  const Rational power(pow(Integer(2), static_cast<unsigned long>(std::abs(k))));
  return k < 0 ? Rational(1 / power) : power;
}

TEST_CASE("rounded polynomial: law: the double nearest to the exact value") {
  for_samples(300, [](Random& random) {
    const Polynomial p = random.polynomial(12);
    const RoundedPolynomial rounded(p);
    for (const double t : {any_double(random), std::ldexp(any_double(random), -60), 0.0, 1.0, -2.0})
      CHECK(rounded(t) == exactly(p, t));
  });
}

TEST_CASE("rounded polynomial: law: near its zeros, where nearly all cancels") {
  Polynomial power{1};
  for (int k = 0; k < 9; ++k) power *= Polynomial{-1, 3};
  for (const Polynomial& p : {power, power * Polynomial{-1, 2}, Rational(1, 7) * power}) {
    const RoundedPolynomial rounded(p);
    for_samples(200, [&](Random& random) {
      const double near = 1.0 / 3 + std::ldexp(any_double(random), -100);
      for (const double t : {near, std::nextafter(1.0 / 3, 1.0), 1.0 / 3, 0.5})
        CHECK(rounded(t) == exactly(p, t));
    });
  }
}

TEST_CASE("rounded polynomial: half way between two doubles, and next to that") {
  for (const long k : {-110L, -160L, -700L})
    for (const int sign : {-1, 0, 1})
      for (const Rational& c :
           {Rational(1 + power_of_two(-53)), Rational(1 + 3 * power_of_two(-53))}) {
        const Polynomial p{c, sign * power_of_two(k)};
        for (const double t : {1.0, 0.75, -1.0}) CHECK(RoundedPolynomial(p)(t) == exactly(p, t));
      }
}

TEST_CASE("rounded polynomial: beyond the range in which sums of two doubles tell") {
  const Rational huge = power_of_two(1000);
  const Rational half_way = 1 + power_of_two(-53);
  const Polynomial above =
      Rational(1 / huge) * Polynomial{half_way, power_of_two(-76)};  // by an underflow
  CHECK(RoundedPolynomial(above)(1.0) == exactly(above, 1.0));
  for (const Polynomial& p :
       {huge * Polynomial{1, -1, 3}, Rational(1 / huge) * Polynomial{1, -1, 3},
        Rational(1 / (huge * huge)) * Polynomial{1, 2}, Polynomial{Rational(1 / huge), 0, 1},
        Polynomial::monomial(3, 70) + Polynomial{1, 1}, Polynomial::monomial(1, 64),
        Polynomial{}}) {
    for (const double t : {0x1p-1074, 0x1p-600, 0.3, 1.0, 1.75, -2.0, 2.5, 0x1p10})
      CHECK(RoundedPolynomial(p)(t) == exactly(p, t));
  }
  CHECK(RoundedPolynomial(huge * huge * Polynomial{0, 1})(-1.0) ==
        -std::numeric_limits<double>::infinity());
}

TEST_CASE("rounded polynomial: whatever the rounding mode is, which stays as it was") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for_samples(40, [&](Random& random) {
      const Polynomial p = random.polynomial(12);
      const double t = any_double(random);
      const double expected = exactly(p, t);
      std::fesetround(mode);
      const double found = RoundedPolynomial(p)(t);
      const int mode_now = std::fegetround();
      std::fesetround(FE_TONEAREST);
      CHECK(found == expected);
      CHECK(mode_now == mode);
    });
}

}  // namespace rounded_polynomial_test
