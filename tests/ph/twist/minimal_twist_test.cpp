#include "phrame/ph/twist/minimal_twist.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/farouki_moon.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace minimal_twist_test {

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

const Path loop(
    bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}));

std::string digits(const Real& x, long count) { return round_to_decimal(x, count).value; }

bool agree(const Vector<Real>& u, const Vector<Real>& v) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!u[k].enclose(120).overlaps(v[k].enclose(120)) || !u[k].enclose(120).is_accurate(90))
      return false;
  return true;
}

/// In the middle: the angle of the integrals, and the frame with that.
void check_middle(const MinimalTwist& mtf, const PathAngle& angle, const PathLength& length) {
  const Place middle{0, Rational(1, 2)};
  CHECK(mtf.is_middle(middle));
  const Real behind = quotient_of(length.value(middle), length.total());
  const Real known = mtf.from().value + mtf.twist() * behind + angle.value(middle);
  CHECK(known.enclose(120).overlaps(mtf.value(middle).enclose(120)));
  CHECK(known.enclose(120).is_accurate(90));
  const Frame<Real> exact = turned(up_frame(angle.path(), angle.up(), middle), known);
  const Frame<Real> frame = minimal_twist_frame(mtf, middle);
  CHECK(agree(frame.e2, exact.e2));
  CHECK(agree(frame.e3, exact.e3));
}

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
    CHECK(to_string(mtf.length().exact().value()) == truth["S"].get<std::string>());
    check_near(mtf.own_twist(), truth["T_ERF"], 45);
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
  const MinimalTwist radians(rmf, Rational(1), Rational(3, 2));
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
    const MinimalTwist mtf(rmf, wanted.from, wanted.to);
    CHECK(round_to_decimal(mtf.twist(), 20).value == wanted.twist);
    // As many bits as one asks for, whatever was cancelled.
    CHECK(mtf.twist().enclose(100).accuracy_bits() > 80);
    CHECK(mtf.value(0).exact() == wanted.from);
    CHECK(mtf.reduced_value({0, Rational(0)})
              .enclose(100)
              .overlaps(to_real(reduced({0, wanted.from})).enclose(100)));
  }
}

// An angle in radians is no multiple of π, however near: 600 digits of it still differ.
TEST_CASE("minimal twist: close to half a turn it is decided on which side") {
  PathAngle rmf{PhPath(Curve({{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}}))};  // h = 0
  const RealBall half_turn = pi(2100);
  const MinimalTwist below(rmf, {}, Rational(half_turn.midpoint() - power_of_two(-2000)));
  CHECK(below.twist().enclose(100).lower() > 3);
  const MinimalTwist above(rmf, {}, Rational(half_turn.midpoint() + power_of_two(-2000)));
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
    CHECK(a.reduced_value({0, t}).exact() == b.reduced_value({0, t}).exact());
    CHECK(a.reduced_value({0, t}).enclose(200).overlaps(b.reduced_value({0, t}).enclose(200)));
  });
}

// A = (t + i)(t + j): θ_RMF = −2t/(1 + t²), so that T_ERF = 1 and θ_f = −1 needs no twist.
TEST_CASE("minimal twist: a rotation-minimizing frame has none") {
  PathAngle rmf{PhPath(Curve({{0, 0, 1}, {0, 1}, {0, 1}, {1}}))};
  const MinimalTwist mtf(rmf, {}, Rational(-1));
  CHECK(mtf.twist().exact() == Rational(0));
  CHECK(mtf.value(Rational(1, 3)).exact() == Rational(-3, 5));
  const MinimalTwist once(rmf, {}, Rational(-1), -1);
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
    CHECK(mtf.length().exact() == s(1));
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

// By mpmath: quad of the rates of the definition with v = (5, −9, 11), 40 digits.
TEST_CASE("minimal twist, any path: twist and angles by an independent quadrature") {
  const PathAngle angle(loop, {5, -9, 11});
  const MinimalTwist mtf = minimal_twist(angle, Angle(Rational(1, 4)), Angle(3));
  CHECK(digits(mtf.length(), 30) == "8.24952510078988651167067831996");
  CHECK(digits(mtf.own_twist(), 30) == "-1.34752349495171462972730968362");
  CHECK(digits(mtf.twist(), 30) == "1.40247650504828537027269031638");
  CHECK(digits(mtf.rate(), 30) == "0.170006938328365008889625166349");
  CHECK(digits(mtf.value({0, Rational(1, 2)}), 30) == "2.83578027017717251562214885781");
  CHECK(mtf.value({0, Rational(0)}).exact() == Rational(1, 4));
  CHECK(mtf.value({0, Rational(1)}).exact() == Rational(3));
  // A revolution more, and θ_f as much less: the same nominal twist but for that.
  const MinimalTwist more = minimal_twist(angle, Angle(Rational(1, 4)), Angle(3), 1);
  const RealBall turn = subtract(more.twist().enclose(120), mtf.twist().enclose(120), 120);
  CHECK(turn.overlaps(times_power_of_two(pi(120), 1)));
  // And so θ(end) is θ_f and that revolution.
  const RealBall end = subtract(more.value({0, Rational(1)}).enclose(120), RealBall(3, 120), 120);
  CHECK(end.overlaps(times_power_of_two(pi(120), 1)));
  const Frame<Real> at_end = minimal_twist_frame(more, {0, Rational(1)});
  CHECK(agree(at_end.e2, minimal_twist_frame(mtf, {0, Rational(1)}).e2));
}

// Two ways: closed forms, and integrals along the same curve by its positions.
TEST_CASE("minimal twist, any path: along a PH curve it is that of the PH curve") {
  const PhPath ph(test::quintic);
  const PathAngle angle(test::by_positions(ph));
  const Frame<Rational> first = euler_rodrigues_frame(test::quintic, 0);
  const Frame<Rational> last = euler_rodrigues_frame(test::quintic, 1);
  const Vector<Rational> from = first.e2;
  const Vector<Rational> to{last.e2[0] + 2 * last.e3[0], last.e2[1] + 2 * last.e3[1],
                            last.e2[2] + 2 * last.e3[2]};
  const MinimalTwist known(PathAngle(ph), FrameAngle(), angle_of(to, last));
  const MinimalTwist found = minimal_twist(angle, StartNormal(from), StartNormal(to));
  CHECK(found.twist().enclose(120).overlaps(known.twist().enclose(120)));
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1, 2), Rational(1)}) {
    const Frame<Real> exact =
        turned(as_real(euler_rodrigues_frame(test::quintic, t)), known.value(t));
    const Frame<Real> frame = minimal_twist_frame(found, {0, t});
    CHECK(agree(frame.e2, exact.e2));
    CHECK(agree(frame.e3, exact.e3));
  }
}

// x is even about the middle, y and z are odd: f₂ is ±x there, by half a turn about it. The angle
// is that of the integrals, which know nothing of it.
TEST_CASE(
    "minimal twist, any path: components that are 0 by the form of a curve are exactly 0 in its "
    "middle") {
  const Path crown(test::expression_curve({"cos(s)", "sin(s)", "sin(2*s)/4"}, "0", "2*pi"));
  const PathAngle angle(crown, {0, 0, 1});
  const Place middle{0, Rational(1, 2)};
  const PathLength length(crown);
  for (const long turns : {0L, 1L}) {
    const MinimalTwist mtf = minimal_twist(angle, Angle(), Angle(), turns);
    check_middle(mtf, angle, length);
    const Frame<Real> frame = minimal_twist_frame(mtf, middle);
    CHECK(frame.e2[1].exact() == Rational(0));
    CHECK(frame.e2[2].exact() == Rational(0));
    CHECK(frame.e3[0].exact() == Rational(0));
  }
  check_middle(minimal_twist(angle, Angle(Rational(1, 3)), Angle(2)), angle, length);
  CHECK_FALSE(minimal_twist(angle, Angle(), Angle()).is_middle({0, Rational(1, 3)}));
}

// The curves are mirrored by x → −x, t → 1 − t, which turns the sign of the turning of a frame
// round, and v is mirrored to itself: ∫ e₂′·e₃ = 0, T = ±π, and both are as short.
TEST_CASE(
    "minimal twist, any path: half a turn on a curve with a mirror symmetry is taken forwards") {
  const Path bezier(bezier_curve({{-3, 0, 0}, {-1, 2, 1}, {0, 5, -2}, {1, 2, 1}, {3, 0, 0}}));
  const Path formula(test::expression_curve({"s", "s^2 + cos(s)", "s^4"}, "-1", "1"));
  for (const Path& path : {bezier, formula}) {
    const PathAngle angle(path, {0, 0, 1});
    for (const long k : {1, -1, 3, -5}) {
      const MinimalTwist half =
          minimal_twist(angle, Angle(Rational(1, 3)), Angle(Rational(k), Rational(1, 3)));
      CHECK(half.twist().enclose(300).overlaps(pi(300)));
      REQUIRE(half.half_turn_within());
      CHECK(*half.half_turn_within() < power_of_two(-230));
      CHECK(half.turns_at_end() == Integer((1 - k) / 2));
    }
    const MinimalTwist vectors =
        minimal_twist(angle, StartNormal({0, 1, 1}), StartNormal({0, -1, -1}));
    CHECK(vectors.twist().enclose(300).overlaps(pi(300)));
    CHECK(vectors.half_turn_within());
    CHECK_FALSE(minimal_twist(angle, Angle(), Angle(3)).half_turn_within());
  }
}

TEST_CASE("minimal twist, any path: half a turn in a plane, and what has no angle") {
  const Path bend(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  const PathAngle angle(bend);
  const MinimalTwist half = minimal_twist(angle, Angle(), Angle(1, 0));
  CHECK(half.twist().enclose(100).overlaps(pi(100)));  // π, not −π
  CHECK(minimal_twist(angle, Angle(), Angle(-1, 0)).twist().enclose(100).overlaps(pi(100)));
  CHECK(minimal_twist(angle, Angle(), Angle(4, 0)).twist().exact() == Rational(0));
  CHECK_THROWS_AS(minimal_twist(angle, Angle(), StartNormal({0, 1, 0})), DomainError);
  CHECK_THROWS_AS(minimal_twist(PathAngle(loop, Reference::frenet), Angle(), Angle()), DomainError);
}

// h = 0: e₂ is carried along by the rotation-minimizing frame, whatever angles are measured from.
TEST_CASE("minimal twist: that of a PH curve is decided by algebra, to the frame of v, too") {
  const Curve curve({{1}, {0, 0, 0, 1}, {0, 3}, {0, 0, 1}});
  const Vector<Rational> first = euler_rodrigues_frame(curve, 0).e2;
  const Vector<Rational> last = euler_rodrigues_frame(curve, 1).e2;
  const PhPath path(curve);
  for (const PathAngle& angle : {PathAngle(path), PathAngle(path, {1, -2, 3})}) {
    const auto to = [&](const Vector<Rational>& v) {
      return minimal_twist(angle, StartNormal(first), StartNormal(v));
    };
    CHECK(to(last).twist().exact() == Rational(0));
    const MinimalTwist half = to({-last[0], -last[1], -last[2]});
    CHECK(half.half_turn_within() == Rational(0));
    CHECK(half.twist().enclose(300).overlaps(pi(300)));
  }
}

// Two ways, as above: f changes its sign at t = 1/2, where the curve turns back.
TEST_CASE("minimal twist: through a cusp the way goes on") {
  const PhPath ph(Curve(test::quintic.preimage(), Polynomial{1, -2}));
  const PathAngle angle(ph);
  const PathAngle other(test::by_positions(ph));
  const StartNormal from({0, 0, 1});
  const StartNormal to({1, 0, 2});
  const MinimalTwist known = minimal_twist(angle, from, to);
  const MinimalTwist found = minimal_twist(other, from, to);
  CHECK(known.length().exact().has_value());
  CHECK(known.length().enclose(120).overlaps(found.length().enclose(120)));
  const bool is_opposite = !agree(reference_frame(angle, {0, Rational(0)}).e1,
                                  reference_frame(other, {0, Rational(0)}).e1);
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(2, 3), Rational(1)}) {
    const Frame<Real> a = minimal_twist_frame(known, {0, t});
    const Frame<Real> b = minimal_twist_frame(found, {0, t});
    CHECK(agree(a.e2, b.e2));
    CHECK(agree(a.e3, is_opposite ? opposite(b.e3) : b.e3));
  }
}

TEST_CASE("minimal twist: without an end it ends as it starts") {
  for (const Path& path : {Path(test::chain(test::quarters())), loop}) {
    const MinimalTwist mtf = minimal_twist(PathAngle(path), Angle(Rational(1, 3)), {});
    const Frame<Real> first = minimal_twist_frame(mtf, {0, Rational(0)});
    const Frame<Real> last = minimal_twist_frame(mtf, end_of(path));
    CHECK(agree(first.e2, last.e2));
    CHECK(agree(first.e3, last.e3));
  }
  CHECK_THROWS_AS(minimal_twist(PathAngle(PhPath(test::quintic)), Angle(), {}), DomainError);
}

}  // namespace minimal_twist_test
