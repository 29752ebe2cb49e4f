#include "phrame/io/write/coq_proof.hpp"

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;

namespace {

std::string proof(const NamedCurve& named, const Rational& t, long digits) {
  return coq_proof(answer(named.curve, CoqQuery{t, digits}));
}

}  // namespace

// That Coq accepts such files, and rejects them for another angle, `./dev prove` shows.
TEST_CASE("Coq file: the theorem is about the angle, to half of one in its last place") {
  const std::string text = proof(test::farouki_quintic(), 1, 30);
  const std::string theta = test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"];
  CHECK(theta.starts_with("0.28585653009834106200"));
  CHECK(contains(text, "theta = 0.285856530098341062001656262803, correctly rounded"));
  CHECK(contains(text, "(285856530098341062001656262803/1000000000000000000000000000000)"));
  CHECK(contains(
      text, "803/1000000000000000000000000000000)) <=\n      (1/2000000000000000000000000000000)"));
  CHECK(contains(text, "Definition u (t : R) := (((4) * t + (-4)) * t + (2))."));
  CHECK(contains(text, "Definition u' (t : R) := ((8) * t + (-4))."));
  CHECK(contains(text, "0 (1)"));
  // θ(1/2) = 0.135…: three digits, 10⁻³.
  CHECK(
      contains(proof(test::farouki_quintic(), Rational(1, 2), 3), "(27/200)) <=\n      (1/2000)"));
}

TEST_CASE("Coq file: t ≤ 0 and zeros of A are refused") {
  CHECK_THROWS_AS(proof(test::farouki_quintic(), 0, 10), DomainError);
  const Polynomial zero{-1, 2};
  const NamedCurve cusp{"", Curve({zero, zero, {}, zero * zero})};
  CHECK_THROWS_WITH_AS(proof(cusp, 1, 10), doctest::Contains("zero between 0 and t"), DomainError);
  CHECK_FALSE(proof(cusp, Rational(1, 3), 10).empty());
  // h = 0.
  CHECK(contains(proof(test::straight_line(), 1, 10), "theta = 0, correctly rounded"));
}
