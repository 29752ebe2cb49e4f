#include "phrame/algebra/error_free.hpp"

#include <cmath>

#include "phrame/algebra/rational.hpp"
#include "support/doubles.hpp"

using namespace phrame;
using test::any_double;
using test::for_samples;
using test::Random;

namespace {

Rational exact(double x) { return exact_rational(x); }
Rational exact(const DoubleDouble& x) { return exact(x.high) + exact(x.low); }

}  // namespace

TEST_CASE("error-free: law: sums and products of doubles are exact, in two doubles") {
  for_samples(2000, [](Random& random) {
    const double a = any_double(random);
    const double b = any_double(random);
    const DoubleDouble sum = two_sum(a, b);
    CHECK(exact(sum) == exact(a) + exact(b));
    CHECK(sum.high == a + b);
    const DoubleDouble product = two_product(split_factor(a), split_factor(b));
    CHECK(exact(product) == exact(a) * exact(b));
    CHECK(product.high == a * b);
    const SplitFactor split = split_factor(a);
    CHECK(exact(split.high) + exact(split.low) == exact(a));
    // Of at most 26 bits each, so that products of halves are exact.
    CHECK(exact(split.high * split.high) == exact(split.high) * exact(split.high));
    CHECK(exact(split.low * split.low) == exact(split.low) * exact(split.low));
  });
}

TEST_CASE("error-free: law: of pairs, up to 2^-102 of what was added") {
  const Rational unit(1, pow(Integer(2), 102));
  for_samples(2000, [&](Random& random) {
    const DoubleDouble a =
        two_product(split_factor(any_double(random)), split_factor(any_double(random)));
    const DoubleDouble b =
        two_product(split_factor(any_double(random)), split_factor(any_double(random)));
    const Rational x = exact(a);
    const Rational y = exact(b);
    CHECK(abs(exact(a + b) - (x + y)) <= unit * (abs(x) + abs(y)));
    CHECK(abs(exact(a - b) - (x - y)) <= unit * (abs(x) + abs(y)));
    CHECK(abs(exact(a * b) - x * y) <= unit * abs(x * y));
  });
}
