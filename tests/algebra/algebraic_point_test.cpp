#include "phrame/algebra/algebraic_point.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// √2, ∛2, …
AlgebraicPoint root_of_two(long k) {
  return AlgebraicPoint(
      real_root(Polynomial::monomial(1, k) - Polynomial{2}, {Rational(0), std::nullopt}));
}

}  // namespace

TEST_CASE("algebraic point: a value is exact where it is rational, and only there") {
  const AlgebraicPoint t = root_of_two(2);
  CHECK(t.value(Polynomial{1, 0, 3}).exact() == 7);
  CHECK(t.value(Polynomial{0, 1, 0, Rational(-1, 2)}).exact() == 0);
  CHECK_FALSE(t.value(Polynomial{0, 1}).exact().has_value());
  // (t³ + t² + 2)/(t + 2) = (2t + 4)/(t + 2)
  CHECK(t.value(RationalFunction({2, 0, 1, 1}, {2, 1})).exact() == 2);
  CHECK_FALSE(t.value(RationalFunction({2, 0, 1, 1}, {3, 1})).exact().has_value());
  CHECK(t.value(Polynomial{}).exact() == 0);
  CHECK(AlgebraicPoint(Rational(1, 2)).value(RationalFunction({1}, {0, 0, 1})).exact() == 4);
}

TEST_CASE("algebraic point: a square root is exact where it is rational") {
  const AlgebraicPoint t = root_of_two(4);
  CHECK(t.square_root(RationalFunction({0, 0, 0, 0, 2}, {1})).exact() == 2);  // √(2t⁴)
  CHECK(t.square_root(RationalFunction()).exact() == 0);
  const RealBall root = t.square_root(RationalFunction({0, 0, 1}, {1})).enclose(200);
  CHECK(root.overlaps(t.enclose(200)));  // √(t²) = t
  CHECK(root.radius() < parse_rational("1e-50"));
  CHECK(t.square_root(RationalFunction({1, 0, 0, 0, 1}, {1}))
            .enclose(100)
            .overlaps(sqrt(RealBall(3, 100), 100)));
}

// The numbers with digits are mpmath's.
TEST_CASE("algebraic point: n/(d√s) is exact where it is rational, and has the sign of n") {
  const AlgebraicPoint t = root_of_two(2);
  const Polynomial x{0, 1};
  const Polynomial one{1};
  CHECK(t.over_square_root(x, one, {2}).exact() == 1);
  CHECK(t.over_square_root({0, -3}, x * x, {8}).exact() == Rational(-3, 4));
  CHECK(t.over_square_root({4, 0, -2}, one, {3}).exact() == 0);
  CHECK(t.over_square_root({}, one, {3}).exact() == 0);
  const Real great = t.over_square_root({1, 1}, one, {3});
  CHECK_FALSE(great.exact().has_value());
  CHECK(round_to_decimal(great, 40).value == "1.393846850117351797241576805403921252970");
  CHECK(round_to_decimal(t.over_square_root({1, -1}, x, {1, 1}), 40).value ==
        "-0.1885043923433552834310856795957412393040");
  CHECK(AlgebraicPoint(Rational(-2)).over_square_root(x, {3}, {4}).exact() == Rational(-1, 3));
}

TEST_CASE("algebraic point: poles and roots of negative numbers are refused") {
  const AlgebraicPoint t = root_of_two(2);
  CHECK_THROWS_WITH_AS(t.value(RationalFunction({1}, {-2, 0, 1})), doctest::Contains("pole"),
                       DomainError);
  CHECK_THROWS_AS(AlgebraicPoint(Rational(1)).value(RationalFunction({1}, {-1, 1})), DomainError);
  CHECK_THROWS_AS(t.square_root(RationalFunction({0, -1}, {1})), DomainError);
  CHECK_THROWS_AS(t.square_root(RationalFunction({0, 0, -1}, {1})), DomainError);
}

TEST_CASE("algebraic point: law: values are those of balls, at rational points the exact ones") {
  for_samples(60, [](Random& random) {
    const RationalFunction f(random.polynomial(5), random.nonzero_polynomial(4));
    const AlgebraicPoint t = root_of_two(random.integer(2, 5));
    const RealBall x = t.enclose(300);
    if (sign_at(f.denominator(), t.number()) != 0)
      CHECK(t.value(f).enclose(100).overlaps(
          divide(evaluate(f.numerator(), x, 300), evaluate(f.denominator(), x, 300), 300)));
    const Rational r = random.rational();
    if (f.denominator()(r) != 0) CHECK(AlgebraicPoint(r).value(f).exact() == f(r));
  });
}
