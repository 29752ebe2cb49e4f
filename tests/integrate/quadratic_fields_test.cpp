#include "phrame/integrate/quadratic_fields.hpp"

#include "support/random.hpp"

namespace quadratic_fields_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// x·y in fields of square roots.
Surd product(const Surd& x, const Surd& y) {
  Surd result;
  for (const auto& [d, a] : x.terms())
    for (const auto& [e, b] : y.terms()) {
      const RootProduct root = multiply_roots(d, e);
      result.add(a * b * Rational(root.factor), root.radicand);
    }
  return result;
}

/// The fractions over the common denominator d: Σ (αt + β)·∏ of the others' t² + pt + q at t, and
/// ∏ of all.
std::pair<Surd, Surd> sum_at(const std::vector<QuadraticFraction>& parts, const Rational& t) {
  Surd numerator;
  Surd denominator = Rational(1);
  for (const QuadraticFraction& f : parts) {
    const Surd below = Surd(t * t) + t * f.p + f.q;
    numerator = product(numerator, below) + product(denominator, t * f.alpha + f.beta);
    denominator = product(denominator, below);
  }
  return {numerator, denominator};
}

void check_sum(const SimpleFraction& f, std::size_t count) {
  const auto parts = over_real_quadratic_fields(f);
  REQUIRE(parts.size() == count);
  for (const Rational t : {-5, -4, -3, -2, 2, 3, 4, 5, 7}) {  // more than the degrees of all
    const auto [numerator, denominator] = sum_at(parts, t);
    CHECK(evaluate(f.denominator, t) * numerator == evaluate(f.numerator, t) * denominator);
  }
}

}  // namespace

TEST_CASE("quadratic fields: 1/(t⁴ + 1), as every textbook has it") {
  const auto parts = over_real_quadratic_fields({{1}, {1, 0, 0, 0, 1}});
  REQUIRE(parts.size() == 2);
  for (const QuadraticFraction& f : parts) {  // (±√2/4·t + 1/2)/(t² ± √2t + 1)
    CHECK(f.beta == Surd(Rational(1, 2)));
    CHECK(f.q == Surd(Rational(1)));
    CHECK((f.p == Surd(0, 1, 2) || f.p == Surd(0, -1, 2)));
    CHECK(f.alpha == Rational(1, 4) * f.p);
  }
  CHECK_FALSE(parts[0].p == parts[1].p);
}

TEST_CASE("quadratic fields: law: the parts add up to the fraction") {
  check_sum({{2, -1, 3, 5}, {1, 0, 0, 0, 1}}, 2);
  check_sum({{1, 2, 3, 4, 5, 6, 7, 8}, {1, 0, 0, 0, -1, 0, 0, 0, 1}}, 4);  // 24th roots of unity
  // (t² + pt + q)(t² + p̄t + q̄) with p = a + b√d, q = e + g√d, both without real zeros.
  for_samples(20, [](Random& random) {
    const Rational d(std::array<long, 3>{2, 3, 5}[static_cast<std::size_t>(random.integer(0, 2))]);
    const Rational a(random.integer(-3, 3));
    const Rational b(random.integer(1, 3));
    const Rational e(random.integer(40, 60));
    const Rational g(random.integer(-3, 3));
    const Polynomial denominator{e * e - d * g * g, 2 * (a * e - d * b * g),
                                 2 * e + a * a - d * b * b, 2 * a, 1};
    const Polynomial numerator{random.integer(-9, 9), random.integer(-9, 9), random.integer(1, 9)};
    check_sum({numerator, denominator}, 2);
  });
}

TEST_CASE("quadratic fields: none where the poles are in a field of another kind") {
  // The Galois group of t⁴ + t + 1 is S₄, as its cubic resolvent t³ − 4t − 1 is irreducible and its
  // discriminant 229 no square.
  CHECK(over_real_quadratic_fields({{1}, {1, 1, 0, 0, 1}}).empty());
  // cos(π/8) is in no biquadratic field.
  CHECK(over_real_quadratic_fields({{1, 1}, {1, 0, 0, 0, 0, 0, 0, 0, 1}}).empty());
}

}  // namespace quadratic_fields_test
