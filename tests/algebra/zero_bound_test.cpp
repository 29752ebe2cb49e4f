#include "phrame/algebra/zero_bound.hpp"

#include "support/random.hpp"

namespace zero_bound_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// A number by enclosures, and the bound that it has as it was made.
struct Number {
  Real value;
  ZeroBound bound;
};

Number number(const Rational& x) { return {x, zero_bound(x)}; }
Number number(const RealAlgebraic& x) { return {to_real(x), zero_bound(x)}; }
Number root(const Rational& x) { return {square_root_of(x), of_square_root(zero_bound(x))}; }
Number operator+(const Number& x, const Number& y) {
  return {x.value + y.value, of_sum(x.bound, y.bound)};
}
Number operator*(const Number& x, const Number& y) {
  return {x.value * y.value, of_product(x.bound, y.bound)};
}
Number operator-(const Number& x) { return {-x.value, x.bound}; }

Rational fraction(Random& random) { return {random.integer(1, 999), random.integer(1, 50)}; }

std::optional<Rational> exact(const Number& x) { return settled(x.value, x.bound).exact(); }

}  // namespace

TEST_CASE("zero bound: √2·√2 = 2, and √2 + √3 − √(5 + 2√6) is 0") {
  CHECK(exact(root(2) * root(2)) == Rational(2));
  CHECK(exact(root(2) * root(3)) == std::nullopt);
  CHECK(settled((root(2) * root(3)).value, (root(2) * root(3)).bound).origin().is_irrational);
  const Number sum = root(2) + root(3);
  CHECK(exact(sum * sum + -(number(2) * root(6))) == Rational(5));
  CHECK(decided_sign((sum * sum + -number(5) + -(root(24))).value,
                     (sum * sum + -number(5) + -(root(24))).bound) == 0);
}

TEST_CASE("zero bound: the roots of a cubic have the sum and the product of Vieta") {
  const Polynomial cubic{1, -3, 0, 1};  // 2·cos 40°, 2·cos 80°, −2·cos 20°
  const auto roots = real_roots(cubic, {std::nullopt, std::nullopt});
  REQUIRE(roots.size() == 3);
  const Number a = number(roots[0].at), b = number(roots[1].at), c = number(roots[2].at);
  CHECK(exact(a + b + c) == Rational(0));
  CHECK(exact(a * b * c) == Rational(-1));
  CHECK(exact(a * b + b * c + c * a) == Rational(-3));
  CHECK(exact(a + b) == std::nullopt);
}

TEST_CASE("zero bound: (√a + √b)² less its irrational part is a + b, and near it is not") {
  for_samples(20, [](Random& random) {
    const Rational a = fraction(random);
    const Rational b = fraction(random);
    const Number sum = root(a) + root(b);
    const Number rest = sum * sum + -(number(2) * root(Rational(a * b)));
    CHECK(exact(rest) == Rational(a + b));
    const Number near = rest + number(power_of_two(-300));
    CHECK(exact(near) == Rational(a + b + power_of_two(-300)));
    CHECK(decided_sign((near + -number(a + b)).value, (near + -number(a + b)).bound) == 1);
  });
}

TEST_CASE("zero bound: no number but 0 is below it") {
  for_samples(30, [](Random& random) {
    const Number x = root(fraction(random)) + -root(fraction(random)) + -number(fraction(random));
    const Real value = settled(x.value, x.bound);
    if (value.exact() == Rational(0)) return;
    const RealBall ball = value.enclose(x.bound.bits() + 64);
    CHECK(absolute(ball).lower() >= power_of_two(-x.bound.bits()));
  });
  // √(n² + 1) − n is about 1/(2n).
  const Integer n = pow(Integer(10), 50);
  const Number small = root(Rational(Integer(n * n + 1))) + -number(Rational(n));
  CHECK(decided_sign(small.value, small.bound) == 1);
  CHECK(decided_floor(small.value) == Integer(0));
  CHECK(decided_floor((-small).value) == Integer(-1));
}

TEST_CASE("zero bound: of a number that may be transcendental nothing is claimed") {
  const Real pi_value([](long bits) { return pi(bits); });
  CHECK(!settled(pi_value, {}).exact());
  CHECK(decided_sign(pi_value + -pi_value, {}) == std::nullopt);
  CHECK(decided_floor(pi_value) == Integer(3));
  CHECK(!of_sum(zero_bound(Rational(1)), {}).is_known());
  CHECK(!of_product({}, zero_bound(Rational(1))).is_known());
  CHECK(!of_square_root({}).is_known());
  ZeroBound many = zero_bound(real_root({-2, 0, 1}, closed_interval(1, 2)));
  for (int k = 0; k < 40; ++k) many = of_sum(many, many);
  CHECK(!many.is_known());  // and no overflow
}

}  // namespace zero_bound_test
