#include "phrame/ph/curve/rational_curve.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

using namespace phrame;

namespace {

/// r′ = p·H/W², as polynomials.
void check_law(const RationalCurve& curve) {
  const Polynomial& w = curve.weight();
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(differentiate(curve.numerator()[k]) * w - curve.numerator()[k] * differentiate(w) ==
          curve.multiplier() * curve.direction()[k]);
  CHECK(gcd(gcd(curve.direction()[0], curve.direction()[1]), curve.direction()[2]).is_constant());
}

std::string complaint(const Vector<Polynomial>& numerator, const Polynomial& weight) {
  return test::refusal_of<DomainError>([&] { const RationalCurve curve(numerator, weight); });
}

}  // namespace

TEST_CASE("rational curve: a quarter of the circle [Piegl, Tiller, §7.3]") {
  // x = (1 − t²)/(1 + t²), y = 2t/(1 + t²): r′ = 2(−2t, 1 − t²)/(1 + t²)².
  const RationalCurve arc = bezier_curve({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2});
  CHECK(arc.weight() == Polynomial{1, 0, 1});
  CHECK(arc.numerator() == Vector<Polynomial>{Polynomial{1, 0, -1}, Polynomial{0, 2}, {}});
  CHECK(arc.direction() == Vector<Polynomial>{Polynomial{0, -2}, Polynomial{1, 0, -1}, {}});
  CHECK(arc.multiplier() == Polynomial{2});
  CHECK(point(arc, Rational(1, 2)) == Vector<Rational>{Rational(3, 5), Rational(4, 5), 0});
  CHECK(degree(arc) == 2);
}

TEST_CASE("rational curve: common factors and signs do not matter") {
  const Vector<Polynomial> x{Polynomial{1, 2}, Polynomial{0, 0, 1}, Polynomial{0, 1, 0, 3}};
  const Polynomial w{2, 1};
  const RationalCurve curve(x, w);
  const Polynomial factor{Rational(-1, 3), 1, 5};
  CHECK(RationalCurve({factor * x[0], factor * x[1], factor * x[2]}, factor * w) == curve);
  check_law(curve);
}

TEST_CASE("rational curve: at a cusp the direction goes on, and p changes its sign") {
  // r′ = (1 − 2t)(1, 2t, 0).
  const RationalCurve cusp({Polynomial{0, 1, -1}, Polynomial{0, 0, 1, Rational(-4, 3)}, {}});
  CHECK(cusp.direction() == Vector<Polynomial>{Polynomial{1}, Polynomial{0, 2}, {}});
  CHECK(cusp.multiplier() == Polynomial{1, -2});
  // A cusp at the start: p = t, not −t.
  const RationalCurve start({Polynomial{0, 0, -1}, Polynomial{0, 0, 0, 1}, {}});
  CHECK(start.multiplier() == Polynomial{0, 1});
  CHECK(start.direction() == Vector<Polynomial>{Polynomial{-2}, Polynomial{0, 3}, {}});
  const RationalCurve over = start.turned_over();
  CHECK(over.multiplier() == Polynomial{0, -1});
  check_law(over);
}

TEST_CASE("rational curve: what is none is refused, with the reason") {
  const Vector<Polynomial> x{Polynomial{1, 2}, Polynomial{0, 0, 1}, {}};
  CHECK(complaint(x, Polynomial{-1, 2}) == "the weight function is 0 at t = 1/2");
  CHECK(complaint(x, Polynomial{-1, 0, 2}) == "the weight function is 0 near t = 0.707107");
  CHECK(complaint(x, {}) == "the weight function is 0");
  CHECK(complaint(x, Polynomial{1, -1}) == "the weight function is 0 at t = 1");
  CHECK(complaint(x, Polynomial{-3, 2}).empty());  // at 3/2
  CHECK(complaint({Polynomial{2}, Polynomial{4}, Polynomial{}}, Polynomial{2}) ==
        "the curve is the point (1, 2, 0)");
  CHECK(complaint({Polynomial{2, 2}, {}, {}}, Polynomial{1, 1}) ==
        "the curve is the point (2, 0, 0)");
  CHECK_THROWS_AS(bezier_curve({}), DomainError);
  CHECK_THROWS_AS(bezier_curve({{0, 0, 0}, {1, 0, 0}}, {1}), DomainError);
}

TEST_CASE("rational curve: the law, of random ones with factors in common") {
  test::for_samples(20, [](test::Random& random) {
    const Polynomial common = random.nonzero_polynomial(2);
    const Polynomial root = random.polynomial(3);
    const Vector<Polynomial> x{common * random.nonconstant_polynomial(4),
                               common * random.polynomial(3), common * random.polynomial(4)};
    const Polynomial weight = root * root + Polynomial{1};
    if (x[0] % weight == Polynomial{}) return;  // it may be a point
    check_law(RationalCurve(x, weight));
  });
}
