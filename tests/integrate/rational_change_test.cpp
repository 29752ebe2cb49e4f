#include "phrame/integrate/rational_change.hpp"

#include "phrame/integrate/antiderivative.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

namespace rational_change_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 100;

RationalFunction fraction(const Polynomial& numerator, const std::vector<PolePower>& denominator) {
  Polynomial d{1};
  for (const auto& [base, exponent] : denominator) d *= pow(base, exponent);
  return {numerator, d};
}

}  // namespace

TEST_CASE("rational change: it is that of Hermite's reduction") {
  long told = 0;
  for_samples(40, [&](Random& random) {
    // t² + bt + c with c > b²/4 has no real zero.
    const auto base = [&] {
      const long b = random.integer(-9, 9);
      return Polynomial{b * b + random.integer(1, 9), 2 * b, 1};
    };
    const std::vector<PolePower> denominator{
        {Rational(2) * base(), 3}, {base() * base(), 2}, {{random.integer(1, 5)}, 1}};
    const RationalFunction f = fraction(random.polynomial(16), denominator);
    const auto change = rational_change(f, denominator, bits);
    if (!change) return;
    ++told;
    CHECK(change->contains(difference_without_logarithms(algebraic_part(f).F, 0, 1)));
    CHECK(change->is_accurate(bits - 2));
  });
  CHECK(told >= 20);
}

TEST_CASE("rational change: a simple pole has none, a polynomial its own") {
  const auto of_pole = rational_change({{0, 0, 0, 4}, {1, 1}}, {{{1, 1}, 1}}, bits);
  // 4t³/(t + 1) = 4t² − 4t + 4 − 4/(t + 1).
  REQUIRE(of_pole);
  CHECK(of_pole->contains(Rational(4, 3) - 2 + 4));
  CHECK(of_pole->is_accurate(bits - 8));
}

TEST_CASE(
    "rational change: no value where the factors are not those of the denominator, or not simple") {
  const Polynomial p{2, 1};
  const Polynomial q{3, 0, 1};
  const RationalFunction f = fraction({1, 7}, {{p, 4}, {q, 2}});
  CHECK(rational_change(f, {{p, 4}, {q, 2}}, bits));
  CHECK_FALSE(rational_change(f, {{p, 4}, {q, 3}}, bits));
  CHECK_FALSE(rational_change(f, {{p, 4}}, bits));
  CHECK_FALSE(rational_change(f, {{p * p, 2}, {q, 2}}, bits));
  CHECK_FALSE(rational_change(f, {{p * p * q, 1}, {p, 2}, {q, 1}}, bits));
}

}  // namespace rational_change_test
