#include "phrame/ph/curve/special_points.hpp"

#include <doctest/doctest.h>

using namespace phrame;

TEST_CASE("special points: cusps are real roots of the multiplier and of the common factor") {
  const QuaternionPolynomial a{{1}, {0, 1}, {2}, {}};
  CHECK(cusps(Curve(a), real_line()).empty());
  const Polynomial half{-1, 2};
  const Curve curve({half * a.u, half * a.v, half * a.p, half * a.q}, {-3, 1});
  // |r′| = |t − 3|·(2t − 1)²·….
  CHECK(cusps(curve, real_line()) == std::vector<RealRoot>{{Rational(1, 2), 2}, {Rational(3), 1}});
  CHECK(cusps(curve) == std::vector<RealRoot>{{Rational(1, 2), 2}});
}

TEST_CASE("special points: n and b flip at the zeros of odd order of g, and only there") {
  const auto at = [](const Rational& t, long order) { return std::vector<RealRoot>{{t, order}}; };
  // A = 1 + ck: g = c′.
  const auto flips = [](const Polynomial& c) { return odd(inflections({{1}, {}, {}, c})); };
  CHECK(flips({0, 0, 1}) == at(0, 1));
  CHECK(odd_inside(inflections({{1}, {}, {}, {0, 0, 1}})).empty());
  CHECK(flips({0, -1, 1}) == at(Rational(1, 2), 1));
  CHECK(flips(pow(Polynomial{-1, 2}, 3)).empty());
  CHECK(flips(pow(Polynomial{-1, 2}, 4)) == at(Rational(1, 2), 3));
  CHECK(odd_inside(inflections({{1}, {}, {}, pow(Polynomial{-1, 2}, 4)})) == at(Rational(1, 2), 3));
  CHECK(flips({0, -3, 1}).empty());  // at 3/2
  // A real factor of A is a double factor of g.
  const Polynomial c{-1, 3};
  CHECK(inflections({c, {}, {}, c * Polynomial{0, -1, 1}}) == at(Rational(1, 2), 1));
  CHECK(inflections({{1, 1}, {}, {}, {}}).empty());  // a straight line
}
