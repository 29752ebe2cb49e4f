#include "phrame/ph/curve/identify.hpp"

#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// The preimage and multiplier of a hodograph that has them.
Curve identified(const Vector<Polynomial>& hodograph_given) {
  const auto result = identify(hodograph_given);
  REQUIRE(std::holds_alternative<Curve>(result));
  const Curve& curve = std::get<Curve>(result);
  CHECK(hodograph(curve) == hodograph_given);
  return curve;
}

NotPythagorean refused(const Vector<Polynomial>& hodograph_given) {
  const auto result = identify(hodograph_given);
  REQUIRE(std::holds_alternative<NotPythagorean>(result));
  return std::get<NotPythagorean>(result);
}

bool is_positive_after_zero(const Polynomial& f) {
  for (const Rational& c : f.coefficients())
    if (c != 0) return c > 0;
  return false;
}

/// A = B·c for a c in the field of fractions of ℚ(i)[t]: α_A β_B = α_B β_A.
bool differ_by_right_factor(const QuaternionPolynomial& a, const QuaternionPolynomial& b) {
  const HopfForm x = hopf_form(a);
  const HopfForm y = hopf_form(b);
  return x.alpha * y.beta == y.alpha * x.beta;
}

long common_degree(const QuaternionPolynomial& a) {
  const HopfForm form = hopf_form(a);
  return degree(gcd(form.alpha, form.beta));
}

const QuaternionPolynomial j{{}, {}, {1}, {}};

Polynomial integer_polynomial(Random& random, long degree) {
  std::vector<Rational> c;
  for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-9, 9));
  return Polynomial(c);
}

/// With integer coefficients, of that degree unless chance has it otherwise.
QuaternionPolynomial integer_quaternion(Random& random, long m) {
  for (;;) {
    const QuaternionPolynomial a{integer_polynomial(random, m), integer_polynomial(random, m),
                                 integer_polynomial(random, m), integer_polynomial(random, m)};
    if (degree(a) == m) return a;
  }
}

}  // namespace

TEST_CASE("identify: the quintic of Farouki 2003 gives back its preimage") {
  const QuaternionPolynomial a{{2, -4, 4}, {1, 0, -1}, {0, -4, 4}, {1, 2, -2}};
  const Curve curve = identified(hodograph(Curve(a)));
  CHECK(curve.preimage() == a);
  CHECK(curve.multiplier() == Polynomial{1});
}

// x = t⁷/21 + t⁵/5 + t³ − 3t, y = −t⁴/2 + 3t², z = −2t³ of Beltran and Monterde, with
// 3|r′| = t⁶ + 3t⁴ + 9t² + 9 and 3r′ = B i B*, B = (3t − t³) − 3t² i + 3k; 1/3 = 3·(1/3)².
TEST_CASE("identify: the double PH curve of degree 7 needs the multiplier 3") {
  const Vector<Polynomial> r1{Polynomial{-3, 0, 3, 0, 1, 0, Rational(1, 3)},
                              Polynomial{0, 6, 0, -2}, Polynomial{0, 0, -6}};
  const Curve curve = identified(r1);
  CHECK(curve.multiplier() == Polynomial{3});
  CHECK(curve.preimage() == QuaternionPolynomial{{0, 1, 0, Rational(-1, 3)}, {0, 0, -1}, {}, {1}});
  CHECK(Polynomial{3} * norm(curve.preimage()) == Rational(1, 3) * Polynomial{9, 0, 9, 0, 3, 0, 1});
}

// u = t, v = −1, p = −t, q = t²: r′ = (t² + 1)·(1 − t², 2t, 0), a plane curve although v, p ≠ 0.
TEST_CASE("identify: what a preimage has in common moves into the multiplier") {
  const Curve given({{0, 1}, {-1}, {0, -1}, {0, 0, 1}});
  const Polynomial common{1, 0, 1};
  CHECK(hodograph(given) ==
        Vector<Polynomial>{common * Polynomial{1, 0, -1}, common * Polynomial{0, 2}, Polynomial()});
  const Curve curve = identified(hodograph(given));
  CHECK(curve.multiplier() == common);
  CHECK(curve.preimage() == QuaternionPolynomial{{1}, {}, {}, {0, 1}});
}

TEST_CASE("identify: lines, cusps and constants") {
  const auto line = [](const Polynomial& x, const Polynomial& y, const Polynomial& z) {
    return identified({x, y, z});
  };
  CHECK(line({1}, {}, {}) == Curve({{1}, {}, {}, {}}));
  CHECK(line({-1}, {}, {}) == Curve({{}, {}, {}, {1}}));
  CHECK(line({Rational(9, 16)}, {}, {}) == Curve({{Rational(3, 4)}, {}, {}, {}}));
  CHECK(line({5}, {}, {}) == Curve({{2}, {1}, {}, {}}));  // |2 + i|² = 5
  CHECK(line({3}, {}, {}) == Curve({{1}, {}, {}, {}}, {3}));
  CHECK(line({1}, {2}, {2}) == Curve({{1}, {1}, {}, {1}}));  // 1 + i + k, by hand
  // −t³(1 − t): backwards along x just after 0.
  CHECK(line({0, 0, 0, -1, 1}, {}, {}) == Curve({{}, {}, {}, {1}}, {0, 0, 0, 1, -1}));
  CHECK_THROWS_AS(identify({}), DomainError);
}

TEST_CASE("identify: parabola and twisted cubic are not PH; the factor is named") {
  CHECK(refused({Polynomial{1}, Polynomial{0, 2}, {}}) == NotPythagorean{{1, 0, 4}, 1});
  CHECK(refused({Polynomial{1}, Polynomial{0, 2}, Polynomial{0, 0, 3}}) ==
        NotPythagorean{{1, 0, 4, 0, 9}, 1});
  // 2 + 4t², times the square of a common factor.
  const Polynomial f{-1, 3};
  CHECK(refused({f, f, f * Polynomial{0, 2}}) == NotPythagorean{{1, 0, 2}, 2});
  CHECK(to_string(refused({Polynomial{1}, Polynomial{0, 2}, {}})) ==
        "|r'| is no polynomial: |r'|^2 has the factor 4*t^2 + 1 to an odd power");
}

TEST_CASE("identify: PH over ℝ only is told apart") {
  CHECK(refused({Polynomial{1}, Polynomial{1}, {}}) == NotPythagorean{{1}, 2});
  CHECK(refused({Polynomial{1}, Polynomial{1}, Polynomial{1}}) == NotPythagorean{{1}, 3});
  // 4 + 1000003² = 275881 · 3624773, times the square of the prime 10¹² + 39.
  const Integer prime("1000000000039");
  CHECK(refused({Polynomial{Rational(2 * prime)}, Polynomial{Rational(1000003 * prime)}, {}}) ==
        NotPythagorean{{1}, Integer("1000006000013")});
  // (1 − t², 2t) turned by 45° and scaled by √2: |r′|² = 2(1 + t²)².
  const NotPythagorean turned = refused({Polynomial{1, -2, -1}, Polynomial{1, 2, -1}, {}});
  CHECK(turned == NotPythagorean{{1}, 2});
  CHECK(to_string(turned).starts_with("|r'| is sqrt(2) times a polynomial"));
}

TEST_CASE("identify: law: f and A come back, A the primitive part of the one given") {
  for_samples(60, [](Random& random) {
    const long m = random.chance(8) ? random.integer(6, 20) : random.integer(0, 5);
    QuaternionPolynomial b = random.quaternion_polynomial(m);
    if (random.chance(3)) {
      const GaussianPolynomial c = random.gaussian_polynomial(2);
      if (!is_zero(c)) b = b * QuaternionPolynomial{c.re, c.im, {}, {}};
    }
    Curve given(b, random.chance(2) ? random.nonzero_polynomial(3) : Polynomial{1});
    if (random.chance(3))
      given = rotated(given, {random.integer(1, 9), random.integer(-9, 9), random.integer(-9, 9),
                              random.integer(-9, 9)});
    const Curve found = identified(hodograph(given));
    CHECK(is_pythagorean(hodograph(given)));
    CHECK(common_degree(found.preimage()) == 0);
    CHECK(degree(found) == degree(given));
    CHECK(is_positive_after_zero(found.multiplier()));
    // f > 0 where that given is negative: A i A* is the opposite vector, that of A·j.
    const bool same_sign = is_positive_after_zero(given.multiplier());
    CHECK(differ_by_right_factor(found.preimage(),
                                 same_sign ? given.preimage() : given.preimage() * j));
  });
}

TEST_CASE("identify: law: a primitive A with integer coefficients comes back, with f = 1") {
  for_samples(30, [](Random& random) {
    const QuaternionPolynomial a = integer_quaternion(random, random.integer(1, 8));
    if (common_degree(a) > 0) return;
    const Curve found = identified(hodograph(Curve(a)));
    CHECK(found.multiplier() == Polynomial{1});
    CHECK(norm(found.preimage()) == norm(a));
    CHECK(differ_by_right_factor(found.preimage(), a));
    // A·c with |c| = 1, and rational numbers too: all the same.
    const QuaternionPolynomial turned =
        a * QuaternionPolynomial{{Rational(3, 5)}, {Rational(4, 5)}, {}, {}};
    CHECK(identified(hodograph(Curve(turned))) == found);
    const Rational scale(random.integer(1, 1000), random.integer(1, 1000));
    const QuaternionPolynomial scaled_a = a * QuaternionPolynomial{{scale}, {}, {}, {}};
    CHECK(identified(hodograph(Curve(scaled_a))).multiplier() == Polynomial{1});
  });
}

TEST_CASE("identify: law: |r′|² is radicand · odd factor · a square wherever it is refused") {
  for_samples(60, [](Random& random) {
    const Polynomial f = random.nonzero_polynomial(2);
    const Vector<Polynomial> r1{f * random.polynomial(3), f * random.polynomial(3),
                                f * random.polynomial(3)};
    if (r1 == Vector<Polynomial>{}) return;
    const auto result = identify(r1);
    const Polynomial squared = r1[0] * r1[0] + r1[1] * r1[1] + r1[2] * r1[2];
    const auto* reason = std::get_if<NotPythagorean>(&result);
    CHECK((reason == nullptr) == square_root(squared).has_value());
    CHECK(is_pythagorean(r1) == (reason == nullptr));
    if (reason == nullptr) return;
    CHECK(is_squarefree(reason->odd_factor));
    CHECK(square_root(Polynomial{Rational(reason->radicand)} * reason->odd_factor * squared));
    CHECK((reason->radicand != 1 || !reason->odd_factor.is_constant()));
  });
}

TEST_CASE("identify: a control point that is off by 10⁻³⁰ is seen") {
  const Rational little = parse_rational("1e-30");
  for_samples(20, [&](Random& random) {
    const Curve given(integer_quaternion(random, random.integer(1, 6)), {1}, {1, 2, 3});
    auto points = control_points(given);
    const auto found = identify(bezier_hodograph(points), points.front());
    REQUIRE(std::holds_alternative<Curve>(found));
    CHECK(position(std::get<Curve>(found)) == position(given));
    const auto last = static_cast<long>(points.size()) - 1;
    points[static_cast<std::size_t>(random.integer(1, last))]
          [static_cast<std::size_t>(random.integer(0, 2))] += little;
    CHECK_FALSE(refused(bezier_hodograph(points)).odd_factor.is_constant());
  });
}

TEST_CASE("identify: huge coefficients and a content that is not factored") {
  // A = (10⁴⁰ + i t) + t²j/10⁵⁰: not primitive, and no small numbers.
  const QuaternionPolynomial a{
      {parse_rational("1e40")}, {0, 1}, {0, 0, parse_rational("1e-50")}, {}};
  CHECK(identified(hodograph(Curve(a))) == Curve(a));
  // The line along x with |r′| a product of two primes ≡ 3 mod 4 beyond 2¹²⁸: no norm, left in f.
  const Integer mersenne = (Integer(1) << 127U) - 1;
  const Rational large(mersenne * mersenne * ((Integer(1) << 89U) - 1));
  CHECK(identified({Polynomial{large}, {}, {}}).preimage().u.degree() == 0);
}

TEST_CASE("why a curve is not PH is printed as to_string has it") {
  const NotPythagorean reason{Polynomial{1}, 2};
  std::ostringstream text;
  text << reason;
  CHECK(text.str() == to_string(reason));
}
