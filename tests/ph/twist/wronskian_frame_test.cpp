#include "phrame/ph/twist/wronskian_frame.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/twist/frame_angle_error.hpp"

namespace wronskian_frame_test {

using namespace phrame;

namespace {

using Bernstein = std::vector<std::vector<long>>;

/// By its Bernstein coefficients, quaternions.
Curve curve_by(const Bernstein& quaternions) {
  const auto component = [&](std::size_t k) {
    std::vector<Rational> b;
    for (const auto& q : quaternions) b.emplace_back(q[k]);
    return from_bernstein(b);
  };
  return Curve({component(0), component(1), component(2), component(3)});
}

/// The quintic of [Peng, Pang, Pan 2023].
const Curve paper = curve_by({{0, 1, 0, 2}, {0, 2, 1, -1}, {0, 3, -2, -1}});

std::string decimal(const Real& x, long digits) { return round_to_decimal(x, digits).value; }

void check_close(const Real& x, double truth, double tolerance) {
  CHECK(approximate(x.enclose(64)) == doctest::Approx(truth).epsilon(tolerance));
}

Polynomial wronskian(const Polynomial& a, const Polynomial& b) {
  return a * differentiate(b) - differentiate(a) * b;
}

}  // namespace

// Its legs, with (A₀ ⋆ A₂ + 2A₁²*)/15 for the one that is misprinted.
TEST_CASE("wronskian frame: the paper's curve") {
  const auto points = control_points(paper);
  const Vector<Rational> legs[] = {{Rational(-3, 5), 0, Rational(4, 5)},
                                   {Rational(4, 5), Rational(1, 5), Rational(3, 5)},
                                   {Rational(3, 5), Rational(2, 5), Rational(-1, 5)},
                                   {Rational(7, 5), Rational(-1, 5), -1},
                                   {Rational(4, 5), Rational(-12, 5), Rational(-6, 5)}};
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < 3; ++i) CHECK(points[k + 1][i] - points[k][i] == legs[k][i]);
}

// By SciPy: Nelder and Mead's method in each plane (weights 1, |τκ|, σ), and SLSQP on the ten
// coefficients of a and b with the equations (24), which finds the same.
TEST_CASE("wronskian frame: the paper's curve with its three weights") {
  const WronskianFrame one(paper, FrameWeight::one);
  CHECK(one.planes().real.size() == 3);
  CHECK(one.best() == 2);
  CHECK(decimal(one.value(2), 11) == "173.37920852");
  CHECK(decimal(one.value(0), 7) == "510.4496");
  CHECK(decimal(one.value(1), 9) == "1347.05545");
  CHECK(decimal(WronskianFrame(paper, FrameWeight::torsion_curvature).value(2), 10) ==
        "11.83033300");
  CHECK(decimal(WronskianFrame(paper, FrameWeight::speed).value(2), 12) == "1063.02517672");
}

// By a trapezoidal sum of 2h/σ − 4hσ/(a² + b²) in doubles: half of these angles, which are those of
// the paper, are 0.207, 0.0183 and 0.489.
TEST_CASE("wronskian frame: the errors of the angle") {
  const std::pair<FrameWeight, double> truths[] = {{FrameWeight::one, 0.207},
                                                   {FrameWeight::torsion_curvature, 0.0183},
                                                   {FrameWeight::speed, 0.489}};
  for (const auto& [weight, truth] : truths) {
    const RationalPair pair = WronskianFrame(paper, weight).rounded(60);
    check_close(frame_angle_error(paper.preimage(), pair.a, pair.b).greatest, 2 * truth, 0.003);
  }
}

TEST_CASE("wronskian frame: the pair over ℚ solves (24) but for one coefficient") {
  const WronskianFrame frame(paper, FrameWeight::one);
  Rational last = 1;
  for (const long bits : {30, 60, 120}) {
    const RationalPair pair = frame.rounded(bits);
    CHECK(wronskian(pair.a, pair.b) - frame.wronskian() == Polynomial::monomial(pair.defect, 6));
    CHECK(pair.defect != 0);  // the resolvent has no rational root
    CHECK(abs(pair.defect) < power_of_two(20 - bits));
    CHECK(abs(pair.defect) < last);
    last = abs(pair.defect);
    CHECK(pair.a(0) == 0);
    CHECK(pair.b(0) > 0);
    // As good as the best pair, but for the square of what was rounded.
    const Polynomial s = sigma(paper.preimage());
    const Polynomial rest = pair.a * pair.a + pair.b * pair.b - Rational(2) * s * s;
    const Rational value = antiderivative(rest * rest)(1);
    CHECK(abs(value - frame.value(2).enclose(200).midpoint()) < power_of_two(30 - bits));
  }
}

TEST_CASE("wronskian frame: the best pair is one, in balls") {
  const WronskianFrame frame(paper, FrameWeight::speed);
  constexpr long bits = 128;
  const auto polynomial = [](const std::vector<Real>& coefficients) {
    std::vector<RealBall> balls;
    for (const Real& c : coefficients) balls.push_back(c.enclose(bits));
    return BallPolynomial(balls);
  };
  const BallPolynomial a = polynomial(frame.a());
  const BallPolynomial b = polynomial(frame.b());
  const BallPolynomial left = multiply(a, differentiate(b, bits), bits);
  const BallPolynomial defect =
      subtract(subtract(left, multiply(differentiate(a, bits), b, bits), bits),
               BallPolynomial(frame.wronskian(), bits), bits);
  for (long k = 0; k <= defect.degree_bound(); ++k) {
    CHECK(defect.coefficient(k).contains_zero());
    CHECK(defect.coefficient(k).radius() < power_of_two(-60));
  }
  const auto form = frame.form(frame.best());
  const RealBall determinant =
      subtract(multiply(form[0].enclose(bits), form[2].enclose(bits), bits),
               multiply(form[1].enclose(bits), form[1].enclose(bits), bits), bits);
  CHECK(determinant.contains(1));
}

// 4h·σ over (t² + 1)⁴: a² + b² = 2σ² for b + ia = √2(1 + it)².
TEST_CASE("wronskian frame: where J = 0 the frame is rotation-minimizing") {
  const Curve line({{-1, 0, 1}, {0, 2}, {}, {}});
  const WronskianFrame frame(line, FrameWeight::one);
  const RealBall value = frame.value(frame.best()).enclose(200);
  CHECK(value.contains(0));
  CHECK(value.radius() < power_of_two(-150));
  CHECK(frame.form(frame.best())[0].enclose(100).contains(2));
  CHECK(frame.rounded(60).defect == 0);
}

// A(1 − t) = A(t)·const for even and odd parts in t − 1/2.
TEST_CASE("wronskian frame: symmetric curves have planes in pairs, equally good") {
  const Polynomial s{Rational(-1, 2), 1};
  const Curve symmetric({Polynomial{1} + s * s, s, Rational(2) * s, Polynomial{3} - s * s});
  for (const FrameWeight weight : {FrameWeight::one, FrameWeight::speed}) {
    const WronskianFrame frame(symmetric, weight);
    REQUIRE(frame.planes().real.size() == 3);
    CHECK(frame.best() == 1);
    CHECK_FALSE(frame.is_tied(0));
    CHECK_FALSE(frame.is_tied(1));
    CHECK(frame.is_tied(2));
    CHECK(decimal(frame.value(1), 30) == decimal(frame.value(2), 30));
  }
}

TEST_CASE("wronskian frame: preimages count without their real content") {
  const Polynomial x{-1, 3};
  const auto& [u, v, p, q] = paper.preimage();
  const WronskianFrame frame(Curve({x * u, x * v, x * p, x * q}), FrameWeight::one);
  CHECK(frame.wronskian() == WronskianFrame(paper, FrameWeight::one).wronskian());
  CHECK(decimal(frame.value(frame.best()), 11) == "173.37920852");
}

TEST_CASE("wronskian frame: cubics have one plane, over ℚ") {
  const Curve cubic({{1}, {0, 1}, {0, 2}, {}});
  const WronskianFrame frame(cubic, FrameWeight::one);
  CHECK(frame.planes().real.size() == 1);
  const RationalPair pair = frame.rounded(60);
  CHECK(wronskian(pair.a, pair.b) == frame.wronskian());
}

TEST_CASE("wronskian frame: what is refused") {
  const auto refuse = [](const Curve& curve, FrameWeight weight, const char* why) {
    CHECK_THROWS_WITH_AS(WronskianFrame(curve, weight), why, DomainError);
  };
  const char* const nothing =
      "there is nothing to turn: h = 0, the Euler-Rodrigues frame is rotation-minimizing";
  refuse(Curve({{1}, {}, {}, {}}), FrameWeight::one, nothing);
  refuse(Curve({{1}, {}, {}, {0, 1}}), FrameWeight::speed, nothing);
  refuse(Curve({{1, 0, 0, 1}, {0, 1}, {0, 2}, {0, 3, 1}}), FrameWeight::one,
         "the preimage has degree 3: ab′ − a′b = 2hσ is solved for degrees 1 and 2, with 1 and 5 "
         "planes (degree 3 has 42)");
  refuse(Curve({{-1, 0, 1}, {0, 2}, {}, {}}), FrameWeight::torsion_curvature,
         "the weight |τκ| is 0 everywhere: the curve is plane");
}

// By SciPy's SLSQP on the ten coefficients of a and b, with the equations (24), from 150 random
// starts: the least J of all.
TEST_CASE("wronskian frame: other quintics") {
  const struct {
    Bernstein quaternions;
    double one;
    double speed;
  } truths[] = {{{{1, 2, 0, 1}, {2, -1, 1, 0}, {1, 1, 3, -2}}, 1222.6317714, 9152.1483001},
                {{{3, 1, -1, 2}, {1, 2, 1, -1}, {2, -2, 1, 4}}, 4151.5984006, 36534.777946},
                {{{1, 0, 0, 0}, {2, 1, -1, 1}, {1, 2, 2, -3}}, 107.61859316, 478.12634599},
                {{{2, 1, 1, 0}, {1, -1, 2, 2}, {3, 1, -1, 1}}, 782.02782605, 7125.0690430}};
  for (const auto& [quaternions, one, speed] : truths) {
    for (const auto& [weight, truth] :
         {std::pair(FrameWeight::one, one), std::pair(FrameWeight::speed, speed)}) {
      const WronskianFrame frame(curve_by(quaternions), weight);
      check_close(frame.value(frame.best()), truth, 1e-9);
    }
  }
}

// h = t²/2 + 10⁻²⁰(1 + 2t): a₀ and b₀ have coefficients of 10²⁰, which cancel.
TEST_CASE("wronskian frame: the pair over ℚ is near the best one where its basis cancels") {
  const Rational e = power_of_ten(-20);
  const Curve flat({{1}, {0, e, e}, {0, 0, Rational(1, 2)}, {0, 1, Rational(-1, 3)}});
  const WronskianFrame frame(flat, FrameWeight::one);
  const RationalPair pair = frame.rounded(60);
  const auto best_a = frame.a();
  const auto best_b = frame.b();
  for (long k = 0; k <= 4; ++k) {
    const auto at = static_cast<std::size_t>(k);
    CHECK(abs(pair.a.coefficient(k) - best_a[at].enclose(128).midpoint()) < power_of_two(-28));
    CHECK(abs(pair.b.coefficient(k) - best_b[at].enclose(128).midpoint()) < power_of_two(-28));
  }
}

// h = t² and 2hσ vanish twice at 0, and so do all a² + b² of two of the planes.
TEST_CASE("wronskian frame: a common zero of the best pair is one of the pair over ℚ, too") {
  const Curve curve({{0, 1}, {0, -2, 1}, {}, {-2, 3, 5}});
  REQUIRE(twist_numerator(curve.preimage()) == Polynomial{0, 0, 1});
  const WronskianFrame frame(curve, FrameWeight::one);
  CHECK(frame.common_zero() == Rational(0));
  CHECK(frame.a()[0].enclose(64).is_zero());
  CHECK(frame.b()[0].enclose(64).is_zero());
  for (const long bits : {60, 120}) {
    const RationalPair pair = frame.rounded(bits);
    CHECK(gcd(pair.a, pair.b) == Polynomial{0, 1});
    const Polynomial law = Polynomial{0, 0, 1} * pow(Polynomial{-1, 1}, 4);  // the origin is 1
    CHECK(pair.defect != 0);
    CHECK(wronskian(pair.a, pair.b) - frame.wronskian() == pair.defect * law);
    // By SciPy: SLSQP on the coefficients of cubics a/t, b/t, and a trapezoidal sum of the rate.
    const Polynomial s = sigma(curve.preimage());
    const Polynomial rest = pair.a * pair.a + pair.b * pair.b - Rational(2) * s * s;
    CHECK(static_cast<double>(antiderivative(rest * rest)(1)) ==
          doctest::Approx(67.4071875025067).epsilon(1e-9));
    check_close(frame_angle_error(curve.preimage(), pair.a, pair.b).greatest, 8.4523278, 1e-7);
  }
  CHECK_FALSE(WronskianFrame(paper, FrameWeight::one).common_zero().has_value());
}

}  // namespace wronskian_frame_test
