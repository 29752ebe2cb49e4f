#include "phrame/integrate/algebraic_integral.hpp"

#include "phrame/integrate/absolute_integral.hpp"
#include "support/random.hpp"

namespace algebraic_integral_test {

using namespace phrame;
using test::Random;

namespace {

/// Without real zeros, squarefree.
Polynomial positive(Random& random) {
  const Polynomial p = random.polynomial(2);
  const Polynomial S =
      p * p + Polynomial{0, 1} * Polynomial{0, 1} + Polynomial{random.integer(1, 5)};
  return is_squarefree(S) ? S : Polynomial{1, 0, 1};
}

/// (A/E·√S)′ over √S.
RootQuotient derivative_of(const Polynomial& A, const Polynomial& E, const Polynomial& S) {
  return {
      (differentiate(A) * E - A * differentiate(E)) * S + Rational(1, 2) * A * E * differentiate(S),
      E * E, S};
}

}  // namespace

// Both differ by a constant, so that F(t) − F(0) is the same number.
TEST_CASE("algebraic integral: the derivative of A/E·√S has A/E·√S for an integral") {
  test::for_samples(60, [](Random& random) {
    const Polynomial S = positive(random);
    Polynomial E{1};
    if (random.chance(2)) E = positive(random);
    if (random.chance(3)) E *= S;
    if (random.chance(3)) E *= E;
    const Polynomial A = random.polynomial(4);
    const RootQuotient f = TaylorIntegral(derivative_of(A, E, S)).integrand();
    const auto F = algebraic_integral(f);
    REQUIRE(F);
    const AlgebraicIntegral known{RationalFunction(A, E), S};
    for (const Rational& t : {Rational(1, 3), Rational(1)})
      CHECK((*F)(t) - (*F)(0) == known(t) - known(0));
  });
}

TEST_CASE("algebraic integral: logarithms and elliptic integrals have none") {
  const Polynomial one{1};
  const Polynomial S{1, 0, 1};
  CHECK_FALSE(algebraic_integral({one, one, S}));                   // asinh t
  CHECK_FALSE(algebraic_integral({S, one, S}));                     // (t√S + asinh t)/2
  CHECK_FALSE(algebraic_integral({one, S * S + one, S}));           //
  CHECK_FALSE(algebraic_integral({one, one, {1, 0, 0, 0, 1}}));     // of the first kind
  CHECK(algebraic_integral({one, S, S}));                           // t/√S
  CHECK(algebraic_integral({{0, 0, 0, 1}, one, {1, 0, 0, 0, 1}}));  // √S/2
  CHECK(algebraic_integral({one, one, {2}}).value()(1) == Surd(0, Rational(1, 2), 2));
}

// ∫₀¹ |2t − 1|·√(t² − t + 1): the sign changes at 1/2. With u = t² − t, ∫ √(1 + u)·|u′| dt =
// 2·(2/3)(1 − (3/4)^{3/2}) = 4/3 − √3/2.
TEST_CASE("algebraic integral: of an integrand that changes its sign") {
  const Polynomial S{1, -1, 1};
  const AbsoluteIntegral f({Polynomial{-1, 2} * S, {1}, S});
  CHECK(f.algebraic_value(1).value() == Surd(Rational(4, 3), Rational(-1, 2), 3));
  CHECK_FALSE(f.value(Rational(1)).exact());
  CHECK(f.value(Rational(1)).origin().is_irrational);
  CHECK_FALSE(AbsoluteIntegral({Polynomial{-1, 0, 2} * S, {1}, S}).algebraic_value(1));
}

}  // namespace algebraic_integral_test
