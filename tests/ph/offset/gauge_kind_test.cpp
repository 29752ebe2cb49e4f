#include "phrame/ph/offset/gauge_kind.hpp"

#include "phrame/ph/curve/vector.hpp"
#include "support/gauges.hpp"

namespace gauge_kind_test {

using namespace phrame;
using namespace phrame::test;

namespace {

using Kind = OffsetKind::Kind;

RationalFunction of(const Polynomial& p, const RationalFunction& t) {
  return compose(RationalFunction(p), t);
}

/// Polynomial, with two simple roots of x′² + y′² at most: x′ + iy′ = (αt + β)·f·w².
RationalCurve conic_curve(Random& random) {
  for (;;) {
    const GaussianPolynomial w = random.gaussian_polynomial(1);
    const GaussianPolynomial line{Polynomial{random.rational(), random.rational()},
                                  Polynomial{random.rational(), random.rational()}};
    const GaussianPolynomial rate = line * w * w;
    if (!rate.re.is_zero() || !rate.im.is_zero())
      return RationalCurve({antiderivative(rate.re), antiderivative(rate.im), {}});
  }
}

}  // namespace

TEST_CASE("gauge kind: under the unit circle it is the kind of Euclidean offsets") {
  const Gauge circle(unit_circle());
  long two_sided = 0;
  for_samples(30, [&](Random& random) {
    const RationalCurve curve =
        random.chance(3)
            ? RationalCurve({random.nonconstant_polynomial(4), random.polynomial(4), {}})
            : conic_curve(random);
    const OffsetKind euclidean = offset_kind(curve);
    const auto found = offset_kind(curve, circle);
    CHECK(found.has_value() == (euclidean.kind != Kind::each_side || euclidean.radicand != 1));
    if (!found) return;
    // Of the circle D is a square in ℚ(i), so that nothing is to be factored.
    CHECK((found->kind == euclidean.kind || found->kind == Kind::undecided));
    CHECK(found->squarefree == euclidean.squarefree);
    if (found->kind == Kind::two_sided) ++two_sided;
  });
  CHECK(two_sided > 4);
}

TEST_CASE(
    "gauge kind: law: by m both sides are at d U(phi) from the curve, where an ellipse touches it, "
    "and the first one is to the right") {
  for_samples(10, [](Random& random) {
    const Rational a = random.integer(1, 4);
    const Rational b = random.integer(1, 4);
    const Gauge gauge(ellipse(a, 0, 0, b));
    // The image of a curve of which x′² + y′² has two simple roots has the same roots here.
    const RationalCurve flat = conic_curve(random);
    const RationalCurve curve({a * flat.numerator()[0], b * flat.numerator()[1], {}});
    const auto kind = offset_kind(curve, gauge);
    if (!kind || !kind->conic) return;
    const Rational d(random.chance(2) ? 3 : -3, 2);
    const TwoSidedOffset found = two_sided_offset(curve, gauge, *kind, d, 10);
    const RationalFunction& t = found.parameter;
    const auto step = [&](std::size_t k) {
      return RationalFunction(found.numerator[k], found.weight) - of(curve.numerator()[k], t);
    };
    const RationalFunction x = step(0);
    const RationalFunction y = step(1);
    const auto scaled = [](const Rational& c, const RationalFunction& f) {
      return RationalFunction(c * f.numerator(), f.denominator());
    };
    // The gradient of (x/a)² + (y/b)² is across r′.
    CHECK(scaled(1 / (a * a), x * x) + scaled(1 / (b * b), y * y) ==
          RationalFunction(Polynomial{d * d}));
    const auto& [hx, hy, hz] = curve.direction();
    CHECK((scaled(1 / (a * a), x * of(hx, t)) + scaled(1 / (b * b), y * of(hy, t))).is_zero());
    REQUIRE(found.sides.size() == 2);
    for (const std::size_t side : {0U, 1U}) {
      const auto& [from, to] = found.ends[side];
      const Rational m = (from + to) / 2;
      const Rational at = t(m);
      CHECK(at > 0);
      CHECK(at < 1);
      const Rational across = hx(at) * y(m) - hy(at) * x(m);
      CHECK(across.sign() == -d.sign() * (side == 0 ? 1 : -1));
      const Vector<Rational> end = point(found.sides[side], 1);
      const Vector<Rational> near = point(curve, 1);
      CHECK(abs(t(to) - 1) < Rational(1, 1000));
      CHECK(abs(end[0] - near[0]) <= abs(d) * a + Rational(1, 100));
    }
  });
}

TEST_CASE("gauge kind: fields, what is in none, and higher degrees") {
  const auto line = [](long x, long y) { return RationalCurve({Polynomial{0, x}, {0, y}, {}}); };
  const Gauge wide(ellipse(3, 0, 0, 2));
  CHECK_FALSE(offset_kind(line(1, 0), wide).has_value());
  // (9, 4)·(−y, x) for (x/3)² + (y/2)² = 1 is along (1, 1) for (9, −4)/√(3² + 2²).
  const auto slant = offset_kind(line(1, 1), wide);
  REQUIRE(slant.has_value());
  CHECK(slant->kind == Kind::each_side);
  CHECK(slant->radicand == 13);
  // x² + 2y² = 1 is along (1, 1) for (−2, 1)/√6.
  const Gauge other(plane_path({1, 0, -2}, {0, 2}, {1, 0, 2}));
  CHECK(offset_kind(line(1, 1), other)->radicand == 6);
  // (x′/3)² + (y′/2)² of (t³/3, t⁴/4 + t) is t⁴/9 + (t³ + 1)²/4.
  const auto none = offset_kind(
      RationalCurve({Polynomial{0, 0, 0, Rational(1, 3)}, {0, 1, 0, 0, Rational(1, 4)}, {}}), wide);
  REQUIRE(none.has_value());
  CHECK(none->kind == Kind::none);
  CHECK(none->squarefree.degree() == 6);
  // Both sides are 4 zeros of one factor.
  CHECK_FALSE(offset_kind(line(1, 1), Gauge(oval(Rational(1, 5)))).has_value());
}

}  // namespace gauge_kind_test
