#include "phrame/ph/twist/minimal_twist.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "support/curves.hpp"
#include "support/farouki_moon.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::curve_of;
using test::farouki_moon;
using test::for_samples;
using test::Random;

namespace {

/// Agree to `digits` decimals.
void check_near(const Real& x, const nlohmann::json& truth, long digits) {
  CAPTURE(truth);
  const RealBall value = x.enclose(300);
  const Rational expected = parse_rational(truth.get<std::string>());
  CHECK(abs(value.lower() - expected) < power_of_ten(-digits));
  CHECK(abs(value.upper() - expected) < power_of_ten(-digits));
}

FrameAngle multiple_of_pi(const Rational& c) { return {c, 0}; }

}  // namespace

// The examples of Farouki and Moon, with the difference of the angles that their results need.
TEST_CASE("minimal twist: the three examples of the paper") {
  for (const char* name : {"example1", "example2", "example3"}) {
    CAPTURE(name);
    const auto& example = farouki_moon()[name];
    const auto& truth = example["consistent"];
    PathAngle rmf{PhPath(curve_of(example))};
    const Rational difference = parse_rational(truth["delta_theta_over_pi"].get<std::string>());
    const MinimalTwist mtf(rmf, multiple_of_pi(0), multiple_of_pi(difference));
    CHECK(to_string(mtf.length()) == truth["S"].get<std::string>());
    check_near(mtf.erf_twist(), truth["T_ERF"], 45);
    check_near(mtf.nominal_twist(), truth["T"], 45);
    check_near(mtf.twist(), truth["T_min"], 45);
    check_near(mtf.rate(), truth["Omega1_mean"], 45);
    for (const auto& [t, theta] : example["exact_MTF_theta_minus_theta_i"].items())
      check_near(mtf.value(parse_rational(t)), theta, 35);
  }
}

TEST_CASE("minimal twist: half a turn is a turn to the left, exactly") {
  PathAngle rmf{PhPath(Curve({{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}}))};  // h = 0
  for (const Rational& c : {Rational(1), Rational(-1), Rational(3), Rational(-7)}) {
    const MinimalTwist mtf(rmf, multiple_of_pi(0), multiple_of_pi(c));
    CHECK(mtf.twist().enclose(100).overlaps(pi(100)));
  }
  CHECK(MinimalTwist(rmf, multiple_of_pi(0), multiple_of_pi(4)).twist().exact() == Rational(0));
  CHECK(MinimalTwist(rmf, multiple_of_pi(0), multiple_of_pi(power_of_ten(200))).twist().exact() ==
        Rational(0));
  // By direction: from 45° to −135°.
  const MinimalTwist across(rmf, angle_of({1, 1}), angle_of({-3, -3}));
  CHECK(across.twist().enclose(100).overlaps(pi(100)));
  CHECK(across.nominal_twist().enclose(100).upper() < 0);
  const MinimalTwist radians(rmf, {0, 1}, {0, Rational(3, 2)});
  CHECK(radians.twist().exact() == Rational(1, 2));
  CHECK(radians.value(1).exact() == Rational(3, 2));
}

// T_ERF = −2.5078… by mpmath's quadrature, and T_min = T_ERF + θ_f − θ_i reduced there with 1200
// digits.
TEST_CASE("minimal twist: large angles in radians are reduced before anything is rounded") {
  PathAngle rmf{PhPath(curve_of(farouki_moon()["example3"]))};
  struct Case {
    Rational from;
    Rational to;
    const char* twist;
  };
  const Case cases[]{{0, power_of_ten(24), "2.2885952393874186555"},
                     {0, power_of_ten(30), "0.72401625073099214606"},
                     {power_of_ten(30), power_of_ten(30) + 1, "-1.5078157267568541204"},
                     {0, power_of_ten(35), "-1.2295270313402318670"},
                     {power_of_ten(35), 0, "2.4970808850061101030"},
                     {-power_of_ten(40), power_of_ten(41), "1.0172488380642664628"},
                     {0, power_of_ten(1000), "-0.078237085564486860097"}};
  for (const Case& wanted : cases) {
    CAPTURE(wanted.twist);
    const MinimalTwist mtf(rmf, {0, wanted.from}, {0, wanted.to});
    CHECK(round_to_decimal(mtf.twist(), 20).value == wanted.twist);
    // As many bits as one asks for, whatever was cancelled.
    CHECK(mtf.twist().enclose(100).accuracy_bits() > 80);
    CHECK(mtf.value(0).exact() == wanted.from);
    CHECK(mtf.reduced_value(0).enclose(100).overlaps(
        to_real(reduced({0, wanted.from})).enclose(100)));
  }
}

// An angle in radians is no multiple of π, however near: 600 digits of it still differ.
TEST_CASE("minimal twist: close to half a turn it is decided on which side") {
  PathAngle rmf{PhPath(Curve({{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}}))};  // h = 0
  const RealBall half_turn = pi(2100);
  const MinimalTwist below(rmf, {0, 0}, {0, half_turn.midpoint() - power_of_two(-2000)});
  CHECK(below.twist().enclose(100).lower() > 3);
  const MinimalTwist above(rmf, {0, 0}, {0, half_turn.midpoint() + power_of_two(-2000)});
  CHECK(above.twist().enclose(100).upper() < -3);
}

TEST_CASE("minimal twist: law: whole turns in the angles given change nothing but the angle") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(4));
    PathAngle rmf{PhPath(curve)};
    const FrameAngle from{random.rational(), random.rational()};
    const FrameAngle to{random.rational(), random.chance(2) ? Rational(0) : random.rational()};
    FrameAngle from_turned = from;
    FrameAngle to_turned = to;
    from_turned.half_turns += 2 * Rational(random.integer(-9, 9)) * power_of_ten(40);
    to_turned.half_turns += 2 * Rational(random.integer(-9, 9)) * power_of_ten(40);
    const MinimalTwist a(rmf, from, to);
    const MinimalTwist b(rmf, from_turned, to_turned);
    const Rational t(random.integer(0, 4), 4);
    CHECK(arb_equal(a.twist().enclose(200).raw(), b.twist().enclose(200).raw()) != 0);
    CHECK(a.reduced_value(t).exact() == b.reduced_value(t).exact());
    CHECK(a.reduced_value(t).enclose(200).overlaps(b.reduced_value(t).enclose(200)));
  });
}

// A = (t + i)(t + j): θ_RMF = −2t/(1 + t²), so that T_ERF = 1 and θ_f = −1 needs no twist.
TEST_CASE("minimal twist: a rotation-minimizing frame has none") {
  PathAngle rmf{PhPath(Curve({{0, 0, 1}, {0, 1}, {0, 1}, {1}}))};
  const MinimalTwist mtf(rmf, {0, 0}, {0, -1});
  CHECK(mtf.twist().exact() == Rational(0));
  CHECK(mtf.value(Rational(1, 3)).exact() == Rational(-3, 5));
  const MinimalTwist once(rmf, {0, 0}, {0, -1}, -1);
  CHECK(once.twist().enclose(100).overlaps(multiply(RealBall(-2, 100), pi(100), 100)));
  CHECK(
      add(once.value(1).enclose(100), multiply(RealBall(2, 100), pi(100), 100), 100).contains(-1));
}

// The frame turns by θ(b) − θ(a) + ∫ 2h/σ about e₁, and by Ω̄₁ times the length of the way there.
TEST_CASE("minimal twist: law: the exact frame turns at a constant rate") {
  for_samples(40, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(4));
    const FrameAngle from{random.rational(), 0};
    const FrameAngle to{random.rational(), random.rational()};
    const MinimalTwist mtf(PathAngle{PhPath(curve)}, from, to, random.integer(-1, 1));
    constexpr long bits = 200;
    const Polynomial s = antiderivative(sigma(curve.preimage()));
    CHECK(mtf.length() == s(1));
    const Rational a(random.integer(0, 8), 10);
    const Rational b(random.integer(9, 10), 10);
    const RealBall turned =
        subtract(subtract(mtf.value(b).enclose(bits), mtf.value(a).enclose(bits), bits),
                 quadrature(rate_to_erf(curve.preimage()), a, b, bits), bits);
    const RealBall wanted = multiply(mtf.rate().enclose(bits), RealBall(s(b) - s(a), bits), bits);
    CHECK(turned.overlaps(wanted));
    CHECK(turned.accuracy_bits() > 150);
  });
}

TEST_CASE("minimal twist: law: the least twist between the boundary angles, evenly spread") {
  for_samples(60, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(4));
    PathAngle rmf{PhPath(curve)};
    const auto angle = [&] {
      return FrameAngle{random.rational(), random.chance(2) ? Rational(0) : random.rational()};
    };
    const FrameAngle from = angle();
    const FrameAngle to = angle();
    const long extra = random.integer(-2, 2);
    const MinimalTwist mtf(rmf, from, to, extra);
    constexpr long bits = 200;
    const RealBall full_turn = multiply(RealBall(2, bits), pi(bits), bits);
    // The twist by quadrature of ω₁σ = 2h/σ, and the angles.
    const RealBall erf = subtract({}, quadrature(rate_to_erf(curve.preimage()), 0, 1, bits), bits);
    const RealBall nominal =
        add(erf, subtract(to_real(to).enclose(bits), to_real(from).enclose(bits), bits), bits);
    CHECK(nominal.overlaps(mtf.nominal_twist().enclose(bits)));
    const RealBall least =
        subtract(mtf.twist().enclose(bits), multiply(RealBall(extra, bits), full_turn, bits), bits);
    CHECK(subtract(least, pi(bits), bits).lower() <= 0);
    CHECK(add(least, pi(bits), bits).upper() > 0);
    const auto is_whole = [&](const RealBall& x) {
      return arb_contains_int(divide(x, full_turn, bits).raw()) != 0;
    };
    CHECK(is_whole(subtract(nominal, least, bits)));
    const RealBall end = mtf.value(1).enclose(bits);
    CHECK(is_whole(subtract(end, to_real(to).enclose(bits), bits)));
    CHECK(subtract(end, mtf.value(0).enclose(bits), bits)
              .overlaps(subtract(mtf.twist().enclose(bits), erf, bits)));
    // Between: θ − θ_RMF grows with the arc length.
    const Rational t(random.integer(1, 9), 10);
    const Polynomial s = antiderivative(sigma(curve.preimage()));
    const RealBall turned =
        subtract(mtf.value(t).enclose(bits),
                 add(mtf.value(0).enclose(bits),
                     quadrature(rate_to_erf(curve.preimage()), 0, t, bits), bits),
                 bits);
    CHECK(turned.overlaps(multiply(mtf.twist().enclose(bits), RealBall(s(t) / s(1), bits), bits)));
  });
}
