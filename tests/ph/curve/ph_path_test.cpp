#include "phrame/ph/curve/ph_path.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/ph/curve/place.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

using namespace phrame;

TEST_CASE("path: PH curves that do not go on or turn back are refused, with what differs") {
  const auto complaint = [](const Curve& first, const Curve& second) {
    return test::refusal_of<DomainError>([&] {
      PhPath path(first);
      path.append(second);
    });
  };
  const Curve line({{1}, {}, {}, {}});
  CHECK(complaint(line, line) == "it starts at (0, 0, 0), but the spline ends at (1, 0, 0)");
  const Vector<Rational> one{1, 0, 0};
  CHECK(complaint(line, Curve(line.preimage(), {1}, one)).empty());
  CHECK(complaint(line, Curve({{1}, {}, {}, {}}, {-1}, one)) ==
        "the tangent turns back: the spline ends in the direction (1, 0, 0), and it starts in the "
        "opposite one, so that frames are undefined there");
  // By 10⁻³⁰ in the tangent: a corner.
  const Rational tiny(1, pow(Integer(10), 30));
  CHECK(complaint(line, Curve({{1}, {}, {tiny}, {}}, {1}, one)).empty());
  CHECK(continuation(line, Curve({{1}, {}, {tiny}, {}}, {1}, one)).is_corner);
  CHECK_FALSE(continuation(line, Curve(line.preimage(), {1}, one)).is_corner);
  // With A = j the same line, run through backwards by f = −1: e₁ is made continuous.
  CHECK(complaint(line, Curve({{}, {}, {1}, {}}, {-1}, one)).empty());
  CHECK_FALSE(complaint(line, Curve({{}, {}, {1}, {}}, {1}, one)).empty());
  // At a cusp the tangent is a limit: f = 1 − t and f = t, but not f = 1 − t and −t.
  const Vector<Rational> half{Rational(1, 2), 0, 0};
  const Curve slowing({{1}, {}, {}, {}}, {1, -1});
  CHECK(complaint(slowing, Curve({{1}, {}, {}, {}}, {0, 1}, half)).empty());
  CHECK_FALSE(complaint(slowing, Curve({{1}, {}, {}, {}}, {0, -1}, half)).empty());
}

TEST_CASE("path: the parameter of a joint belongs to the later segment") {
  const Curve line({{1}, {}, {}, {}});
  const PhPath path = test::chain({line, line, line});
  CHECK(path.end() == 3);
  CHECK(locate(path, 0).segment == 0);
  CHECK(locate(path, 1).segment == 1);
  CHECK(locate(path, Rational(5, 2)).t == Rational(1, 2));
  CHECK(locate(path, 3).segment == 2);
  CHECK(locate(path, 3).t == 1);
  CHECK_THROWS_AS(locate(path, Rational(-1, 9)), DomainError);
  CHECK_THROWS_AS(locate(path, Rational(28, 9)), DomainError);
}

TEST_CASE("path: the parameter along it is that of the segment after those before") {
  CHECK(parameter(PathParameter{2, Rational(1, 3)}) == Rational(7, 3));
  CHECK(algebraic_parameter(PathParameter{2, Rational(1, 3)})->rational() == Rational(7, 3));
  const RealAlgebraic root =
      real_roots(Polynomial{-1, 0, 2}, closed_interval(0, 1)).front().at;  // √(1/2)
  const RealAlgebraic along = algebraic_parameter(Place(3, root)).value();
  // (t − 3)² = 1/2.
  CHECK(sign_at(Polynomial{17, -12, 2}, along) == 0);
  CHECK(compare(along, 3) > 0);
  CHECK(parameter(Place(3, root)).enclose(90).overlaps(enclose(along, 100)));
  CHECK(value(Polynomial{0, 0, 2}, Place(3, root)).exact() == Rational(1));
  CHECK_FALSE(algebraic_parameter({3, to_real(root)}));
}
