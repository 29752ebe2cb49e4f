#include "phrame/ph/offset/offset_kind.hpp"

#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

namespace offset_kind_test {

using namespace phrame;
using Kind = OffsetKind::Kind;

namespace {

RationalCurve plane_curve(const Polynomial& x, const Polynomial& y) {
  return RationalCurve({x, y, Polynomial()});
}

/// The curve with r′ = z as x + iy, of complex coefficients z = (x, y).
RationalCurve with_hodograph(const Polynomial& x, const Polynomial& y) {
  return plane_curve(antiderivative(x), antiderivative(y));
}

/// |r_d − r|² = d², and r_d − r is across r′, at t = t(m).
void check_law(const RationalCurve& curve, const TwoSidedOffset& offset, const Rational& d) {
  const auto at = [&](const Polynomial& p) {
    return compose(RationalFunction(p), offset.parameter);
  };
  Vector<RationalFunction> gap;
  for (std::size_t k = 0; k < 2; ++k)
    gap[k] = RationalFunction(offset.numerator[k], offset.weight) -
             compose(RationalFunction(curve.numerator()[k], curve.weight()), offset.parameter);
  CHECK(gap[0] * gap[0] + gap[1] * gap[1] == RationalFunction(Polynomial{d * d}));
  CHECK((gap[0] * at(curve.direction()[0]) + gap[1] * at(curve.direction()[1])).is_zero());
}

}  // namespace

TEST_CASE("offset_kind: the parabola's offset is Lü's sextic, by t = (s² − 16)/(16s)") {
  const RationalCurve parabola = plane_curve({0, 1}, {0, 0, 1});
  const OffsetKind kind = offset_kind(parabola);
  CHECK(kind.kind == Kind::two_sided);
  CHECK(kind.squarefree == Polynomial{1, 0, 4});
  REQUIRE(kind.conic);
  // s = −4m: the slides' parameter.
  CHECK(compose(RationalFunction({-16, 0, 1}, {0, 16}), Polynomial{0, -4}) ==
        (*kind.conic->form)[0]);
  for (const Rational& d : {Rational(1), Rational(1, 3)}) {
    const TwoSidedOffset offset = two_sided_offset(parabola, kind, d, 20);
    check_law(parabola, offset, d);
    // X_d, Y_d and W_d of the slides at s = −4m; the other sign of d is the other sign of s.
    const Polynomial s{0, -4};
    const auto by_s = [&](const Polynomial& p) { return compose(p, s); };
    const Polynomial w = by_s({0, 0, 4096, 0, 256});
    const auto is_theirs = [&](const Rational& e) {
      return offset.numerator[0] * w ==
                 offset.weight * by_s({0, -4096, -4096 * e, 0, 256 * e, 16}) &&
             offset.numerator[1] * w == offset.weight * by_s({4096, 0, -256, -2048 * e, -16, 0, 1});
    };
    CHECK((is_theirs(d) || is_theirs(-d)));
    // f_d(x, y) = 0, with the sextic of the slides.
    const RationalFunction x(offset.numerator[0], offset.weight);
    const RationalFunction y(offset.numerator[1], offset.weight);
    const auto c = [](const Rational& k) { return RationalFunction(Polynomial{k}); };
    const RationalFunction x2 = x * x, y2 = y * y, x4 = x2 * x2;
    const Rational e = d * d;
    const RationalFunction f = c(16) * (x2 + y2) * x4 - c(8) * (c(5) * x2 + c(4) * y2) * x2 * y -
                               c(48 * e - 1) * x4 - c(32 * (e - 1)) * x2 * y2 + c(16) * y2 * y2 +
                               (c(2 * (4 * e - 1)) * x2 - c(8 * (4 * e + 1)) * y2) * y +
                               c(4 * e * (12 * e - 5)) * x2 + c((4 * e - 1) * (4 * e - 1)) * y2 +
                               c(8 * e * (4 * e + 1)) * y - c(e * (4 * e + 1) * (4 * e + 1));
    CHECK(f.is_zero());
    CHECK(offset.weight.degree() == 4);
    // Its sides begin next to (0, ∓d) and end next to (1, 1) ± d(2, −1)/√5.
    REQUIRE(offset.sides.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational off = k == 0 ? d : -d;
      CHECK(abs(point(offset.sides[k], 0)[1] + off) < Rational(1, 1'000'000'000));
      const Vector<Rational> end = point(offset.sides[k], 1);
      CHECK(abs(5 * (end[0] - 1) * (end[0] - 1) - 4 * e) < Rational(1, 1'000'000'000));
      CHECK((end[0] - 1) * off > 0);
    }
  }
}

TEST_CASE("offset_kind: r′ = (kt + 1)·h·w² has a rational two-sided offset, and others have none") {
  test::Random random(20263);
  long two_sided = 0;
  for (int round = 0; round < 12; ++round) {
    const GaussianPolynomial w{random.polynomial(2), random.polynomial(2) + Polynomial{0, 0, 0, 1}};
    const Rational u = random.integer(-3, 3), v = random.integer(1, 3);
    const Polynomial h{random.integer(1, 5), random.integer(0, 2)};
    const GaussianPolynomial r = GaussianPolynomial{{1, u}, {0, v}} * w * w;
    const RationalCurve curve = with_hodograph(h * r.re, h * r.im);
    const OffsetKind kind = offset_kind(curve);
    CAPTURE(kind.squarefree);
    if (kind.squarefree.is_constant()) continue;  // (kt + 1) is a factor of w̄
    CHECK(kind.kind == Kind::two_sided);
    CHECK(kind.squarefree.degree() == 2);
    REQUIRE(kind.conic);  // it has the point (0, 1)
    ++two_sided;
    if (round < 4) {
      const TwoSidedOffset offset = two_sided_offset(curve, kind, Rational(2, 3), 9);
      check_law(curve, offset, Rational(2, 3));
    }
    // With a factor more it has genus 1.
    const GaussianPolynomial more = r * GaussianPolynomial{{2, 1}, {1, 5}};
    CHECK(offset_kind(with_hodograph(more.re, more.im)).kind == Kind::none);
  }
  CHECK(two_sided > 6);
}

TEST_CASE("offset_kind: of any parabola with long coefficients it is found without a factor") {
  test::Random random(20264);
  for (int round = 0; round < 6; ++round) {
    const auto number = [&] {
      return Rational(random.integer(1, 1L << 60)) * Rational(random.integer(1, 1L << 60)) + 1;
    };
    const RationalCurve curve =
        plane_curve({number(), number(), number()}, {number(), -number(), number()});
    const OffsetKind kind = offset_kind(curve);
    CHECK(kind.kind == Kind::two_sided);
    REQUIRE(kind.conic);
    check_law(curve, two_sided_offset(curve, kind, 3, 9), 3);
  }
}

TEST_CASE("offset_kind: fields, curves that are traced twice, circles and lines") {
  const OffsetKind line = offset_kind(plane_curve({0, 1}, {0, 1}));
  CHECK(line.kind == Kind::each_side);
  CHECK(line.radicand == 2);
  // In z = const D is c·|kt + 1|² with complex k, of which X² + Z² = |ck|²·Y² has points. In
  // another plane it may have none: y² = 2t² + 3 has none modulo 9.
  const OffsetKind oblique = offset_kind(RationalCurve(
      {Polynomial{0, 1, Rational(1, 2)}, Polynomial{0, 1, Rational(-1, 2)}, Polynomial{0, 1}}));
  CHECK(oblique.kind == Kind::two_sided);
  CHECK_FALSE(oblique.conic);
  CHECK(oblique.prime == 3);
  CHECK(oblique.radicand == 2);
  CHECK(offset_kind(plane_curve({0, 1}, {0, 0, 0, 1})).kind == Kind::none);
  // A quarter of a circle.
  const RationalCurve circle({Polynomial{1, 0, -1}, Polynomial{0, 2}, Polynomial()}, {1, 0, 1});
  CHECK(offset_kind(circle).kind == Kind::each_side);
  CHECK(offset_kind(circle).radicand == 1);
}

TEST_CASE("offset_kind: a parabola that is traced several times has its own offset") {
  // (x, x²) for x from `from` to `to`, by a polynomial of t that goes one way in (0, 1).
  const Rational from(1, 2);
  for (const Rational& to : {Rational(3), Rational(-3)})
    for (const Polynomial& s :
         {Polynomial{0, 0, 1}, Polynomial{0, Rational(1, 2), 0, Rational(1, 2)},
          Polynomial{0, Rational(2, 3), Rational(1, 3)}}) {
      const Polynomial x = Polynomial{from} + (to - from) * s;
      const OffsetKind kind = offset_kind(plane_curve(x, x * x));
      CHECK(kind.kind == Kind::two_sided);
      CHECK(kind.squarefree.degree() == 2);
      REQUIRE(kind.once);
      CHECK(kind.once->parameter == RationalFunction(s));
      const Polynomial once{from, to - from};
      CHECK(kind.once->curve.numerator()[0] == once);
      CHECK(kind.once->curve.numerator()[1] == once * once);
      const TwoSidedOffset offset = two_sided_offset(plane_curve(x, x * x), kind, 2, 20);
      CHECK(offset.once == RationalFunction(s));
      check_law(kind.once->curve, offset, 2);
    }
  // By rational functions of t of the degrees 2 and 3, and the parabola as a rational curve.
  const RationalFunction moebius({1, 2}, {3, -1});  // from 1/3 to 3/2
  for (const RationalFunction& s :
       {RationalFunction({0, 0, 2}, {1, 0, 1}), RationalFunction({0, 3, 0, 1}, {1, 0, 3})}) {
    const RationalFunction x = compose(moebius, s);
    const Polynomial w = x.denominator() * x.denominator();
    const RationalCurve traced({x.numerator() * x.denominator(), x.numerator() * x.numerator(), {}},
                               w);
    const OffsetKind kind = offset_kind(traced);
    CHECK(kind.kind == Kind::two_sided);
    REQUIRE(kind.once);
    CHECK(degree(kind.once->curve) == 2);
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)})
      CHECK(point(kind.once->curve, kind.once->parameter(t)) == point(traced, t));
    check_law(kind.once->curve, two_sided_offset(traced, kind, 2, 20), 2);
  }
  // By t²/(2t − 1) t = ∞ and t = 1/2 are one point: it is traced twice all the same.
  const auto by = [](const RationalFunction& u) {
    const RationalFunction x = compose(RationalFunction({0, 1}, {1, 0, 1}), u);
    const RationalFunction y = compose(RationalFunction({1}, {1, 0, 0, 0, 1}), u);
    return RationalCurve({x.numerator() * y.denominator(), y.numerator() * x.denominator(), {}},
                         x.denominator() * y.denominator());
  };
  const OffsetKind once = offset_kind(by(RationalFunction(Polynomial{0, 1})));
  const OffsetKind twice = offset_kind(by(RationalFunction({0, 0, 1}, {-1, 2})));
  CHECK(once.kind == Kind::none);
  CHECK(twice.kind == Kind::none);
  CHECK(once.squarefree.degree() == twice.squarefree.degree());
  // It goes from 0 to −1/12 and back, and on to 2.
  const OffsetKind back =
      offset_kind(plane_curve({0, -1, 3}, Polynomial{0, -1, 3} * Polynomial{0, -1, 3}));
  CHECK(back.kind == Kind::two_sided);
  CHECK_FALSE(back.conic);
  CHECK_FALSE(back.once);
}

TEST_CASE("offset_kind: law: of a curve by a function of t it is that of the curve") {
  long kinds = 0;
  test::for_samples(60, [&](test::Random& random) {
    const Polynomial x = random.polynomial(3);
    const Polynomial y = random.polynomial(3);
    if (differentiate(x).is_zero() || differentiate(y).is_zero()) return;
    const RationalCurve curve = plane_curve(x, y);
    const Polynomial p = random.polynomial(random.integer(1, 3));
    const Polynomial q{random.integer(1, 5), 0, random.integer(0, 3)};
    if ((differentiate(p) * q - p * differentiate(q)).is_zero()) return;
    const auto by = [&](const Polynomial& of) {
      return compose(RationalFunction(of), RationalFunction(p, q));
    };
    const Polynomial w = lcm(by(x).denominator(), by(y).denominator());
    const RationalCurve other({by(x).numerator() * exact_quotient(w, by(x).denominator()),
                               by(y).numerator() * exact_quotient(w, by(y).denominator()),
                               {}},
                              w);
    const OffsetKind expected = offset_kind(curve);
    const OffsetKind found = offset_kind(other);
    CHECK(found.kind == expected.kind);
    CHECK(found.squarefree.degree() == expected.squarefree.degree());
    if (found.once)
      for (const Rational& t : {Rational(0), Rational(2, 7), Rational(1)})
        CHECK(point(found.once->curve, found.once->parameter(t)) == point(other, t));
    if (expected.kind == Kind::none) ++kinds;
  });
  CHECK(kinds > 5);
}

}  // namespace offset_kind_test
