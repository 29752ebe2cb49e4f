#include "phrame/algebra/decomposition.hpp"

#include "phrame/algebra/resultant.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("decomposition: dt·2(t + 1)/((t + 1)⁴ + 1) is du/(u² + 1) of (t + 1)²") {
  const Polynomial u{1, 2, 1};
  const auto found = decomposition({2, 2}, u * u + Polynomial{1}, 2);
  REQUIRE(found);
  CHECK(found->inner == Polynomial{0, 2, 1});
  CHECK(found->outer_n == Polynomial{1});
  CHECK(found->outer_d == Polynomial{2, 2, 1});
  CHECK_FALSE(decomposition({1, 2}, u * u + Polynomial{1}, 2));     // h′ does not divide n
  CHECK_FALSE(decomposition({2, 2}, u * u + Polynomial{0, 1}, 2));  // d is not one of h
  CHECK_FALSE(decomposition(Polynomial{2, 2} * Polynomial{0, 1}, u * u + Polynomial{1}, 2));
}

TEST_CASE("decomposition: law: what is composed is found, of the greatest degree, and is it") {
  for_samples(80, [](Random& random) {
    const long k = random.integer(2, 4);
    const Polynomial h =
        random.nonzero_polynomial(0) * Polynomial::monomial(random.integer(1, 9), k) +
        random.polynomial(k - 1);
    const Polynomial outer_d = random.nonconstant_polynomial(3);
    const Polynomial outer_n = random.polynomial(4);
    const Polynomial d = compose(outer_d, h);
    const Polynomial n = compose(outer_n, h) * differentiate(h);
    const auto found = decomposition(n, d, k);
    REQUIRE(found);
    CHECK(found->inner.degree() == k);
    CHECK(found->inner.leading_coefficient() == 1);
    CHECK(found->inner(0) == 0);
    CHECK(compose(found->outer_d, found->inner) == d);
    CHECK(compose(found->outer_n, found->inner) * differentiate(found->inner) == n);
    const auto widest = widest_decomposition(n, d, d.degree());
    REQUIRE(widest);
    CHECK(widest->inner.degree() % k == 0);
    CHECK_FALSE(widest_decomposition(n + Polynomial::monomial(1, n.degree() + 1), d, k));
  });
}

TEST_CASE(
    "decomposition: law: the residue polynomial of what is composed is a power of the other") {
  for_samples(30, [](Random& random) {
    const Polynomial h = Polynomial::monomial(1, random.integer(2, 3)) + random.polynomial(1);
    const Polynomial outer_d = squarefree_part(random.nonconstant_polynomial(4));
    const Polynomial d = compose(outer_d, h);
    if (!is_squarefree(d)) return;
    const Polynomial outer_n = random.polynomial(4) % outer_d;
    const Polynomial residues = residue_polynomial(compose(outer_n, h) * differentiate(h), d);
    CHECK(residues == pow(residue_polynomial(outer_n, outer_d), h.degree()));
    // In a shifted variable the residues are the same.
    const Polynomial shift{random.integer(-3, 3), 1};
    CHECK(residues == residue_polynomial(compose(compose(outer_n, h) * differentiate(h), shift),
                                         compose(d, shift)));
  });
}

TEST_CASE("decomposition: an integral of what is one of t(1 − t) is 0 from 0 to 1, and not to 2") {
  const Polynomial u{0, 1, -1};
  const Polynomial d = compose(Polynomial{5, 3, 0, 1}, u);
  const Polynomial n = compose(Polynomial{1, 2, 4}, u) * differentiate(u);
  CHECK(closes(n, d, 0, 1));
  CHECK(closes(n, d, -3, 4));
  CHECK_FALSE(closes(n, d, 0, 2));
  CHECK_FALSE(closes(n + Polynomial{1}, d, 0, 1));
  // t³ − t is equal at −1, 0 and 1.
  const Polynomial cubic{0, -1, 0, 1};
  CHECK(closes({-1, 0, 3}, compose(Polynomial{7, 0, 1}, cubic), 0, 1));
  CHECK(closes({-1, 0, 3}, cubic + Polynomial{9}, -1, 1));
}
