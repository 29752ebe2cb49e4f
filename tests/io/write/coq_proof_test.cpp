#include "phrame/io/write/coq_proof.hpp"

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;

namespace {

std::string proof(const NamedCurve& named, const CoqQuery& query) {
  return coq_proof(answer(named.curve, query));
}

/// The theorem, without the lemmas and the proof.
std::string theorem(const std::string& text) {
  const auto start = text.find("Theorem frame :");
  return text.substr(start, text.find("Proof.", start) - start);
}

}  // namespace

// That Coq accepts such files, and rejects them for another angle, rate or frame, `./dev prove`
// shows.
TEST_CASE("Coq file: the theorem is about the angle, to half of one in its last place") {
  const std::string text = proof(test::farouki_quintic(), {1, 30});
  const std::string theta = test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"];
  CHECK(theta.starts_with("0.28585653009834106200"));
  CHECK(contains(theorem(text), "Rabs (theta 1 - 0.285856530098341062001656262803) <= 5e-31.\n"));
  CHECK(contains(text, "  ((4 * t - 4) * t + 2)\n"));  // u
  CHECK(contains(text, "  (8 * t - 4)\n"));            // u′
  CHECK(contains(text, "Definition D (t : R) := True."));
  CHECK(contains(text, "start + RInt (fun t => -2 * h (A t) (A' t) / sigma (A t)) 0 t."));
  // θ(1/2) = 0.135…: three digits, 10⁻³.
  CHECK(contains(theorem(proof(test::farouki_quintic(), {Rational(1, 2), 3})),
                 "Rabs (theta (1/2) - 0.135) <= 5e-4.\n"));
}

TEST_CASE(
    "Coq file: the start is where it is asked for, and the Frenet frame is that of the theorem") {
  const CoqQuery query{1, 20, Reference::frenet, Angle(Rational(1, 3), Rational(-1, 2))};
  const std::string text = proof(test::farouki_quintic(), query);
  CHECK(contains(text, "Definition start := (-1/2) + (1/3) * PI."));
  CHECK(contains(theorem(text), "is_derive theta t (frenet_rate (A t) (A' t) (A'' t))"));
  CHECK(contains(theorem(text), "(normal (A t) (A' t))"));
  // f₂(0) along the y axis: e₂(0) = (−4, 1, 3)·…
  const StartNormal y({0, 1, 0});
  const FrameAngle angle = start_angle(y, test::farouki_quintic().curve);
  CHECK(contains(proof(test::farouki_quintic(), {1, 20, Reference::euler_rodrigues, y}),
                 "atan (" + to_string(angle.direction.im / angle.direction.re) + ")"));
}

TEST_CASE(
    "Coq file: of a rational curve W is positive where the theorem holds, and f is over its "
    "square") {
  // r = (t, 0, 0)/(−1 − t²), r′ = (t² − 1, 0, 0)/W².
  const Polynomial square{1, 0, 1};
  const Curve curve = Curve::quotient({{1}, {}, {}, {}}, {-1, 0, 1}, {Polynomial{0, 1}, {}, {}},
                                      Rational(-1) * square);
  const std::string text = proof({"", curve}, {1, 10});
  CHECK(contains(text, "Definition W (t : R) := t * t + 1.\n"));
  CHECK(contains(text, "Definition f (t : R) := (t * t - 1) / (W t * W t).\n"));
  CHECK(contains(text, "  (((-1) * t) / W t)\n"));
  CHECK(contains(text, "Definition D (t : R) := (-1/4) < t < (5/4).\n"));
  // To the point at infinity of (t − 1/2, 0, 0)/(2 − t), which is at 2.
  const Curve pole = Curve::quotient({{1}, {}, {}, {}}, {Rational(3, 2)},
                                     {Polynomial{Rational(-1, 2), 1}, {}, {}}, {2, -1});
  CHECK_THROWS_WITH_AS(proof({"", pole}, {2, 10}), doctest::Contains("a point at infinity"),
                       DomainError);
  CHECK(contains(proof({"", pole}, {1, 10}), "< t < (5/4)."));
}

TEST_CASE("Coq file: t ≤ 0 and zeros of A and of g are refused") {
  CHECK_THROWS_AS(proof(test::farouki_quintic(), {0, 10}), DomainError);
  const Polynomial zero{-1, 2};
  const NamedCurve cusp{"", Curve({zero, zero, {}, zero * zero})};
  CHECK_THROWS_WITH_AS(proof(cusp, {1, 10}), doctest::Contains("zero between 0 and t"),
                       DomainError);
  // 1/12 beyond the ends of [0, 1/3] there is no zero yet at twice that.
  CHECK(contains(proof(cusp, {Rational(1, 3), 10}), "D (t : R) := (-1/24) < t < (3/8)."));
  // g = αβ′ − α′β = 2t − 1, up to a constant: an inflection at 1/2.
  const NamedCurve inflected{"", Curve({{1}, {}, {}, {0, -1, 1}})};
  CHECK_THROWS_WITH_AS(proof(inflected, {1, 10, Reference::frenet}),
                       doctest::Contains("an inflection"), DomainError);
  CHECK(contains(proof(inflected, {Rational(2, 5), 10, Reference::frenet}), "no_inflection"));
  // h = 0.
  CHECK(contains(theorem(proof(test::straight_line(), {1, 10})), "Rabs (theta 1 - 0) <= 5e-11"));
}
