#include "phrame/integrate/pole_change.hpp"

#include "phrame/algebra/ball_log.hpp"
#include "phrame/integrate/antiderivative.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

namespace pole_change_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 100;

RationalFunction function(const FactoredFunction& f) {
  Polynomial d{1};
  for (const auto& [base, exponent] : f.denominator) d *= pow(base.polynomial(), exponent);
  return {f.numerator, d};
}

}  // namespace

TEST_CASE("pole change: its parts are those of Hermite's reduction and of its logarithms") {
  long told = 0;
  for_samples(20, [&](Random& random) {
    // t² + bt + c with c > b²/4 has no real zero, and one of t ± k is not in [0, 1].
    const auto base = [&] {
      const long b = random.integer(-9, 9);
      return Polynomial{b * b + random.integer(1, 9), 2 * b, 1};
    };
    const Polynomial real = random.chance(2) ? Polynomial{random.integer(1, 9), 1}
                                             : Polynomial{-random.integer(2, 9), 1};
    const FactoredFunction f{
        random.polynomial(16),
        {{Rational(2) * base(), 3}, {real * base(), 2}, {Polynomial{random.integer(1, 5)}, 1}}};
    const auto change = pole_change(f, bits);
    if (!change) return;
    ++told;
    const RationalFunction rate = function(f);
    const Antiderivative F = integrate(rate);
    CHECK(change->rational.contains(difference_without_logarithms(F, 0, 1)));
    const Real whole = definite_integral(F, rate, Rational(0), Rational(1), AtPoles::refuse).value;
    CHECK(change->whole(bits).overlaps(whole.enclose(bits)));
    CHECK(change->whole(bits).is_accurate(bits - 2));
  });
  CHECK(told >= 15);
}

TEST_CASE("pole change: 4t³/(t + 1) = 4t² − 4t + 4 − 4/(t + 1)") {
  const auto change = pole_change({{0, 0, 0, 4}, {{Polynomial{1, 1}, 1}}}, bits);
  REQUIRE(change);
  CHECK(change->rational.contains(Rational(4, 3) - 2 + 4));
  CHECK(
      change->logarithm.overlaps(multiply(RealBall(-4, bits), log(RealBall(2, bits), bits), bits)));
  CHECK(change->whole(bits).is_accurate(bits - 2));
}

TEST_CASE("pole change: where nothing is left of the poles there is no logarithm") {
  // (t + 2)²·6t/(t + 2)² = 6t, not in lowest terms.
  const auto change = pole_change({{0, 24, 24, 6}, {{Polynomial{2, 1}, 2}}}, bits);
  REQUIRE(change);
  CHECK(change->rational.contains(3));
  CHECK(change->logarithm.contains_zero());
  CHECK(change->logarithm.radius() < Rational(1, 1'000'000'000));
  const auto zero = pole_change({{}, {{Polynomial{2, 1}, 2}}}, bits);
  REQUIRE(zero);
  CHECK(zero->rational.is_zero());
}

TEST_CASE("pole change: no value at poles that are multiple, in common or on the path") {
  const Polynomial p{2, 1};
  const Polynomial q{3, 0, 1};
  const Polynomial n{1, 7};
  CHECK(pole_change({n, {{p, 4}, {q, 2}}}, bits));
  CHECK_FALSE(pole_change({n, {{p * p, 2}, {q, 2}}}, bits));
  CHECK_FALSE(pole_change({n, {{p * q, 1}, {q, 1}}}, bits));
  for (const Polynomial& on_path : {Polynomial{0, 1}, Polynomial{-1, 1}, Polynomial{-1, 0, 2}})
    CHECK_FALSE(pole_change({n, {{on_path, 1}, {q, 1}}}, bits));
}

TEST_CASE("pole change: the zeros of a base are found once for its copies, and narrowed") {
  const PoleBase base(Polynomial{3, 1, 0, 1, 2});
  const PoleBase copy = base;
  const auto roots = base.roots(80);
  REQUIRE(roots);
  CHECK(copy.roots(64) == roots);
  const auto narrow = copy.roots(300);
  for (const ComplexBall& z : narrow->upper) CHECK(z.accuracy_bits() >= 300);
  CHECK(base.roots(200) == narrow);
  CHECK(PoleBase(Polynomial{5}).roots(64)->upper.empty());
  CHECK_FALSE(PoleBase(Polynomial{1, 2, 1}).roots(64));
}

}  // namespace pole_change_test
