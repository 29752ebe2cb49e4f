#include "phrame/ph/frame/piece_guess.hpp"

#include <doctest/doctest.h>

using namespace phrame;

namespace {

/// c₀ + c₁y + …
BallPolynomial series(const std::vector<Rational>& c) {
  std::vector<RealBall> balls;
  for (const Rational& x : c) balls.emplace_back(x, 128);
  return BallPolynomial(balls);
}

/// 1 − y/ρ.
BallPolynomial zero_at(const Rational& rho) { return series({1, -1 / rho}); }

const BallPolynomial one = series({1});
const DoubleShape shape = compensated_shape(1);  // degree 16, goal 2⁻⁷⁸

}  // namespace

// The coefficient of y¹⁷ is to be above 16·2⁻⁷⁸ times something between 1 and 2.
TEST_CASE("seems_too_long: the integral of a rate with a pole, and with a zero of the radicand") {
  // ρ⁻¹⁶/17: 2⁻⁶⁸ at ρ = 16, 2⁻⁸⁴ at 32.
  CHECK(seems_too_long(one, zero_at(16), one, shape));
  CHECK_FALSE(seems_too_long(one, zero_at(32), one, shape));
  // (32 choose 16)·(4ρ)⁻¹⁶/17: 2⁻⁷¹ at ρ = 16, 2⁻⁷⁸ at 22.
  CHECK(seems_too_long(one, one, zero_at(16), shape));
  CHECK_FALSE(seems_too_long(one, one, zero_at(22), shape));
  // (1 − y/16)/(1 − y/16) = 1, (1 − y/16)/√(1 − y/16)² = 1, and 1 − y¹⁶ with a numerator of its
  // own.
  CHECK_FALSE(seems_too_long(zero_at(16), zero_at(16), one, shape));
  const BallPolynomial square = series({1, Rational(-1, 8), Rational(1, 256)});
  CHECK_FALSE(seems_too_long(zero_at(16), one, square, shape));
  std::vector<Rational> c(17);
  c[16] = Rational(1, 1L << 40);
  CHECK(seems_too_long(series(c), one, one, shape));
}

TEST_CASE("seems_too_long: rotations") {
  const BallPolynomial none = series({0});
  const auto about_e1 = [&](const Rational& rate) {
    return std::array{series({rate}), none, none, series({rate})};
  };
  // e^{iωy}: ω¹⁷/17!, 2⁻⁶⁵ at ω = 1/2 and 2⁻⁸² at 1/4; Σ of the coefficients and 1/64 make 0.5 of
  // it.
  CHECK(seems_too_long(one, about_e1(Rational(1, 2)), shape));
  CHECK_FALSE(seems_too_long(one, about_e1(Rational(1, 4)), shape));
  // With σ = 1 − y/ρ it is (1 − y/ρ)^(−iωρ): for ωρ = 1 about ρ⁻¹⁷/9, 2⁻⁵⁴ at ρ = 8 and 2⁻⁸⁸ at 32.
  CHECK(seems_too_long(zero_at(8), about_e1(Rational(1, 8)), shape));
  CHECK_FALSE(seems_too_long(zero_at(32), about_e1(Rational(1, 32)), shape));
  // σ and M have a factor in common.
  const BallPolynomial little = series({Rational(1, 32), Rational(-1, 256)});
  CHECK_FALSE(seems_too_long(zero_at(8), {little, none, none, little}, shape));
  // Each of a, b, c and d turns.
  for (std::size_t k = 0; k < 4; ++k) {
    std::array M{none, none, none, none};
    M[k] = one;
    CAPTURE(k);
    CHECK(seems_too_long(one, M, shape));
  }
}
