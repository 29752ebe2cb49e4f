#include "phrame/algebra/algebraic_image.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "support/random.hpp"

namespace algebraic_image_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// √n, of a number that is no square.
RealAlgebraic root_of(long n) {
  return real_roots(Polynomial{Rational(-n), 0, 1}, closed_interval(0, Rational(n))).front().at;
}

}  // namespace

TEST_CASE("algebraic image: a shift and a factor of a root") {
  CHECK(affine(Rational(2, 3), -3, 5).rational() == Rational(3));
  // 1 − 2√2 is the negative root of (x − 1)² = 8.
  const RealAlgebraic x = affine(root_of(2), -2, 1);
  CHECK(sign_at(Polynomial{-7, -2, 1}, x) == 0);
  CHECK(compare(x, 0) < 0);
  CHECK_THROWS_AS(affine(root_of(2), 0, 1), DomainError);
}

TEST_CASE("algebraic image: a power that is rational, one that is not, and a quotient") {
  CHECK(image(Polynomial{1, 0, 3}, root_of(5)).rational() == Rational(16));
  // (1 + √5)/2 has the square (3 + √5)/2, a root of y² − 3y + 1.
  const RealAlgebraic golden =
      real_roots(Polynomial{-1, -1, 1}, closed_interval(Rational(1), Rational(2))).front().at;
  const RealAlgebraic square = image(Polynomial{0, 0, 1}, golden);
  CHECK(sign_at(Polynomial{1, -3, 1}, square) == 0);
  CHECK(compare(square, 2) > 0);
  // 1/φ = φ − 1.
  CHECK(image(RationalFunction({1}, {0, 1}), golden) == affine(golden, 1, -1));
  CHECK_THROWS_AS(image(RationalFunction({1}, {-1, -1, 1}), golden), DomainError);
}

TEST_CASE("algebraic image: law: it is where the function's value is") {
  for_samples(60, [](Random& random) {
    const auto roots = real_roots(random.nonconstant_polynomial(4), closed_interval(-20, 20));
    if (roots.empty()) return;
    const RealAlgebraic& x = roots.front().at;
    const Polynomial y = random.polynomial(3);
    const RealAlgebraic found = image(y, x);
    CHECK(enclose(found, 100).overlaps(evaluate(y, enclose(x, 200), 200)));
    // The polynomial found vanishes there: at y(t) modulo that of x.
    CHECK((compose(found.polynomial(), y) % x.polynomial()).is_zero());
  });
}

}  // namespace algebraic_image_test
