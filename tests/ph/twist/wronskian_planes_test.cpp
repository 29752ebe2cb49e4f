#include "phrame/ph/twist/wronskian_planes.hpp"

#include <algorithm>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/twist/best_in_plane.hpp"
#include "support/random.hpp"

namespace wronskian_planes_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Polynomial wronskian(const Polynomial& a, const Polynomial& b) {
  return a * differentiate(b) - differentiate(a) * b;
}

/// Of the normal form with this x, in τ.
std::pair<Polynomial, Polynomial> basis_at(const WronskianPlane& plane, const Rational& x) {
  const auto polynomial = [&x](const std::vector<RationalFunction>& coefficients) {
    std::vector<Rational> values;
    for (const RationalFunction& c : coefficients) values.push_back(c(x));
    return Polynomial(values);
  };
  return {polynomial(plane.a), polynomial(plane.b)};
}

Polynomial at_origin(const Polynomial& n, const WronskianPlanes& planes) {
  return compose(n, Polynomial{planes.origin, 1});
}

/// Is there a real plane with these two polynomials in t, and a rational x?
bool has_plane(const WronskianPlanes& planes, const Polynomial& p, const Polynomial& q) {
  return std::any_of(planes.real.begin(), planes.real.end(), [&](const WronskianPlane& plane) {
    const auto x = plane.parameter.rational();
    if (!x) return false;
    const auto [a, b] = basis_at(plane, *x);
    const Polynomial shift{planes.origin, 1};
    for (const Polynomial& wanted : {compose(p, shift), compose(q, shift)}) {
      // By the values and slopes at τ = 0.
      const Polynomial rest = wanted - wanted.coefficient(0) * a -
                              Rational(wanted.coefficient(1) / b.coefficient(1)) * b;
      if (!rest.is_zero()) return false;
    }
    return true;
  });
}

}  // namespace

// 2hσ of the quintic of [Peng, Pang, Pan 2023]; its resolvent by SymPy, from the system (24) and
// not from the formulas here.
TEST_CASE("wronskian planes: the resolvent of the paper's quintic") {
  const WronskianPlanes planes = wronskian_planes({40, -320, 1268, -2928, 3880, -2672, 900}, 4);
  CHECK(planes.origin == 0);
  CHECK(planes.resolvent == Polynomial{31231336, 12466956, 1992728, 159229, 6340, 100});
  CHECK(factor(planes.resolvent).factors.size() == 1);
  REQUIRE(planes.real.size() == 3);
  const char* const roots[] = {"-19.4160517302523", "-11.0076467753085", "-10.3984092744613"};
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(round_to_decimal(to_real(planes.real[k].parameter), 15).value == roots[k]);
}

TEST_CASE("wronskian planes: all coefficients but the highest are right for every parameter") {
  for_samples(20, [](Random& random) {
    std::vector<Rational> c;
    for (int k = 0; k < 7; ++k) c.emplace_back(random.integer(-9, 9));
    c[0] = random.integer(1, 9);
    const Polynomial n(c);
    const WronskianPlanes planes = wronskian_planes(n, 4);
    REQUIRE(planes.resolvent.degree() == 5);  // for every N(0) ≠ 0
    const Rational x(random.integer(10, 99), 7);
    const auto [a, b] = basis_at(planes.real.front(), x);
    const Polynomial defect = wronskian(a, b) - n;
    CHECK(defect == Polynomial::monomial(defect.coefficient(6), 6));
    // It vanishes where the resolvent does, and nowhere else.
    CHECK((defect.is_zero()) == (planes.resolvent(x) == 0));
  });
}

TEST_CASE("wronskian planes: that of two polynomials is found, also where N(0) = 0") {
  for_samples(20, [](Random& random) {
    const auto quartic = [&random](bool is_zero_at_0) {
      std::vector<Rational> c;
      for (int k = 0; k < 5; ++k) c.emplace_back(random.integer(-5, 5));
      if (is_zero_at_0) c[0] = c[1] = 0;
      return Polynomial(c);
    };
    for (const bool is_zero_at_0 : {false, true}) {
      const Polynomial p = quartic(false);
      const Polynomial q = quartic(is_zero_at_0);
      const Polynomial n = wronskian(p, q);
      if (n.is_zero()) return;
      const WronskianPlanes planes = wronskian_planes(n, 4);
      CHECK((planes.origin == 0) == (n(0) != 0));
      CHECK(has_plane(planes, p, q));
      for (const WronskianPlane& plane : planes.real) {
        const auto x = plane.parameter.rational();
        if (!x) continue;
        const auto [a, b] = basis_at(plane, *x);
        CHECK(wronskian(a, b) == at_origin(n, planes));
      }
    }
  });
}

// ⟨t + 1, (t + 1)³⟩, which counts four times, and ⟨1, (t + 1)⁴⟩.
TEST_CASE("wronskian planes: roots of high multiplicity") {
  const Polynomial s{1, 1};
  const WronskianPlanes planes = wronskian_planes(Rational(4) * pow(s, 3), 4);
  CHECK(planes.real.size() == 2);
  CHECK(has_plane(planes, s, pow(s, 3)));
  CHECK(has_plane(planes, {1}, pow(s, 4)));
}

// N = 2 + 3t⁴ + t⁶: a₂ = 0 leaves a₃² = 1.
TEST_CASE("wronskian planes: two with the same a₂") {
  const Polynomial n{2, 0, 0, 0, 3, 0, 1};
  const WronskianPlanes planes = wronskian_planes(n, 4);
  for (const Rational& a3 : {Rational(1), Rational(-1)}) {
    const Polynomial a{1, 0, 0, a3, Rational(-1, 2)};
    const Polynomial b{0, 2, 0, 0, a3};
    REQUIRE(wronskian(a, b) == n);
    CHECK(has_plane(planes, a, b));
  }
}

// Of N = (t − z)²N₁ the planes of cubics of N₁, times t − z, are planes.
TEST_CASE("wronskian planes: a common zero is known, and kept by every parameter") {
  long irrational = 0;
  for_samples(20, [&](Random& random) {
    const Rational z(random.integer(-3, 3), random.integer(1, 3));
    const Polynomial factor{-z, 1};
    const auto c = [&random] { return Rational(random.integer(-5, 5)); };
    const Polynomial p{c(), c(), c(), c()};
    const Polynomial q{c(), c(), c(), c()};
    const auto planes_of = [&](const Polynomial& n1) {
      return wronskian_planes(pow(factor, 2) * n1, 4);
    };
    if (wronskian(p, q)(z) == 0) return;
    const WronskianPlanes known = planes_of(wronskian(p, q));
    CHECK(has_plane(known, factor * p, factor * q));
    CHECK(std::count_if(known.real.begin(), known.real.end(),
                        [](const auto& plane) { return plane.zero.has_value(); }) >= 1);
    const Polynomial n = pow(factor, 2) * Polynomial{c() + 6, c(), c(), c(), c() - 6};
    if (gcd(n, differentiate(n)).degree() != 1) return;
    const WronskianPlanes planes = wronskian_planes(n, 4);
    const Polynomial there = at_origin(factor, planes);
    const Rational x(random.integer(10, 99), 7);
    for (const WronskianPlane& plane : planes.real) {
      const auto [a, b] = basis_at(plane, x);
      const Polynomial defect = wronskian(a, b) - at_origin(n, planes);
      const Polynomial law =
          plane.zero ? pow(there, 2) * Polynomial::monomial(1, 4) : Polynomial::monomial(1, 6);
      CHECK(defect == defect.coefficient(6) * law);
      if (plane.zero && !plane.parameter.is_rational()) {
        ++irrational;
        CHECK(*plane.zero == z);
        CHECK(gcd(a, b).degree() == 1);
        CHECK((a % there).is_zero());
        CHECK((b % there).is_zero());
      }
      // By the balls: is there one?
      const PlaneBasis basis = enclose(plane, planes.origin, 300);
      const bool vanish = evaluate(basis.a, RealBall(z, 300), 300).contains_zero() &&
                          evaluate(basis.b, RealBall(z, 300), 300).contains_zero();
      CHECK(vanish == plane.zero.has_value());
    }
  });
  CHECK(irrational > 0);
}

// a₂ = 0 leaves (a₃ − 2)(a₃ + 1) = 0, and that with −1 is ⟨t − 1, (t − 1)(t + t² + …)⟩.
TEST_CASE("wronskian planes: two with the same a₂, one of them with a common zero") {
  const WronskianPlanes planes =
      wronskian_planes(pow(Polynomial{-1, 1}, 2) * pow(Polynomial{1, 1, 1}, 2), 4);
  std::vector<Rational> a3;
  for (const WronskianPlane& plane : planes.real) {
    if (!plane.parameter.is_rational()) continue;
    const auto [a, b] = basis_at(plane, *plane.parameter.rational());
    CHECK((a(1) == 0 && b(1) == 0) == plane.zero.has_value());
    if (a.coefficient(2) == 0) a3.push_back(a.coefficient(3));
    CHECK((a.coefficient(2) != 0 || plane.zero.has_value() == (a.coefficient(3) == -1)));
  }
  std::sort(a3.begin(), a3.end());
  CHECK(a3 == std::vector<Rational>{-1, 2});
}

TEST_CASE("wronskian planes: quadratics have one") {
  const Polynomial n{3, -5, 7};
  const WronskianPlanes planes = wronskian_planes(n, 2);
  REQUIRE(planes.real.size() == 1);
  const auto [a, b] = basis_at(planes.real[0], planes.real[0].parameter.rational().value());
  CHECK(wronskian(a, b) == n);
  CHECK(planes.resolvent == Polynomial{7, 3});
}

TEST_CASE("wronskian planes: in powers of t, in balls") {
  const Polynomial s{1, 1};
  const Polynomial n = Rational(4) * Polynomial{0, 1} * pow(s, 4);  // 0 at 0
  const WronskianPlanes planes = wronskian_planes(n, 4);
  REQUIRE(planes.origin == 1);
  constexpr long bits = 200;
  for (const WronskianPlane& plane : planes.real) {
    const auto [a, b] = enclose(plane, planes.origin, bits);
    const BallPolynomial left = multiply(a, differentiate(b, bits), bits);
    const BallPolynomial defect =
        subtract(subtract(left, multiply(differentiate(a, bits), b, bits), bits),
                 BallPolynomial(n, bits), bits);
    for (long k = 0; k <= defect.degree_bound(); ++k) {
      CHECK(defect.coefficient(k).contains_zero());
      CHECK(defect.coefficient(k).radius() < power_of_two(-100));
    }
  }
}

TEST_CASE("wronskian planes: what has none is refused") {
  CHECK_THROWS_WITH_AS(wronskian_planes({1}, 3), "wronskian_planes: the degree is 3, not 2 or 4",
                       DomainError);
  CHECK_THROWS_WITH_AS(wronskian_planes({}, 4), "wronskian_planes: no two polynomials have it 0",
                       DomainError);
  CHECK_THROWS_WITH_AS(wronskian_planes({0, 0, 0, 1}, 2),
                       "wronskian_planes: its degree is 3, at most 2 is possible", DomainError);
}

}  // namespace wronskian_planes_test
