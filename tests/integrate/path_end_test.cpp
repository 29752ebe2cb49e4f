#include "phrame/integrate/path_end.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 150;

PiValue of_pi(const Polynomial& p) { return {RationalFunction(p)}; }
const PiValue pi_itself = of_pi({0, 1});

RationalFunction polynomial(const Polynomial& p) { return RationalFunction(p); }

}  // namespace

TEST_CASE("path end: integrals to pi that are known") {
  // ∫₀^π 2t dt = π², ∫ from π to 2π of dt/t = log 2 = ∫₁² dt/t.
  const RealBall pi_ball = pi(bits);
  const DefiniteIntegral square = path_integral(polynomial({0, 2}), Rational(0), pi_itself);
  CHECK(square.value.enclose(bits).overlaps(multiply(pi_ball, pi_ball, bits)));
  CHECK(square.value.enclose(bits).is_accurate(bits - 8));
  const RationalFunction inverse({1}, {0, 1});
  const RealBall log_two = Evaluator(integrate(inverse)).difference(1, 2, bits);
  CHECK(path_integral(inverse, pi_itself, of_pi({0, 2})).value.enclose(bits).overlaps(log_two));
  CHECK(path_integral(inverse, of_pi({0, 2}), pi_itself)
            .value.enclose(bits)
            .overlaps(subtract(RealBall(), log_two, bits)));
  // To ∞: 1/π.
  const RationalFunction inverse_square({1}, {0, 0, 1});
  CHECK(path_integral(inverse_square, pi_itself, Infinity::positive)
            .value.enclose(bits)
            .overlaps(divide(RealBall(1, bits), pi_ball, bits)));
}

// log(1 + x) = x + …, 10⁻⁵⁰⁰⁰·π and log((π + 10⁻⁵⁰⁰⁰π)/π) = log(1 + 10⁻⁵⁰⁰⁰).
TEST_CASE("path end: small integrals, with the digits that were asked for") {
  const Rational small = power_of_ten(-5000);
  const RationalFunction inverse({1}, {0, 1});
  const auto digits = [&](const PathEnd& a, const PathEnd& b) {
    return round_to_decimal(path_integral(inverse, a, b).value, 10).value;
  };
  CHECK(digits(Rational(1), of_pi({1, small})) == "3.141592654e-5000");
  CHECK(digits(pi_itself, of_pi({0, 1 + small})) == "1.000000000e-5000");
}

TEST_CASE("path end: rational values are exact") {
  const auto exact = [](const RationalFunction& f, const PathEnd& a, const PathEnd& b) {
    return path_integral(f, a, b).value.exact();
  };
  CHECK(exact(polynomial({1}), pi_itself, of_pi({1, 1})) == Rational(1));
  CHECK(exact(polynomial({0, 0, 0, 1}), of_pi({0, -1}), pi_itself) == Rational(0));
  CHECK(exact({{0, 1}, {1, 0, 0, 0, 1}}, of_pi({0, -1}), pi_itself) == Rational(0));
  CHECK(exact({{-1, 1}, {2, -2, 1}}, of_pi({2, -1}), pi_itself) == Rational(0));  // odd about 1
  CHECK(exact({{1}, {1, 0, 1}}, pi_itself, pi_itself) == Rational(0));
  CHECK_FALSE(exact({{1}, {1, 0, 1}}, Rational(0), pi_itself).has_value());
}

TEST_CASE("path end: poles between the ends are found, however close to pi") {
  CHECK_THROWS_AS(path_integral({{1}, {-3, 1}}, Rational(0), pi_itself), DomainError);
  const Rational below =
      parse_rational("3141592653589793238462643383279/1000000000000000000000000000000");
  const Rational above =
      parse_rational("3141592653589793238462643383280/1000000000000000000000000000000");
  CHECK_THROWS_AS(path_integral({{1}, {-below, 1}}, Rational(0), pi_itself), DomainError);
  // log((above − π)/above) is far below 0: log(10⁻³⁰/3.14…) < −70.
  const RealBall value =
      path_integral({{1}, {-above, 1}}, Rational(0), pi_itself).value.enclose(bits);
  CHECK(value.upper() < -70);
  CHECK(path_integral({{1}, {-3, 1}}, Rational(0), pi_itself, AtPoles::principal_value)
            .value.enclose(bits)
            .is_finite());
}

TEST_CASE("path end: law: a path through pi has the integral of its two parts") {
  for_samples(30, [](Random& random) {
    const RationalFunction f(random.polynomial(3), random.nonzero_polynomial(4));
    const PiValue middle = of_pi({random.rational(), 1});
    if (count_real_roots(f.denominator(), closed_interval(-20, 20)) > 0) return;
    const RealBall left = path_integral(f, Rational(-5), middle).value.enclose(bits);
    const RealBall right = path_integral(f, middle, Rational(7)).value.enclose(bits);
    const RealBall whole = Evaluator(integrate(f)).difference(-5, 7, bits);
    CHECK(add(left, right, bits).overlaps(whole));
    CHECK(add(left, right, bits).is_accurate(bits / 2));
  });
}
