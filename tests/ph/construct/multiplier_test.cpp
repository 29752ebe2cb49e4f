#include "phrame/ph/construct/multiplier.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "support/random.hpp"

namespace phrame::inline v0 {
namespace {

using test::Random;

Vector<Rational> reached(const QuaternionPolynomial& a, const std::vector<Rational>& f) {
  return evaluate(position(Curve(a, from_bernstein(f))), 1);
}

Vector<Rational> vector(Random& random) {
  return {random.rational(), random.rational(), random.rational()};
}

TEST_CASE("multipliers: the displacement is met exactly, the ends are kept where they are to be") {
  int found = 0;
  test::for_samples(60, [&](Random& random) {
    const QuaternionPolynomial a = random.quaternion_polynomial(3);
    const Vector<Rational> wanted = vector(random);
    const auto all = multiplier_with(a, {1}, wanted, MultiplierFreedom::all);
    const auto inner = multiplier_with(a, {1}, wanted, MultiplierFreedom::inner_only);
    if (all) {
      CHECK(all->size() == 3);
      CHECK(reached(a, *all) == wanted);
    }
    if (inner) {
      CHECK(inner->size() == 5);
      CHECK(inner->front() == 1);
      CHECK(inner->back() == 1);
      CHECK(reached(a, *inner) == wanted);
      ++found;
    }
  });
  CHECK(found > 30);
}

TEST_CASE("multipliers: what is met already is met by 1") {
  Random random(1);
  for (int k = 0; k < 20; ++k) {
    const QuaternionPolynomial a = random.quaternion_polynomial(3);
    const Vector<Rational> as_is = evaluate(position(Curve(a)), 1);
    CHECK(multiplier_with(a, {1}, as_is, MultiplierFreedom::all) == std::vector<Rational>(3, 1));
    CHECK(multiplier_with(a, {1}, as_is, MultiplierFreedom::inner_only) ==
          std::vector<Rational>(5, 1));
  }
}

TEST_CASE("multipliers: lines go along themselves, plane curves in their planes, by the least f") {
  const QuaternionPolynomial line{Polynomial{1}, {}, {}, {}};
  // f = 1 + x(B₀ + B₁ + B₂), ∫ f = 1 + x.
  CHECK(multiplier_with(line, {1}, {3, 0, 0}, MultiplierFreedom::all) ==
        std::vector<Rational>(3, 3));
  // 1 + x(B₁ + B₂ + B₃) of degree 4: ∫ = 1 + 3x/5.
  const auto inner = multiplier_with(line, {1}, {4, 0, 0}, MultiplierFreedom::inner_only);
  CHECK(inner == std::vector<Rational>{1, 6, 6, 6, 1});
  CHECK_FALSE(multiplier_with(line, {1}, {3, 1, 0}, MultiplierFreedom::all));
  CHECK_FALSE(multiplier_with(line, {1}, {3, 0, 1}, MultiplierFreedom::inner_only));
  // A = u + qk is in the plane of x and y.
  const QuaternionPolynomial plane{Polynomial{1, 2}, {}, {}, Polynomial{3, -1, 4}};
  const Vector<Rational> wanted{5, -7, 0};
  for (const auto freedom : {MultiplierFreedom::all, MultiplierFreedom::inner_only}) {
    const auto f = multiplier_with(plane, {1}, wanted, freedom);
    REQUIRE(f);
    CHECK(reached(plane, *f) == wanted);
    CHECK_FALSE(multiplier_with(plane, {1}, {5, -7, Rational(1, 1000)}, freedom));
    // Any other f that does it, moved along the relation of the moments, is farther from 1.
    const auto size = [](const std::vector<Rational>& g) {
      Rational sum;
      for (const Rational& x : g) sum += (x - 1) * (x - 1);
      return sum;
    };
    const std::size_t ends = freedom == MultiplierFreedom::all ? 0 : 1;
    std::vector<Vector<Rational>> moments;
    for (std::size_t k = ends; k + ends < f->size(); ++k) {
      std::vector<Rational> unit(f->size(), 0);
      unit[k] = 1;
      moments.push_back(reached(plane, unit));
    }
    const auto minor = [&](std::size_t i, std::size_t j) {
      return moments[i][0] * moments[j][1] - moments[i][1] * moments[j][0];
    };
    for (const Rational& t : {Rational(1, 100), Rational(-1, 100)}) {
      std::vector<Rational> other = *f;
      other[ends] += t * minor(1, 2);
      other[ends + 1] += t * minor(2, 0);
      other[ends + 2] += t * minor(0, 1);
      CHECK(reached(plane, other) == wanted);
      CHECK(size(other) > size(*f));
    }
  }
}

TEST_CASE("multipliers: a slight one changes by a 2^-20th at most") {
  const QuaternionPolynomial line{Polynomial{1}, {}, {}, {}};  // r′ = (f, 0, 0)
  for (const int sign : {1, -1}) {
    const auto to = [&](long k) {
      const Vector<Rational> wanted{1 + sign * power_of_two(-k), 0, 0};
      return slight_multiplier(line, {1}, wanted, MultiplierFreedom::all);
    };
    REQUIRE(to(20));
    CHECK(reached(line, *to(20)) == Vector<Rational>{1 + sign * power_of_two(-20), 0, 0});
    CHECK_FALSE(to(19));
  }
}

// Three coefficients solve three equations, so that f is the one that the displacement is made of.
TEST_CASE("multipliers: a slight one is nowhere negative") {
  const QuaternionPolynomial a{{1}, {0, 1}, {0, 0, 2}, {1, -3}};
  const Rational small = power_of_ten(-9);
  const auto from = [&](const std::vector<Rational>& f, const std::vector<Rational>& to) {
    return slight_multiplier(a, f, reached(a, to), MultiplierFreedom::all);
  };
  const std::vector<Rational> stops{1, 1, 0};
  const std::vector<Rational> positive{1, 1, small};
  CHECK(from(stops, positive) == positive);
  CHECK_FALSE(from(stops, {1, 1, -small}));  // before t = 1
  const std::vector<Rational> bent{1, -small, 1};
  CHECK(from({1, 0, 1}, bent) == bent);  // 1 − 2t(1 − t)(1 + small) > 0
}

}  // namespace
}  // namespace phrame
