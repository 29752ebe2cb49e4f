#include "phrame/algebra/eliminant.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace eliminant_test {
namespace {

using namespace phrame;
using test::Random;

/// c·∏ (t − root).
Bivariate with_roots(const std::vector<Polynomial>& roots, const Polynomial& c) {
  std::vector<Polynomial> product{c};
  for (const Polynomial& root : roots) {
    product.emplace_back();
    for (std::size_t k = product.size(); k-- > 0;)
      product[k] = (k > 0 ? product[k - 1] : Polynomial()) - root * product[k];
  }
  return Bivariate(product);
}

}  // namespace

// res(a, b) = lead(a)^deg b · lead(b)^deg a · ∏ (α − β).
TEST_CASE("eliminant: law: it is the product of the differences of roots, and of leading ones") {
  test::for_samples(20, [](Random& random) {
    std::array<std::vector<Polynomial>, 2> roots;
    for (auto& list : roots)
      for (long k = random.integer(1, 3); k > 0; --k) list.push_back(random.polynomial(3));
    const std::array<Polynomial, 2> leads{random.nonzero_polynomial(2),
                                          random.nonzero_polynomial(2)};
    // Contents are no part of it.
    const auto lead_of = [&](std::size_t k) { return primitive_part(leads[k]); };
    Polynomial product = pow(lead_of(0), static_cast<long>(roots[1].size())) *
                         pow(lead_of(1), static_cast<long>(roots[0].size()));
    for (const Polynomial& alpha : roots[0])
      for (const Polynomial& beta : roots[1]) product *= alpha - beta;
    const Bivariate a = with_roots(roots[0], lead_of(0));
    const Bivariate b = with_roots(roots[1], lead_of(1));
    const Polynomial found = eliminant(a, b);
    CHECK((found.degree() + 1) * primitive_bits(found) <= eliminant_size(a, b));
    CHECK(found == (product.is_zero() ? product : primitive_part(product)));
  });
}

TEST_CASE("eliminant: of a constant in t, and of what has a common factor") {
  const Bivariate a({Polynomial{0, -1}, Polynomial{}, Polynomial{1}});  // t² − x
  CHECK(eliminant(a, Bivariate({Polynomial{-2, 1}})) == pow(Polynomial{-2, 1}, 2));
  CHECK(eliminant(a, Bivariate({Polynomial{-2}, Polynomial{1}})) == Polynomial{-4, 1});
  CHECK(eliminant(a, a) == Polynomial{});
}

TEST_CASE("eliminant: law: (f(x) g(t) - f(t) g(x))/(x - t) times x - t, and swapped twice") {
  test::for_samples(20, [](Random& random) {
    const Polynomial f = random.nonconstant_polynomial(5);
    const Polynomial g = random.nonzero_polynomial(4);
    std::vector<Polynomial> rows;
    for (long k = 0; k <= std::max(f.degree(), g.degree()); ++k)
      rows.push_back(g.coefficient(k) * f - f.coefficient(k) * g);
    const Bivariate whole(rows);
    CHECK(swapped(swapped(whole)) == whole);
    const Bivariate quotient = exact_quotient(whole, Bivariate({Polynomial{0, 1}, Polynomial{-1}}));
    for (const Rational& t : {Rational(0), Rational(2, 3), Rational(-5)})
      CHECK(evaluate_at(quotient, t) * Polynomial{-t, 1} == evaluate_at(whole, t));
    CHECK(evaluate_at(swapped(whole), Rational(3)) ==
          Rational(-1) * evaluate_at(whole, Rational(3)));
  });
  const Bivariate difference({Polynomial{0, 1}, Polynomial{-1}});
  CHECK(exact_quotient(Bivariate(), difference).is_zero());
  CHECK_THROWS_AS(exact_quotient(Bivariate({Polynomial{1}}), difference), DomainError);
}

}  // namespace eliminant_test
