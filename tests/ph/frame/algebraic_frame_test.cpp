#include "phrame/ph/frame/algebraic_frame.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

/// A = 1 + tk: r′ = (1 − t², 2t, 0), tangent (1 − t², 2t, 0)/(1 + t²).
const Curve plane({{1}, {}, {}, {0, 1}});

AlgebraicPoint root(const Polynomial& p, const Interval& in) {
  return AlgebraicPoint(real_root(p, in));
}

void check_near(const Vector<Real>& a, const Vector<Real>& b, const Rational& distance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RealBall difference = subtract(a[k].enclose(200), b[k].enclose(200), 200);
    CHECK(abs(difference.lower()) < distance);
    CHECK(abs(difference.upper()) < distance);
  }
}

Vector<Real> real(const Vector<Rational>& v) { return {v[0], v[1], v[2]}; }

void check_frame(const Vector<Real>& v, const std::array<const char*, 3>& expected) {
  for (std::size_t k = 0; k < 3; ++k) CHECK(round_to_decimal(v[k], 25).value == expected[k]);
}

}  // namespace

// mpmath, 50 digits: t by its root finder from quadrature of |r′|, θ by quadrature of −e₂′·e₃, n
// and b from numerical derivatives of the hodograph.
TEST_CASE("algebraic frame: half way along the quintic of Farouki 2003") {
  const AlgebraicPoint t(ArcLength(quintic).algebraic_parameter(Rational(71, 30)));
  AlgebraicFrames frames(quintic);
  const auto rmf = frames.rotation_minimizing(t);
  check_frame(rmf.e1, {"-0.3330403726291162579534344", "0.2991900353124652952079518",
                       "0.8941864643175858094998478"});
  check_frame(rmf.e2, {"-0.9248051913202022048992536", "-0.2886018189036763199816684",
                       "-0.2478797051650130834070122"});
  check_frame(rmf.e3, {"0.1839007022995387769941454", "-0.9095022335845115378977071",
                       "0.3728085551573636111281197"});
  const auto frenet = frames.frenet(t);
  check_frame(frenet.e2, {"-0.8434130617181720377099963", "0.3294860547741283852844979",
                          "-0.4243740649857846752157198"});
  check_frame(frenet.e3, {"-0.4215904618492196339185641", "-0.8955022403540405655741740",
                          "0.1426086252603812361722378"});
}

TEST_CASE("algebraic frame: law: at rational t it is what Frames says") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational t(random.integer(-8, 8), 5);
    const AlgebraicPoint point(t);
    AlgebraicFrames algebraic(curve);
    const Frames frames(curve);
    const Rational tiny = parse_rational("1e-40");
    const auto erf = frames.euler_rodrigues(t);
    CHECK(algebraic.euler_rodrigues(point).e2[1].exact() == erf.e2[1]);
    check_near(algebraic.euler_rodrigues(point).e3, real(erf.e3), tiny);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const auto rmf = frames.rotation_minimizing(angle, t);
    check_near(algebraic.rotation_minimizing(point).e2, rmf.e2, tiny);
    check_near(algebraic.rotation_minimizing(point).e3, rmf.e3, tiny);
    const GaussianPolynomial g = bend_numerator(curve.preimage());
    if (norm(g)(t) == 0) return;
    check_near(algebraic.frenet(point).e2, frames.frenet(t).e2, tiny);
    check_near(algebraic.frenet(point).e3, frames.frenet(t).e3, tiny);
  });
}

TEST_CASE("algebraic frame: law: it is continuous: next to an irrational t it is nearly the same") {
  for_samples(20, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const AlgebraicPoint point = root({-random.integer(2, 3), 0, 0, 1}, {Rational(0), {}});
    const Rational t = point.enclose(200).lower();
    if (norm(bend_numerator(curve.preimage()))(t) < Rational(1, 1000)) return;
    AlgebraicFrames algebraic(curve);
    const Frames frames(curve);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const Rational small = parse_rational("1e-20");
    const auto rmf = frames.rotation_minimizing(angle, t);
    check_near(algebraic.rotation_minimizing(point).e1, rmf.e1, small);
    check_near(algebraic.rotation_minimizing(point).e2, rmf.e2, small);
    check_near(algebraic.rotation_minimizing(point).e3, rmf.e3, small);
    check_near(algebraic.frenet(point).e2, frames.frenet(t).e2, small);
    check_near(algebraic.frenet(point).e3, frames.frenet(t).e3, small);
  });
}

// At t = 1/√2 the tangent is (1/2, √2, 0)/(3/2).
TEST_CASE("algebraic frame: components that are rational at an irrational t are exact") {
  const AlgebraicPoint t = root({-1, 0, 2}, {Rational(0), {}});
  AlgebraicFrames frames(plane);
  const auto erf = frames.euler_rodrigues(t);
  CHECK(erf.e1[0].exact() == Rational(1, 3));
  CHECK_FALSE(erf.e1[1].exact().has_value());
  CHECK(erf.e1[2].exact() == 0);
  // Its ERF is rotation-minimizing.
  CHECK(frames.rotation_minimizing(t).e2[1].exact() == Rational(1, 3));
  CHECK(frames.rotation_minimizing(t).e3[2].exact() == 1);
  // n is the tangent turned to the left, b = k.
  const auto frenet = frames.frenet(t);
  CHECK(frenet.e2[1].exact() == Rational(1, 3));
  CHECK(frenet.e2[0].enclose(64).upper() < 0);
  CHECK(frenet.e3[2].exact() == 1);
}

TEST_CASE("algebraic frame: Frenet is refused on a line and at an irrational inflection") {
  const AlgebraicPoint t = root({-1, 0, 2}, {Rational(0), {}});
  AlgebraicFrames line(Curve({{1, 1}, {}, {}, {}}));
  CHECK_THROWS_WITH_AS(line.frenet(t), doctest::Contains("straight line"), DomainError);
  // A = 1 + (2t³/3 − t)k: g = 2t² − 1.
  AlgebraicFrames inflected(Curve({{1}, {}, {}, {0, -1, 0, Rational(2, 3)}}));
  CHECK_THROWS_WITH_AS(inflected.frenet(t), doctest::Contains("inflection"), DomainError);
  CHECK_NOTHROW(inflected.rotation_minimizing(t));
}

TEST_CASE("algebraic frame: through an irrational cusp by continuity") {
  const Polynomial c{-1, 0, 2};
  const Curve smooth({{1}, {0, 1}, {2}, {0, 0, 1}});
  const Curve cusped({c, c * Polynomial{0, 1}, Rational(2) * c, c * Polynomial{0, 0, 1}});
  const AlgebraicPoint t = root(c, {Rational(0), {}});
  AlgebraicFrames a(smooth);
  AlgebraicFrames b(cusped);
  check_near(a.rotation_minimizing(t).e2, b.rotation_minimizing(t).e2, parse_rational("1e-40"));
  check_near(a.frenet(t).e3, b.frenet(t).e3, parse_rational("1e-40"));
}
