#include "phrame/integrate/pole_sum.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/ball_log.hpp"

namespace pole_sum_test {

using namespace phrame;

namespace {

constexpr long bits = 128;

PoleSum sum_of(const Polynomial& n, const Polynomial& d) {
  PoleSum sum;
  sum.add_term(n, d);
  return sum;
}

/// All of the ball is within 10⁻³⁰ of x.
bool is(const RealBall& ball, const RealBall& x) {
  return ball.is_accurate(100) && ball.overlaps(x);
}

RealBall log_of(const Rational& x) { return log(RealBall(x, bits), bits); }

RealBall of_pi(const Rational& multiple) {
  return multiply(pi(bits), RealBall(multiple, bits), bits);
}

}  // namespace

TEST_CASE("pole sum: the changes of log|t - 2|, arctan t and of their sum") {
  const PoleSum log_sum = sum_of({1}, {-2, 1});
  CHECK(is(log_sum.change(0, 1, bits), log_of(Rational(1, 2))));
  CHECK(is(log_sum.change(5, 3, bits), log_of(Rational(1, 3))));
  const PoleSum arctan = sum_of({1}, {1, 0, 1});
  CHECK(is(arctan.change(0, 1, bits), of_pi(Rational(1, 4))));
  CHECK(is(arctan.change(1, -1, bits), of_pi(Rational(-1, 2))));
  PoleSum both = log_sum;
  both.add_term({1}, {1, 0, 1});
  both.add_term({}, {5, 1});  // 0 adds nothing
  CHECK(both.terms().size() == 2);
  CHECK(is(both.change(0, 1, bits), add(log_of(Rational(1, 2)), of_pi(Rational(1, 4)), bits)));
}

TEST_CASE("pole sum: on a branch with |t - z| at real poles, and its limits") {
  const PoleSum log_sum = sum_of({3}, {-2, 1});  // 3·log|t − 2|, across the pole
  CHECK(is(subtract(log_sum.branch(Rational(4), bits), log_sum.branch(Rational(1), bits), bits),
           multiply(RealBall(3, bits), log_of(2), bits)));
  const PoleSum arctan = sum_of({1}, {1, 0, 1});
  const auto at = [&](const Endpoint& t) { return arctan.branch(t, bits); };
  CHECK(is(subtract(at(Infinity::positive), at(Infinity::negative), bits), of_pi(1)));
  CHECK(is(subtract(at(Rational(1)), at(Infinity::negative), bits), of_pi(Rational(3, 4))));
}

TEST_CASE("pole sum: poles are isolated once, with their residues and the nearest to 0") {
  // (t + 7)/((t − 1/1000)(t² + 4)): residues 7.001/(10⁻⁶ + 4) and, at 2i, n/d′.
  const Polynomial d = Polynomial{Rational(-1, 1000), 1} * Polynomial{4, 0, 1};
  const PoleSum sum = sum_of({7, 1}, d);
  CHECK(sum.known() == nullptr);
  const auto first = sum.isolate(64);
  CHECK(sum.isolate(32) == first);
  CHECK(sum.known() == first);
  REQUIRE(first->poles.size() == 1);
  REQUIRE(first->poles[0].real.size() == 1);
  CHECK(first->poles[0].real[0].contains(Rational(7001, 1000) / (4 + power_of_ten(-6))));
  // (7 + 2i)/((2i − 1/1000)·4i) = −(7 + 2i)/(8 + i/250).
  REQUIRE(first->poles[0].upper.size() == 1);
  const ComplexBall residue = divide(ComplexBall(RealBall(-7, bits), RealBall(-2, bits)),
                                     {RealBall(8, bits), RealBall(Rational(1, 250), bits)}, bits);
  CHECK(first->poles[0].upper[0].overlaps(residue));
  CHECK(first->nearness == -10);  // 2⁻¹⁰ < 1/1000 < 2⁻⁹
  CHECK(sum.isolate(200)->poles[0].real[0].is_accurate(150));
}

TEST_CASE("pole sum: the turns about poles with one residue may cancel") {
  // i/2·(log((t − i)/(t + i)) and the same about 3 + i: −arctan t − arctan(t − 3) + …, which by
  // t ↦ 3 − t changes by nothing between a and 3 − a if the residues are opposite.
  const auto sum = [](int sign) {
    PoleSum result;
    result.add_term({1}, {1, 0, 1});
    result.add_term({Rational(sign)}, {10, -6, 1});
    return result;
  };
  const Polynomial residues{1, 0, 4};  // ±i/2
  CHECK(sum(-1).turns_vanish(residues, {1}, 0, 3, bits));
  CHECK_FALSE(sum(1).turns_vanish(residues, {1}, 0, 3, bits));
  // A residue that is none of those named: the balls do not tell.
  CHECK_FALSE(sum(-1).turns_vanish({2, 0, 4}, {1}, 0, 3, bits));
  CHECK(sum(1).turns_vanish({1}, residues, 0, 3, bits));
}

}  // namespace pole_sum_test
