#include "phrame/ph/curve/disc_function.hpp"

#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 100;
constexpr long length = 12;

/// A polynomial as a DiscFunction, cut after `length` coefficients.
DiscFunction disc_function(const Polynomial& p) {
  RealBall bound;
  RealBall power(1, bits);
  for (long k = 0; k <= p.degree(); ++k) {
    bound = add_product(bound, RealBall(abs(p.coefficient(k)), bits), power, bits);
    power = multiply(power, RealBall(outer_radius, bits), bits);
  }
  return {BallPolynomial(p % Polynomial::monomial(1, length), bits), bound, length, bits};
}

/// Of a complex number on |z| ≤ radius.
ComplexBall inner_point(Random& random, long radius) {
  const auto part = [&] { return RealBall(Rational(random.integer(-7, 7) * radius, 10), bits); };
  return {part(), part()};
}

const std::vector<long> radii{inner_radius, least_radius};

bool is_between(const ComplexBall& value, const RealBall& lower, const RealBall& upper) {
  const RealBall size = absolute(value, bits);
  return !is_less(size, lower) && !is_less(upper, size);
}

}  // namespace

TEST_CASE("disc function: law: the values on |z| ≤ 4, or 2, are within the bounds") {
  for_samples(200, [](Random& random) {
    const Polynomial p = random.polynomial(20);
    const Polynomial q = random.polynomial(3);
    const Polynomial all = p * q - q * q + p;
    const DiscFunction f = disc_function(p);
    const DiscFunction g = disc_function(q);
    const DiscFunction h = f * g - g * g + constant_like(f, 1) * f;
    for (const long radius : radii) {
      const SizeBounds size = size_bounds(h, radius);
      const ComplexBall z = inner_point(random, radius);
      CHECK(is_between(evaluate(all, z, bits), size.lower, size.upper));
    }
    for (long k = 0; k < length; ++k) CHECK(h.series.coefficient(k).contains(all.coefficient(k)));
  });
}

TEST_CASE("disc function: a zero in |z| ≤ 4 is never overlooked, and 1 + z/8 has none") {
  CHECK(sign(size_bounds(disc_function(Polynomial{1, Rational(1, 8)})).lower) > 0);
  CHECK(sign(size_bounds(disc_function(Polynomial{1, Rational(1, 4)})).lower) <= 0);
  // z²⁰/4²⁰ − 1 has one, of which the coefficients say nothing.
  const Polynomial far = Polynomial{-1} + Polynomial::monomial(Rational(1, Integer(1) << 40U), 20);
  CHECK(sign(size_bounds(disc_function(far)).lower) <= 0);
  // It is not in |z| ≤ 2; that of z²⁰/2²⁰ − 1 is.
  CHECK(sign(size_bounds(disc_function(far), least_radius).lower) > 0);
  const Polynomial near = Polynomial{-1} + Polynomial::monomial(Rational(1, 1L << 20), 20);
  CHECK(sign(size_bounds(disc_function(near), least_radius).lower) <= 0);
}

TEST_CASE("disc function: law: products with powers of factors multiply back, within the bound") {
  for_samples(50, [](Random& random) {
    const Polynomial n = random.polynomial(3);
    const Polynomial p{random.integer(30, 60), random.integer(-3, 3), 1};
    const Polynomial q{random.integer(9, 12), random.integer(-1, 1)};
    const int i = static_cast<int>(random.integer(-5, 5));
    const int j = static_cast<int>(random.integer(-5, 5));
    const DiscProduct product{disc_function(n), {{disc_function(p), i}, {disc_function(q), j}}};
    const BallPolynomial y = series(product);
    // y²·p⁻ⁱ·q⁻ʲ = n².
    const auto times = [](BallPolynomial of, const Polynomial& factor, int k) {
      const BallPolynomial f(factor, bits);
      for (int m = 0; m < std::abs(k); ++m)
        of = k > 0 ? divide_series(of, f, length, bits) : multiply_series(of, f, length, bits);
      return of;
    };
    const BallPolynomial square = times(times(multiply_series(y, y, length, bits), p, i), q, j);
    for (long k = 0; k < length; ++k) CHECK(square.coefficient(k).contains((n * n).coefficient(k)));
    CHECK(sign(RealBall(n.coefficient(0), bits)) == sign(y.coefficient(0)));
    for (const long radius : radii) {
      const auto bound = bound_on_inner_disc(product, radius);
      REQUIRE(bound);
      const ComplexBall z = inner_point(random, radius);
      RealBall size = absolute(evaluate(n, z, bits), bits);
      const auto scaled = [&](const Polynomial& factor, int k) {
        const RealBall root = sqrt(absolute(evaluate(factor, z, bits), bits), bits);
        for (int m = 0; m < std::abs(k); ++m)
          size = k > 0 ? multiply(size, root, bits) : divide(size, root, bits);
      };
      scaled(p, i);
      scaled(q, j);
      CHECK_FALSE(is_less(*bound, size));
    }
  });
}

TEST_CASE("disc function: with a zero of a factor there is no bound") {
  const DiscFunction one = disc_function(Polynomial{1});
  CHECK_FALSE(bound_on_inner_disc({one, {{disc_function(Polynomial{1, 1}), 1}}}));
  CHECK_FALSE(bound_on_inner_disc({one, {{disc_function(Polynomial{}), -2}}}));
  CHECK(bound_on_inner_disc({one, {}}));
  const DiscProduct three{one, {{disc_function(Polynomial{3, 1}), -1}}};  // a pole at −3
  CHECK_FALSE(bound_on_inner_disc(three));
  CHECK(bound_on_inner_disc(three, least_radius));
  // |√(1 + z)| ≤ √5 on |z| ≤ 4, though 1 + z has a zero; 1/√ has no bound.
  const auto root = bound_with_zeros({one, {{disc_function(Polynomial{1, 1}), 1}}});
  REQUIRE(root);
  CHECK(root->upper() >= Rational(2236, 1000));
  CHECK(root->lower() <= Rational(23, 10));
  CHECK_FALSE(bound_with_zeros({one, {{disc_function(Polynomial{1, 1}), -1}}}));
}

TEST_CASE("disc function: law: what may not gain by more coefficients has no bound with them") {
  long hopeless = 0;
  for_samples(200, [&](Random& random) {
    const Polynomial p = random.polynomial(20) + Polynomial{random.integer(-2000, 2000)};
    const DiscFunction few = disc_function(p);
    DiscFunction all{BallPolynomial(p, bits), few.bound, 60, bits};
    const bool has_bound = sign(size_bounds(all).lower) > 0;
    if (!size_bounds(few).may_gain) ++hopeless;
    if (has_bound) CHECK(size_bounds(few).may_gain);
  });
  CHECK(hopeless > 10);
  CHECK(hopeless < 200);
}
