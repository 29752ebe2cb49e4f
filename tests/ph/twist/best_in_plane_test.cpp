#include "phrame/ph/twist/best_in_plane.hpp"

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 192;

std::vector<RealBall> ones(long count) {
  std::vector<RealBall> moments;
  for (long k = 1; k <= count; ++k) moments.emplace_back(Rational(1, k), bits);
  return moments;
}

Rational integral(const Polynomial& p) { return antiderivative(p)(1); }

/// J at x, by integration.
Rational objective(const Polynomial& a, const Polynomial& b, const Polynomial& s,
                   const std::array<Rational, 3>& x) {
  const Polynomial rest = x[0] * (a * a) + 2 * x[1] * (a * b) + x[2] * (b * b) - s;
  return integral(rest * rest);
}

}  // namespace

// s = D for a known x is the best D there is.
TEST_CASE("best in plane: a sum of squares is found again") {
  const Polynomial a{1, 0, 3, -1};
  const Polynomial b{0, 2, 1, 0, 5};
  const std::array<Rational, 3> x{Rational(5, 2), -1, Rational(4, 5)};
  REQUIRE(x[0] * x[2] - x[1] * x[1] == 1);
  const Polynomial s = x[0] * (a * a) + 2 * x[1] * (a * b) + x[2] * (b * b);
  const auto found =
      best_in_plane({BallPolynomial(a, bits), BallPolynomial(b, bits)}, s, ones(17), bits);
  REQUIRE(found.has_value());
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(found->best.form[k].contains(x[k]));
    CHECK(found->best.form[k].radius() < power_of_two(-64));
  }
  CHECK(found->best.multiplier.contains(0));
  CHECK(found->best.value.contains(0));
}

// No point of a grid on x₁x₃ − x₂² = 1 is better, each critical point is one of J = xᵀQx − …, and
// the best is the least of them.
TEST_CASE("best in plane: the least J, and all critical points") {
  for_samples(15, [](Random& random) {
    const auto polynomial = [&random](long degree) {
      std::vector<Rational> c;
      for (long k = 0; k <= degree; ++k) c.emplace_back(random.integer(-9, 9));
      c[0] = random.integer(1, 9);
      return Polynomial(c);
    };
    const Polynomial a = polynomial(4);
    const Polynomial b = Polynomial{0, 1} * polynomial(3);
    const Polynomial t = polynomial(4);
    const Polynomial s = t * t + Polynomial{1};
    const auto found =
        best_in_plane({BallPolynomial(a, bits), BallPolynomial(b, bits)}, s, ones(17), bits);
    REQUIRE(found.has_value());
    const auto form_of = [](const CriticalPair& pair) {
      return std::array{pair.form[0].midpoint(), pair.form[1].midpoint(), pair.form[2].midpoint()};
    };
    const Rational least = objective(a, b, s, form_of(found->best));
    CHECK(abs(least - found->best.value.midpoint()) < power_of_two(-40) * (1 + least));
    for (long u = -12; u <= 12; ++u)
      for (long v = -12; v <= 12; ++v) {
        const Rational x1 = power_of_two(u) * 3 / 2;
        const Rational x2(v, 2);
        CHECK(objective(a, b, s, {x1, x2, (1 + x2 * x2) / x1}) >= least);
      }
    REQUIRE(found->all.has_value());
    CHECK(found->all->size() % 2 == 1);  // minima are one more than saddles
    for (const CriticalPair& pair : *found->all) {
      CHECK_FALSE(is_less(pair.value, found->best.value));
      const auto x = form_of(pair);
      CHECK(abs(x[0] * x[2] - x[1] * x[1] - 1) < power_of_two(-40));
      // grad J = 2λK x.
      const Polynomial rest = x[0] * (a * a) + 2 * x[1] * (a * b) + x[2] * (b * b) - s;
      const Rational lambda = pair.multiplier.midpoint();
      const Rational size = 1 + abs(lambda) * (abs(x[0]) + abs(x[1]) + abs(x[2]));
      CHECK(abs(2 * integral(rest * a * a) - lambda * x[2]) < size * power_of_two(-30));
      CHECK(abs(2 * integral(rest * a * b) + lambda * x[1]) < size * power_of_two(-30));
      CHECK(abs(2 * integral(rest * b * b) - lambda * x[0]) < size * power_of_two(-30));
    }
  });
}

// a ↦ −a maps the plane and s to themselves: the best pairs are two, x₂ ≠ 0 and −x₂, or one.
TEST_CASE("best in plane: balls that are too wide prove nothing") {
  const Polynomial a{1, 0, 1};
  const Polynomial b{0, 1};
  const BallPolynomial wide({hull(-100, 100, bits), RealBall(1, bits)});
  CHECK_FALSE(best_in_plane({BallPolynomial(a, bits), wide}, {1}, ones(17), bits).has_value());
  const Polynomial huge = power_of_ten(300) * Polynomial{1, 1};
  const auto found =
      best_in_plane({BallPolynomial(a, bits), BallPolynomial(b, bits)}, huge, ones(17), bits);
  REQUIRE(found.has_value());
  CHECK(sign(found->best.value) > 0);
}
