#include "phrame/algebra/increasing.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

std::shared_ptr<const IncreasingFunction> function_of(const Polynomial& p) {
  const auto f = std::make_shared<IncreasingFunction>();
  f->value = [p](const RealBall& t, long bits) { return evaluate(p, t, bits); };
  f->slope = [d = differentiate(p)](const RealBall& t, long bits) { return evaluate(d, t, bits); };
  return f;
}

/// ∫₀ᵗ q², which increases.
Polynomial increasing(const Polynomial& q) { return antiderivative(q * q); }

}  // namespace

TEST_CASE("increasing: law: the enclosure holds the preimage, whatever the guess") {
  for_samples(60, [](Random& random) {
    const Polynomial q = random.nonzero_polynomial(3);
    // The second one decreases beyond [0, 1].
    const Polynomial p =
        random.chance(2) ? increasing(q) : antiderivative(q * q * Polynomial{0, 1, -1});
    Rational t(random.integer(0, 60), 60);
    if (random.chance(3))
      t = 1 / Rational(pow(Integer(10), static_cast<unsigned>(random.integer(1, 40))));
    if (random.chance(3)) t = 1 - t;
    for (const double guess : {0.0, 0.3, 1.0, round_to_double(Real(t))}) {
      const auto f = function_of(p);
      CHECK(enclose_preimage(*f, p(t), guess).contains(t));
      const long bits = random.integer(1, 300);
      const RealBall ball = preimage(f, p(t), guess).enclose(bits);
      CHECK(ball.contains(t));
      CHECK(ball.radius() * Rational(Integer(1) << static_cast<unsigned>(bits)) <= 1);
    }
  });
}

TEST_CASE("increasing: a good guess is proved at once, a steep start is no harm") {
  const auto f = function_of({0, 1, 1});  // t² + t = 3/4 at t = 1/2
  const RealBall ball = enclose_preimage(*f, Rational(3, 4), 0.5 + 1e-12);
  CHECK(ball.contains(Rational(1, 2)));
  CHECK(ball.radius() < parse_rational("1e-17"));
  CHECK(ball.radius() > 0);
  // (t − 1/2)³/3 + 1/24 is flat at 1/2, where Newton's method jumps away: t − 1/2 = ∛(3·10⁻³⁰).
  const auto flat = function_of(increasing({Rational(-1, 2), 1}));
  const Real t = preimage(flat, Rational(1, 24) + parse_rational("3e-30") / 3, 0.5);
  CHECK(round_to_decimal(t, 22).value == "0.5000000001442249570307");  // ∛3 = 1.442249570307408…
}

// t³ + t − 1 has the root 0.68232780382801932736948373971104825689…, OEIS A263719.
TEST_CASE("increasing: a zero of the slope at the very place costs bits, not correctness") {
  const Polynomial g{-1, 1, 0, 1};
  const auto f = function_of(pow(g, 3));
  CHECK(round_to_decimal(preimage(f, 0, 0.68), 30).value == "0.682327803828019327369483739711");
  CHECK(round_to_decimal(preimage(f, 0, 0), 30).value == "0.682327803828019327369483739711");
}

TEST_CASE("increasing: where the function is known to no more than 2⁻²⁰, the limit is named") {
  const auto f = std::make_shared<IncreasingFunction>();
  f->value = [](const RealBall& t, long) {
    RealBall blurred = t;
    arb_add_error_2exp_si(blurred.raw(), -20);
    return blurred;
  };
  f->slope = [](const RealBall&, long bits) { return RealBall(1, bits); };
  CHECK_THROWS_WITH_AS(preimage(f, Rational(1, 3), 0.5).enclose(40),
                       doctest::Contains("bits of precision do not give 40 bits"), Undecided);
  CHECK(preimage(f, Rational(1, 3), 0.5).enclose(18).contains(Rational(1, 3)));
}

TEST_CASE("increasing: a guess is near, also from a start that is not") {
  const auto cube = function_of({0, 0, 0, 1});
  CHECK(std::abs(guess_preimage(*cube, Rational(1, 8)) - 0.5) < 1e-12);
  CHECK(std::abs(guess_preimage(*cube, Rational(1, 8), 0.999) - 0.5) < 1e-12);
  CHECK(std::abs(guess_preimage(*cube, Rational(1, 1000), 0) - 0.1) < 1e-12);
}
