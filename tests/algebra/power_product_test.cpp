#include "phrame/algebra/power_product.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

using Powers = std::vector<Power>;

Power size(const Rational& base, const Rational& exponent) { return {{base, 0}, exponent}; }
Power turn(long re, long im, const Rational& exponent) { return {{re, im}, exponent}; }

GaussianRational power(const GaussianRational& base, long exponent) {
  GaussianRational result{1, 0};
  for (long k = 0; k < exponent; ++k) result = result * base;
  return result;
}

}  // namespace

TEST_CASE("power product: 8^(1/3)·(1/4)^(1/2) and 6²·2^(−2)·3^(−2) are 1, 2^a·3^b is not") {
  CHECK(sizes_cancel({size(8, Rational(1, 3)), size(Rational(1, 4), Rational(1, 2))}));
  CHECK(sizes_cancel({size(-6, 2), size(2, -2), size(3, -2)}));
  CHECK(sizes_cancel({}));
  CHECK(sizes_cancel({size(5, 0), size(-1, 7)}));
  CHECK_FALSE(sizes_cancel({size(2, 19), size(3, -12)}));
  // With exponents whose powers no memory holds.
  const Rational huge = pow(Integer(10), 40);
  CHECK(sizes_cancel({size(12, huge), size(3, -huge), size(2, -2 * huge)}));
  CHECK_FALSE(sizes_cancel({size(12, huge), size(3, -huge), size(2, 1 - 2 * huge)}));
}

// Machin: 4·arctan(1/5) − arctan(1/239) = π/4. Euler: arctan(1/2) + arctan(1/3) = π/4. Gauss: 12
// arctan(1/18) + 8 arctan(1/57) − 5 arctan(1/239) = π/4.
TEST_CASE("power product: arctangents that add up to a rational multiple of pi") {
  CHECK(turns_are_rational({turn(5, 1, 4), turn(239, 1, -1)}));
  CHECK(turns_are_rational({turn(2, 1, 1), turn(3, 1, 1)}));
  CHECK(turns_are_rational({turn(18, 1, 12), turn(57, 1, 8), turn(239, 1, -5)}));
  CHECK_FALSE(turns_are_rational({turn(18, 1, 12), turn(57, 1, 8), turn(239, 1, -4)}));
  CHECK_FALSE(turns_are_rational({turn(2, 1, 1)}));
  CHECK(turns_are_rational({turn(1, 1, Rational(1, 3)), turn(0, 2, 5), turn(-7, 0, 1)}));
  CHECK(turns_are_rational({turn(2, 1, Rational(1, 7)), turn(2, -1, Rational(1, 7))}));
  CHECK(turns_are_rational({turn(4, 2, 1), turn(3, -4, Rational(1, 2)), turn(5, 5, 1)}));
  const Rational huge = pow(Integer(10), 40);
  CHECK_FALSE(turns_are_rational({turn(2, 1, huge)}));
}

TEST_CASE("power product: a base 0 is refused") {
  CHECK_THROWS_AS(sizes_cancel({size(0, -1)}), DomainError);
  CHECK_THROWS_AS(turns_are_rational({turn(0, 0, 1)}), DomainError);
}

// A product that is computed, on one of eight rays or not.
TEST_CASE("power product: law: a turn is rational iff the product lies on a ray") {
  for_samples(200, [](Random& random) {
    Powers powers;
    GaussianRational product{1, 0};
    for (long k = random.integer(1, 4); k > 0; --k) {
      const GaussianRational z{random.integer(-6, 6), random.integer(-6, 6)};
      if (z.re == 0 && z.im == 0) continue;
      const long exponent = random.integer(1, 4);
      powers.push_back({z, exponent});
      product = product * power(z, exponent);
    }
    const auto& [x, y] = product;
    const bool is_on_ray = x == 0 || y == 0 || abs(x) == abs(y);
    CHECK(turns_are_rational(powers) == is_on_ray);
    powers.push_back({product, -1});
    CHECK(turns_are_rational(powers));
    const Rational size = x * x + y * y;
    Powers sizes{{{size, 0}, -1}};
    for (const Power& p : powers)
      if (!(p.base == product))
        sizes.push_back({{p.base.re * p.base.re + p.base.im * p.base.im, 0}, p.exponent});
    if (sizes.size() == powers.size()) CHECK(sizes_cancel(sizes));
  });
}
