#include "phrame/algebra/argument.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("argument: of (t − i)⁴ at t = 1, from −2π to −π") {
  GaussianPolynomial g{{1}, {}};
  for (int k = 0; k < 4; ++k) g = g * GaussianPolynomial{{0, 1}, {-1}};
  ContinuousArgument argument(g);
  CHECK(argument.difference(1, 100).overlaps(pi(100)));
}

TEST_CASE("argument: a real zero is refused") {
  CHECK_THROWS_AS(ContinuousArgument(GaussianPolynomial{{0, 1}, {0, 2}}), DomainError);
  CHECK_THROWS_AS(ContinuousArgument(GaussianPolynomial{}), DomainError);
}

TEST_CASE("argument: law: the sum over known roots, each term continuous by itself") {
  for_samples(200, [](Random& random) {
    // arg(t − z) stays in one half-plane: its principal values need no count.
    GaussianPolynomial g{{random.rational() + 30}, {random.rational()}};
    std::vector<std::pair<Rational, Rational>> roots;
    for (long k = random.integer(0, 6); k > 0; --k) {
      Rational y = random.rational();
      if (y == 0) y = 1;
      roots.emplace_back(random.rational(), y);
      g = g * GaussianPolynomial{{-roots.back().first, 1}, {-y}};
    }
    ContinuousArgument argument(g);
    const Rational t = random.rational();
    constexpr long bits = 300;
    RealBall sum;
    for (const auto& root : roots) {
      const auto principal = [&](const Rational& at) {
        const auto& [x, y] = root;
        RealBall angle;
        arb_atan2(angle.raw(), RealBall(-y, bits).raw(), RealBall(at - x, bits).raw(), bits);
        return angle;
      };
      sum = add(sum, subtract(principal(t), principal(0), bits), bits);
    }
    const RealBall difference = argument.difference(t, bits);
    CHECK(difference.overlaps(sum));
    CHECK(difference.radius() < parse_rational("1e-60"));
  });
}

// γ = (1 + it)³ = (1 − 3t²) + (3t − t³)i turns by π from 0 to √3 and by 3π/4 to 1, where x < 0.
TEST_CASE("argument: the turn and the signs of the Sturm sequence") {
  ContinuousArgument argument({{1, 0, -3}, {0, 3, 0, -1}});
  // The sequence: 1 − 3t², 3t − t³, 3t² − 1, −8t/3, 1.
  CHECK(argument.turn(1) == TurnCount{-1, "+0-0+", "-++-+"});
  CHECK(argument.turn(0) == TurnCount{0, "+0-0+", "+0-0+"});
  const RealBall turned = multiply(pi(100), RealBall(Rational(3, 4), 100), 100);
  CHECK(argument.difference(1, 100).overlaps(turned));
  // (1 + it)² is imaginary at 1; times 1 + i: 1 − 2t − t², 1 + 2t − t², 4t, −1.
  ContinuousArgument quarter({{1, 0, -1}, {0, 2}});
  CHECK(quarter.turn(1) == TurnCount{-1, "++0-", "-++-"});
}
