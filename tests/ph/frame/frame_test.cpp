#include "phrame/ph/frame/frame.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace frame_test {

using namespace phrame;
using test::class_one;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 200;

RealBall ball(const Real& x) { return x.enclose(bits); }

RealBall dot(const Vector<Real>& a, const Vector<Real>& b) {
  RealBall sum;
  for (std::size_t k = 0; k < 3; ++k) sum = add(sum, multiply(ball(a[k]), ball(b[k]), bits), bits);
  return sum;
}

void check_orthonormal(const Frame<Real>& f) {
  for (const auto* v : {&f.e1, &f.e2, &f.e3}) CHECK(dot(*v, *v).contains(1));
  CHECK(dot(f.e1, f.e2).contains_zero());
  CHECK(dot(f.e2, f.e3).contains_zero());
  CHECK(dot(f.e3, f.e1).contains_zero());
  // Right-handed: e₁ × e₂ = e₃ in the first component.
  const RealBall x = subtract(multiply(ball(f.e1[1]), ball(f.e2[2]), bits),
                              multiply(ball(f.e1[2]), ball(f.e2[1]), bits), bits);
  CHECK(x.overlaps(ball(f.e3[0])));
}

}  // namespace

// Six components of a frame were 0 by more than 1000 bits of an angle.
TEST_CASE("frame: a component 0 that is not seen to be exact needs few bits of θ") {
  const Real zero([](long precision) { return RealBall(power_of_two(-precision), precision); });
  const Real one([](long precision) { return RealBall(Rational(1), precision); });
  long most = 0;
  const Real theta([&most](long precision) {
    most = std::max(most, precision);
    return RealBall(Rational(1, 3), precision);
  });
  const Frame<Real> axes{Vector<Real>{zero, one, zero}, Vector<Real>{one, zero, zero},
                         Vector<Real>{zero, zero, one}};
  const Frame<Real> frame = turned(axes, theta);
  CHECK(round_to_double(frame.e2[1]) == 0);
  CHECK(round_to_double(frame.e3[1]) == 0);
  CHECK(most < 100);
  CHECK(round_to_double(frame.e2[0]) == 0.9449569463147377);  // cos 1/3, sin 1/3: mpmath
  CHECK(round_to_double(frame.e2[2]) == 0.32719469679615226);
  CHECK(frame.e2[0].enclose(400).is_accurate(390));
  CHECK(most > 400);
}

TEST_CASE("frame: law: ERF, Frenet and RMF are orthonormal and right-handed, along r′") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational t = Rational(random.integer(-9, 9), 4);
    const auto erf = euler_rodrigues_frame(curve, t);
    CHECK(dot(erf.e1, erf.e1) == 1);
    CHECK(dot(erf.e1, erf.e2) == 0);
    CHECK(cross(erf.e1, erf.e2) == erf.e3);
    const auto r1 = evaluate(hodograph(curve), t);
    CHECK(cross(erf.e1, r1) == Vector<Rational>{});
    CHECK(dot(erf.e1, r1) >= 0);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    check_orthonormal(rotation_minimizing_frame(curve, angle, t));
  });
}

TEST_CASE("frame: law: Frenet is the frame of r′ and r″") {
  for_samples(60, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational t = Rational(random.integer(-9, 9), 4);
    const auto hodograph_at = hodograph(curve);
    const auto r1 = evaluate(hodograph_at, t);
    const Vector<Polynomial> second{differentiate(hodograph_at[0]), differentiate(hodograph_at[1]),
                                    differentiate(hodograph_at[2])};
    const auto r2 = evaluate(second, t);
    const auto binormal = cross(r1, r2);
    if (dot(binormal, binormal) == 0) return;
    const auto frenet = frenet_frame(curve, t);
    check_orthonormal(frenet);
    // b is r′ × r″ over its length.
    const RealBall length = sqrt(RealBall(dot(binormal, binormal), bits), bits);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(divide(RealBall(binormal[k], bits), length, bits).overlaps(ball(frenet.e3[k])));
  });
}

TEST_CASE("frame: law: both angles describe the same rotation-minimizing frames") {
  // f(t) from the ERF and from the Frenet frame differ by one constant rotation: their angle at t
  // is that at 0. With c + is = (e₂·n + i e₂·b): θ_F(t) − θ_E(t) turns (n, b) back onto (e₂, e₃).
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    if (is_zero(bend_numerator(curve.preimage()))) return;
    const Rational t = Rational(random.integer(1, 8), 4);
    const Polynomial g_common =
        gcd(bend_numerator(curve.preimage()).re, bend_numerator(curve.preimage()).im);
    if (count_real_roots(g_common, closed_interval(0, t)) > 0) return;
    RmfAngle erf(curve, Reference::euler_rodrigues);
    RmfAngle frenet(curve, Reference::frenet);
    const RealBall difference = subtract(frenet.enclose(t, bits), erf.enclose(t, bits), bits);
    const auto angle_of_n = [&](const Rational& at) {  // of n in (e₂, e₃)
      const auto base = euler_rodrigues_frame(curve, at);
      const auto n = frenet_frame(curve, at).e2;
      RealBall angle;
      arb_atan2(angle.raw(), dot(n, {base.e3[0], base.e3[1], base.e3[2]}).raw(),
                dot(n, {base.e2[0], base.e2[1], base.e2[2]}).raw(), bits);
      return angle;
    };
    // θ_E − θ_F = angle_of_n(t) − angle_of_n(0) modulo 2π.
    const RealBall sum = add(difference, subtract(angle_of_n(t), angle_of_n(0), bits), bits);
    CHECK(cos_sin(sum, bits).cos.contains(1));
  });
}

TEST_CASE("frame: rotation-minimizing: f₂ only ever moves along the tangent, by differences") {
  // (f₂(t + ε) − f₂(t))/ε has no part along f₃ beyond O(ε).
  const Curve curve({{1, 2}, {3, 0, 1}, {0, 1}, {2, -1}});
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const Rational t(2, 5);
  const Rational epsilon = parse_rational("1e-20");
  const auto now = rotation_minimizing_frame(curve, angle, t);
  const auto next = rotation_minimizing_frame(curve, angle, t + epsilon);
  const RealBall drift = dot(next.e2, now.e3);  // f₂(t)·f₃(t) = 0
  CHECK(abs(drift.upper()) < parse_rational("1e-38"));
  const RealBall bend = dot(next.e2, now.e1);
  CHECK(abs(bend.upper()) > parse_rational("1e-22"));  // it does move
}

TEST_CASE("frame: exact values: at t = 0, with h = 0, and through a cusp") {
  const Curve curve({{1, 2}, {3}, {0, 1}, {2, -1}});
  RmfAngle angle(curve, Reference::euler_rodrigues);
  const auto start = rotation_minimizing_frame(curve, angle, 0);
  const auto erf = euler_rodrigues_frame(curve, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(start.e2[k].exact() == erf.e2[k]);
    CHECK(start.e3[k].exact() == erf.e3[k]);
  }
  const Polynomial factor{-1, 2};
  const Curve cusped({factor * Polynomial{1, 2}, factor * Polynomial{3}, factor * Polynomial{0, 1},
                      factor * Polynomial{2, -1}});
  CHECK(euler_rodrigues_frame(cusped, Rational(1, 2)).e2 ==
        euler_rodrigues_frame(curve, Rational(1, 2)).e2);
}

TEST_CASE("frame: a rational rotation-minimizing frame is exact, and 0 where it is") {
  // (1 + tk)(1 + ti): in the plane z = 0, e₂(0) = j, so that f₃ is k.
  const Curve plane({{1}, {0, 1}, {0, 0, 1}, {0, 1}});
  RmfAngle angle(plane, Reference::euler_rodrigues);
  const auto frame = rotation_minimizing_frame(plane, angle, Rational(1, 2));
  CHECK(euler_rodrigues_frame(plane, Rational(1, 2)).e3[2] != 1);
  CHECK(frame.e2[0].exact() == Rational(-4, 5));
  CHECK(frame.e2[1].exact() == Rational(3, 5));
  CHECK(frame.e2[2].exact() == 0);
  CHECK(frame.e3[2].exact() == 1);
  CHECK(round_to_decimal(frame.e3[0], 50).value == "0");
}

TEST_CASE("frame: law: a rational rotation-minimizing frame is the turned one") {
  for_samples(30, [](Random& random) {
    const QuaternionPolynomial w{random.polynomial(2), random.polynomial(2), {}, {}};
    if (is_zero(w)) return;
    const Curve curve(class_one * w);
    const Rational t = random.rational();
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const auto frame = rotation_minimizing_frame(curve, angle, t);
    const auto expected = turned(as_real(euler_rodrigues_frame(curve, t)), angle.value(t));
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(frame.e2[k].exact());
      REQUIRE(frame.e3[k].exact());
      CHECK(ball(expected.e2[k]).contains(*frame.e2[k].exact()));
      CHECK(ball(expected.e3[k]).contains(*frame.e3[k].exact()));
    }
  });
}

TEST_CASE("frame: law: rational components have odd denominators: none is half way between two") {
  for_samples(60, [](Random& random) {
    const auto frame =
        euler_rodrigues_frame(Curve(random.quaternion_polynomial(3)), random.rational());
    for (const auto* v : {&frame.e1, &frame.e2, &frame.e3})
      for (const Rational& x : *v) CHECK(denominator(x) % 2 == 1);
  });
}

TEST_CASE("frame: the sign of the multiplier does not change the frames; e₁ is then −r′/|r′|") {
  const QuaternionPolynomial a{{1, 2}, {3}, {0, 1}, {2, -1}};
  const Curve ahead(a);
  const Curve back(a, Polynomial{-2});
  const Rational t(1, 3);
  const auto erf = euler_rodrigues_frame(back, t);
  CHECK(erf.e1 == euler_rodrigues_frame(ahead, t).e1);
  CHECK(erf.e2 == euler_rodrigues_frame(ahead, t).e2);
  CHECK(dot(erf.e1, evaluate(hodograph(back), t)) < 0);
  CHECK(dot(erf.e1, evaluate(hodograph(ahead), t)) > 0);
}

TEST_CASE("frame: Frenet is refused on a line and at an inflection, by name") {
  CHECK_THROWS_WITH_AS(frenet_frame(Curve({{1, 1}, {}, {}, {}}), 1),
                       doctest::Contains("straight line"), DomainError);
  // A(t²) has an inflection at 0.
  const Curve curve({{1}, {2}, {0, 0, 1}, {0, 0, 3}});
  CHECK_THROWS_WITH_AS(frenet_frame(curve, 0), doctest::Contains("t = 0 is an inflection"),
                       DomainError);
  CHECK_NOTHROW(frenet_frame(curve, 1));
}

TEST_CASE("frame: doubles are the exact components, rounded") {
  const Curve curve({{1, 2}, {3}, {0, 1}, {2, -1}});
  const auto erf = euler_rodrigues_frame(curve, Rational(1, 3));
  const auto rounded = round_to_double(erf.e1);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational error = abs(exact_rational(rounded[k]) - erf.e1[k]);
    CHECK(error <= parse_rational("0x1p-54"));
  }
}

}  // namespace frame_test
