#include "phrame/integrate/integrate.hpp"

#include "phrame/integrate/known_integral.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr Form all_forms[] = {Form::automatic, Form::partial_fractions, Form::rothstein_trager,
                              Form::lazard_rioboo_trager};

}  // namespace

TEST_CASE("integrate: textbook integrals") {
  CHECK(integrate({}) == Antiderivative{});
  CHECK(integrate(RationalFunction({0, 2})).polynomial == Polynomial{0, 0, 1});
  // ∫ (3t² + t + 1)/(t³ + t) = log t + log(t² + 1) + arctan t: residues 1 and 1 ± i/2.
  const auto F = integrate({{1, 1, 3}, {0, 1, 0, 1}}, Form::rothstein_trager);
  REQUIRE(F.logs.size() == 2);
  CHECK(F.logs[0].index == Polynomial{-1, 1});
  CHECK(F.logs[1].index == Polynomial{5, -8, 4});  // roots 1 ± i/2
}

TEST_CASE(
    "integrate: automatic: repeated residues are written once, distinct ones over the poles") {
  // d′/d: one residue, 1, although d is irreducible of degree 5.
  const auto one = integrate({{0, 0, 0, 0, 5}, {2, 0, 0, 0, 0, 1}});
  REQUIRE(one.logs.size() == 1);
  CHECK(one.logs[0].index.degree() == 1);
  CHECK(one.logs[0].argument.degree() == 5);
  // 1/(t³ + t + 1): three distinct residues.
  const auto three = integrate({{1}, {1, 1, 0, 1}});
  REQUIRE(three.logs.size() == 1);
  CHECK(is_over_poles(three.logs[0]));
  // Both in one function: 2t/(t² + 1) has the residue 1 twice, 1/(t³ + t + 1) is as above.
  const auto mixed =
      integrate(RationalFunction({0, 2}, {1, 0, 1}) + RationalFunction({1}, {1, 1, 0, 1}));
  REQUIRE(mixed.logs.size() == 2);
  CHECK_FALSE(is_over_poles(mixed.logs[0]));
  CHECK(is_over_poles(mixed.logs[1]));
}

TEST_CASE("integrate: the same residues at different irreducible factors are joined") {
  // 1/(t² + 1) and 1/((t + 1)² + 1) both have the residues ±i/2.
  const auto F = integrate(RationalFunction({1}, {1, 0, 1}) + RationalFunction({1}, {2, 2, 1}));
  REQUIRE(F.logs.size() == 1);
  CHECK(F.logs[0].index == Polynomial{1, 0, 4});
  CHECK(F.logs[0].argument.degree() == 2);
}

TEST_CASE("integrate: law: the derivative of every form is the integrand") {
  for_samples(60, [](Random& random) {
    const Polynomial d = random.repeated_polynomial(2);
    const RationalFunction f(random.polynomial(7), d);
    for (const Form form : all_forms) {
      const Antiderivative F = integrate(f, form);
      CHECK(differentiate(F) == f);
      CHECK(F.rational.is_proper());
      for (const LogSum& sum : F.logs) {
        CHECK(is_squarefree(sum.index));
        CHECK(sum.residue.degree() < sum.index.degree());
        CHECK(gcd(sum.residue, sum.index).is_constant());
        const Polynomial lead = sum.argument.coefficient(sum.argument.degree());
        CHECK(gcd(lead, sum.index).is_constant());
        if (sum.index.degree() <= 2) CHECK(lead == Polynomial{1});
      }
    }
  });
}

TEST_CASE(
    "integrate: law: the part without logarithms is that of every form, the rest has none of it") {
  for_samples(40, [](Random& random) {
    const RationalFunction f(random.polynomial(7), random.repeated_polynomial(2));
    const auto [F, rest] = algebraic_part(f);
    CHECK(F.logs.empty());
    CHECK(differentiate(F) + rest == f);
    CHECK(rest.is_proper());
    CHECK(is_squarefree(rest.denominator()));
    const Antiderivative whole = integrate(f);
    CHECK(whole.polynomial == F.polynomial);
    CHECK(whole.rational == F.rational);
  });
}

TEST_CASE("integrate: law: what near poles tell changes nothing") {
  const auto check = [](const Polynomial& n, const Polynomial& d) {
    const auto poles = near_poles(n, d);
    REQUIRE(poles);
    const RationalFunction f(n, d);
    for (const Form form : all_forms)
      CHECK(integrate(f, algebraic_part(f), form, &*poles) == integrate(f, form));
  };
  // Reducible over ℚ, where the sums of roots are integers, halves and sixths, or residues repeat.
  const Polynomial i{1, 0, 1};
  check({1, 1}, i * Polynomial{2, 2, 1});
  check({1, 3, 1}, Polynomial{2, 1, 2} * Polynomial{1, 1, 3});
  check({1, 3, 1, 1}, Polynomial{7, 1, 2} * Polynomial{5, 2, 5} * Polynomial{11, -1, 3});
  check({0, 2}, Polynomial{3, 0, 1, 0, 1});
  check({1, 0, 0, 4}, {1, 1, 1, 1, 1});
  check({0, 0, 0, 4}, {2, 0, 0, 0, 1});
  check({2, 5}, i * Polynomial{2, 2, 1});
  check({0, 2}, i);
  // 2 Re (1 + 2i)·q′/q with q = t² − 2it − 3: both roots, i ± √2, are above the axis.
  check({-24, -4, -8, 4}, {9, 0, -2, 0, 1});
  // Two irreducible factors, of which each sum is 0.
  check({1, 2, 0, 1}, Polynomial{1, 1, 0, 0, 1} * Polynomial{7, 3, 0, 0, 1});
  check({-7, 1, 3, 0, 1}, {5, 1, 0, 0, 1, 0, 1});
  for_samples(30, [&](Random& random) {
    const auto quadratic = [&] {
      const long a = random.integer(1, 9);
      const long b = random.integer(-5, 5);
      return Polynomial{b * b + random.integer(1, 50), b, a};
    };
    Polynomial d = quadratic();
    for (long k = random.integer(0, 2); k > 0; --k) d *= quadratic();
    if (random.chance(2)) d = d * d + Polynomial{random.integer(1, 9)};
    if (is_squarefree(d)) check({random.integer(-9, 9), random.integer(1, 9)}, d);
  });
  // Of high degree, with up to 22 pairs of roots, irreducible and not.
  for_samples(12, [&](Random& random) {
    const auto square = [&](long degree) {
      std::vector<Rational> c;
      for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-9, 9));
      return Polynomial(c) * Polynomial(c);
    };
    const long degree = random.integer(5, 22);
    const long of_first = random.chance(3) ? 0 : random.integer(1, degree / 2);
    const Polynomial first = square(of_first) + square(of_first) + Polynomial{1};
    const long rest = degree - first.degree() / 2;
    const Polynomial d = first * (square(rest) + square(rest) + Polynomial{random.integer(1, 9)});
    const Polynomial n{random.integer(-9, 9), random.integer(1, 9)};
    if (near_poles(n, d)) check(n, d);
  });
}
