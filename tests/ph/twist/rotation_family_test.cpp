#include "phrame/ph/twist/rotation_family.hpp"

#include "phrame/algebra/error.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace rotation_family_test {

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

constexpr long bits = 200;

TwistPiece piece_of(const Curve& curve, const FrameAngle& from, const FrameAngle& to) {
  return twist_pieces(MinimalTwist(PathAngle(PhPath(curve)), from, to), {}).front();
}

RealBall half(const RealBall& x) { return divide(x, RealBall(2, bits), bits); }

/// w(τ).
ComplexBall value(const Rotation& w, const Rational& tau) {
  return {evaluate(w.a, RealBall(tau, bits), bits), evaluate(w.b, RealBall(tau, bits), bits)};
}

/// θ′ = 2(ab′ − a′b)/(a² + b²).
RealBall rate(const Rotation& w, const Rational& tau) {
  const RealBall at(tau, bits);
  const RealBall cross = evaluate(wronskian(w, bits), at, bits);
  return divide(add(cross, cross, bits), evaluate(norm(w, bits), at, bits), bits);
}

}  // namespace

// What the header says of all members, at any parameters.
TEST_CASE("rotation family: law: orientations and rates at the ends are those of the piece") {
  for_samples(40, [](Random& random) {
    const FrameAngle to{Rational(random.integer(-39, 39), 40), random.rational()};
    const TwistPiece piece = piece_of(quintic, {}, to);
    const long degree = random.integer(1, 4);
    const EndRates rates = degree > 1 && random.chance(2) ? EndRates::matched : EndRates::free;
    CAPTURE(degree);
    const RotationFamily family = rotation_family(piece, degree, rates, bits);
    std::vector<Rational> parameters;
    for (std::size_t k = 0; k < family.parameters(); ++k)
      parameters.emplace_back(random.integer(-30, 30), 10);
    const Rotation w = member(family, parameters, bits);
    CHECK(value(w, 0).re().contains(1));
    CHECK(value(w, 0).im().contains_zero());
    // w(1) = γ·e^{iΔθ/2}.
    const RealBall gamma = end_factor(family, parameters, bits);
    const auto [cos, sin] = cos_sin(half(piece.turn.enclose(bits)), bits);
    CHECK(value(w, 1).re().overlaps(multiply(gamma, cos, bits)));
    CHECK(value(w, 1).im().overlaps(multiply(gamma, sin, bits)));
    if (rates == EndRates::free || gamma.contains_zero()) return;
    CHECK(rate(w, 0).overlaps(piece.first_rate().enclose(bits)));
    CHECK(rate(w, 1).overlaps(piece.last_rate().enclose(bits)));
    CHECK(rate(w, 1).accuracy_bits() > 80);
  });
}

// w = 1 + iτ turns by 2·arctan τ; its Bernstein coefficients of degree 2 are 1, 1 + i/2, 1 + i.
TEST_CASE("rotation family: norm, Wronskian, Bernstein coefficients and turn of 1 + it") {
  const Rotation w{BallPolynomial(Polynomial{1}, bits), BallPolynomial(Polynomial{0, 1}, bits)};
  const RealBall at(Rational(1, 3), bits);
  CHECK(evaluate(norm(w, bits), at, bits).contains(Rational(10, 9)));
  CHECK(evaluate(wronskian(w, bits), at, bits).contains(1));
  const auto turned = turn(w, 0, 1, bits);
  REQUIRE(turned);
  CHECK(turned->overlaps(half(pi(bits))));
  const auto coefficients = to_bernstein(w, 2, bits);
  REQUIRE(coefficients.size() == 3);
  for (long k = 0; k < 3; ++k) {
    CHECK(coefficients[static_cast<std::size_t>(k)].re().contains(1));
    CHECK(coefficients[static_cast<std::size_t>(k)].im().contains(Rational(k, 2)));
  }
  // −1 + 2τ has a zero on the way.
  const Rotation through{BallPolynomial(Polynomial{-1, 2}, bits), BallPolynomial({}, bits)};
  CHECK_FALSE(turn(through, 0, 1, bits).has_value());
}

TEST_CASE("rotation family: degrees that cannot do what is asked") {
  const TwistPiece piece = piece_of(quintic, {}, {Rational(1, 2), 0});
  CHECK_THROWS_AS(rotation_family(piece, 0, EndRates::free, bits), DomainError);
  CHECK_THROWS_AS(rotation_family(piece, 1, EndRates::matched, bits), DomainError);
}

}  // namespace rotation_family_test
