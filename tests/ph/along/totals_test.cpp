#include "phrame/ph/along/totals.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace totals_test {

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

/// The double PH curve of the slides.
const Curve septic({{0, 3, 0, -1}, {0, 0, -3}, {}, {3}}, {Rational(1, 3)});
/// A = 1 + tk: σ = 1 + t², κ = 2/(1 + t²)².
const Curve plane({{1}, {}, {}, {0, 1}});

std::string digits(const Real& x) { return round_to_decimal(x, 25).value; }
std::string digits(const std::variant<CurveTotal, Infinite>& x) {
  return digits(std::get<CurveTotal>(x).value);
}

/// r′ = f in direction x.
Curve on_a_line(const Polynomial& f) { return Curve({{1}, {}, {}, {}}, f); }

std::optional<Real> rotation_index(const Curve& curve) {
  return absolute_rotation_index(Path(PhPath(curve)));
}

Curve random_curve(Random& random, long degree) {
  for (;;) {
    Curve curve = random.curve(degree);
    if (!line_direction(curve.preimage())) return curve;
  }
}

/// Do the two numbers agree to 80 bits?
bool agree(const Real& x, const Real& y) {
  const RealBall difference = subtract(x.enclose(200), y.enclose(200), 200);
  const Rational scale = 1 + abs(x.enclose(200).upper());
  return difference.contains_zero() &&
         abs(difference.upper()) < scale * Rational(1, Integer(1) << 80);
}

}  // namespace

// Quadrature by mpmath of |r′|, |r′|τ, |r′|κ², |r′|(κ² + τ²) and |r′|κ, these from r′, r″ and r‴ as
// vectors.
TEST_CASE("totals: the quintic of Farouki 2003") {
  const CurveTotal length = total_length(quintic);
  CHECK(length.value.exact() == Rational(71, 15));
  CHECK(length.exact == ExactValue{Rational(71, 15), 0, {}, {}});
  CHECK(digits(total_torsion(quintic).value) == "-2.995041408117596460503755");
  CHECK(digits(bending_energy(quintic)) == "2.252971369320598317006094");
  CHECK(digits(frenet_energy(quintic)) == "7.255373108355321759595311");
  CHECK_FALSE(total_curvature(quintic));
  CHECK_FALSE(rotation_index(quintic));
}

TEST_CASE("totals: the double PH septic has a total curvature") {
  CHECK(total_length(septic).value.exact() == Rational(446, 105));
  CHECK(digits(total_torsion(septic).value) == "1.105065000803744027327938");
  CHECK(digits(total_curvature(septic).value().value) == "1.913392329593215344432761");
  CHECK(digits(bending_energy(septic)) == "0.9524120941114150592797146");
  CHECK(digits(frenet_energy(septic)) == "1.464324334348345020514951");
}

// By hand: κ ds = 2/(1 + t²) dt, κ² ds = 4/(1 + t²)³ dt.
TEST_CASE("totals: a plane cubic in finite terms") {
  CHECK(total_curvature(plane).value().exact == ExactValue{0, Rational(1, 2), {}, {}});
  CHECK(rotation_index(plane).value().exact() == Rational(1, 4));
  const auto energy = bending_energy(plane);
  CHECK(std::get<CurveTotal>(energy).exact == ExactValue{1, Rational(3, 8), {}, {}});
  CHECK(digits(frenet_energy(plane)) == digits(energy));
  CHECK(total_torsion(plane).value.exact() == Rational(0));
  CHECK(erf_twist(plane).value.exact() == Rational(0));
}

// A = 1 + t(1 − t)k: the tangent has the angle 2·arctan(t − t²), which goes to 2·arctan(1/4) and
// back. With i − k, of length √2, for k it goes to 2·arctan(√2/4).
TEST_CASE("totals: where a plane curve turns the other way, its curvature still counts") {
  const Curve bend({{1}, {}, {}, {0, 1, -1}});
  const CurveTotal total = total_curvature(bend).value();
  REQUIRE(total.sign_changes.size() == 1);
  CHECK(total.sign_changes[0] == Rational(1, 2));
  CHECK(total.exact == ExactValue{0, 0, {}, {{4, Rational(1, 4)}}});
  CHECK(agree(total_curvature(rotated(bend, {2, 1, 3, 5})).value().value, total.value));
  const Curve oblique({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}});
  CHECK(total_curvature(oblique).value().radicand == 2);
  CHECK(digits(total_curvature(oblique).value().value) == "1.359347637816487748385570");
  CHECK(digits(rotation_index(oblique).value()) == "0.2163468959387854596582889");
}

// A = (2 + tk)(3 + tk): the tangent turns by 2·arctan(1/2) + 2·arctan(1/3) = π/2.
TEST_CASE("totals: the rotation index is exact where arctangents add up to a multiple of pi") {
  const QuaternionPolynomial a{{2}, {}, {}, {0, 1}};
  const QuaternionPolynomial b{{3}, {}, {}, {0, 1}};
  CHECK(total_curvature(Curve(a * b)).value().exact == ExactValue{0, Rational(1, 2), {}, {}});
  CHECK(rotation_index(Curve(a * b)).value().exact() == Rational(1, 4));
}

// A = ((1 − t) + t(i − k))³(1 + k): the tangent turns by 3·2·arctan(√2t/(1 − t)), from 0 to 3π.
TEST_CASE("totals: the rotation index is exact in a plane with an irrational normal, too") {
  const QuaternionPolynomial turn{{1, -1}, {0, 1}, {}, {0, -1}};
  const QuaternionPolynomial start{{1}, {}, {}, {1}};
  CHECK(rotation_index(Curve(turn * turn * turn * start)).value().exact() == Rational(3, 2));
  CHECK(rotation_index(Curve(turn * start)).value().exact() == Rational(1, 2));
}

// f and v, p, q are odd about t = 1/2, u is even: τ|f|σ is f times an even function, up to a sign.
TEST_CASE("totals: a torsion that cancels by symmetry is exactly 0") {
  const Polynomial odd{Rational(-1, 2), 1};
  const Curve curve({{Rational(7, 4), -3, 3}, Polynomial{2} * odd, odd, odd}, odd);
  const CurveTotal torsion = total_torsion(curve);
  REQUIRE(torsion.sign_changes.size() == 1);
  CHECK_FALSE(torsion.rate.is_zero());
  CHECK(torsion.value.exact() == Rational(0));
}

TEST_CASE("totals: of a straight line") {
  CHECK(total_length(on_a_line({-3})).value.exact() == Rational(3));
  CHECK(total_length(on_a_line(Polynomial{1, -2} * Polynomial{1, -2})).value.exact() ==
        Rational(1, 3));
  // ∫|t² − 1/2| dt = √2/3 − 1/6 and ∫|2t − 1| dt = 1/2, by hand.
  const CurveTotal there_and_back = total_length(on_a_line({Rational(-1, 2), 0, 1}));
  CHECK(there_and_back.sign_changes.size() == 1);
  CHECK(agree(there_and_back.value, Rational(1, 3) * square_root_of(2) + Rational(-1, 6)));
  CHECK(total_length(on_a_line({-1, 2})).value.exact() == Rational(1, 2));
  CHECK(std::get<CurveTotal>(bending_energy(on_a_line({-1, 2}))).value.exact() == Rational(0));
  CHECK(total_curvature(on_a_line({-1, 2})).value().value.exact() == Rational(0));
  CHECK(rotation_index(on_a_line({1})).value().exact() == Rational(0));
  CHECK_THROWS_AS(total_torsion(on_a_line({1})), DomainError);
  CHECK_THROWS_AS(frenet_energy(on_a_line({1})), DomainError);
}

// f = −1 + 4t − t² changes sign at 2 − √3. Quadrature by mpmath, in two parts.
TEST_CASE("totals: where the multiplier changes sign, the torsion does, too") {
  const Curve curve({{1, 1}, {}, {0, 1}, {0, 0, 3}}, {-1, 4, -1});
  CHECK(digits(total_length(curve).value) == "5.995557814918646860472738");
  CHECK(digits(total_torsion(curve).value) == "-0.9919039190342439442563993");
  const auto energy = bending_energy(curve);
  CHECK(std::get<Infinite>(energy).pole == real_root({-1, 4, -1}, closed_interval(0, 1)));
}

// A = 1 + t²j + t³k: g = t(3t + 2i) is 0 at t = 0, but its real factor t cancels in τ.
TEST_CASE("totals: at an inflection all of them are finite") {
  const QuaternionPolynomial a{{1}, {}, {0, 0, 1}, {0, 0, 0, 1}};
  REQUIRE(bend_numerator(a) == GaussianPolynomial{{0, 0, 3}, {0, 2}});
  CHECK(std::holds_alternative<CurveTotal>(bending_energy(Curve(a))));
  CHECK(std::holds_alternative<CurveTotal>(frenet_energy(Curve(a))));
}

// The rates from r′, r″ and r‴ as vectors, with f > 0.
TEST_CASE("totals: rates are those of the definition, and their integrals those of quadrature") {
  long count = 0;
  for_samples(12, [&](Random& random) {
    const Curve curve(random_curve(random, 3).preimage(), {Rational(1, 3), 0, 2});
    const auto derivative = [](Vector<Polynomial> v) {
      for (Polynomial& p : v) p = differentiate(p);
      return v;
    };
    const auto cross = [](const Vector<Polynomial>& a, const Vector<Polynomial>& b) {
      return Vector<Polynomial>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const Vector<Polynomial>& a, const Vector<Polynomial>& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const Vector<Polynomial> first = hodograph(curve);
    const Vector<Polynomial> second = derivative(first);
    const Vector<Polynomial> normal = cross(first, second);
    const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
    REQUIRE(speed * speed == dot(first, first));
    const RationalFunction ds(speed);
    const RationalFunction tau(dot(normal, derivative(second)), dot(normal, normal));
    const RationalFunction squared_kappa(dot(normal, normal), pow(speed, 6));

    const auto check = [](const CurveTotal& total, const RationalFunction& rate) {
      CHECK(total.rate == rate);
      CHECK(total.value.enclose(100).overlaps(quadrature(rate, 0, 1, 60)));
    };
    check(total_length(curve), ds);
    check(total_torsion(curve), tau * ds);
    const auto bending = bending_energy(curve);
    const auto frenet = frenet_energy(curve);
    if (!std::holds_alternative<CurveTotal>(bending)) return;  // a cusp
    ++count;
    check(std::get<CurveTotal>(bending), squared_kappa * ds);
    check(std::get<CurveTotal>(frenet), (squared_kappa + tau * tau) * ds);
  });
  CHECK(count > 9 * test::multiplier());
}

TEST_CASE("totals: the parts of a curve add up, and its reversal has the same") {
  for_samples(6, [](Random& random) {
    const Curve curve = random_curve(random, 2);
    const Rational t(random.integer(1, 6), 7);
    const Curve first = segment(curve, 0, t);
    const Curve second = segment(curve, t, 1);
    const Curve back = reversed(curve);
    using Sum = CurveTotal (*)(const Curve&);
    for (const Sum total : {Sum(total_length), Sum(total_torsion)}) {
      const Real whole = total(curve).value;
      CHECK(agree(total(first).value + total(second).value, whole));
      CHECK(agree(total(back).value, whole));
    }
    using Energy = std::variant<CurveTotal, Infinite> (*)(const Curve&);
    for (const Energy energy : {Energy(bending_energy), Energy(frenet_energy)}) {
      const auto whole = energy(curve);
      const auto mirrored = energy(back);
      CHECK(whole.index() == mirrored.index());
      if (whole.index() != 0) continue;
      const Real& x = std::get<CurveTotal>(whole).value;
      CHECK(agree(
          std::get<CurveTotal>(energy(first)).value + std::get<CurveTotal>(energy(second)).value,
          x));
      CHECK(agree(std::get<CurveTotal>(mirrored).value, x));
      CHECK(agree(std::get<CurveTotal>(energy(scaled(curve, -3))).value, Rational(1, 3) * x));
    }
  });
}

// (a + bk)·d·(a + bk)* turns the direction d about z, so that the tangent keeps its angle ψ to it;
// then τ/κ = ±cot ψ, and the total torsion is known from the total curvature.
TEST_CASE("totals: of helices") {
  long count = 0;
  for_samples(25, [&](Random& random) {
    const Polynomial a = random.nonconstant_polynomial(2);
    const Polynomial b = random.nonzero_polynomial(2);
    const QuaternionPolynomial around_z{a, {}, {}, b};
    const QuaternionPolynomial u{
        {random.integer(1, 3)}, {random.integer(-3, 3)}, {random.integer(1, 3)}, {}};
    const Curve curve(around_z * u);
    const auto found = helix(curve.preimage());
    if (!found) return;
    const CurveTotal curvature = total_curvature(curve).value();
    const Real torsion = total_torsion(curve).value;
    if (!curvature.sign_changes.empty()) return;
    ++count;
    const Rational cot_squared = found->cosine_squared / (1 - found->cosine_squared);
    CHECK(agree(torsion * torsion, cot_squared * (curvature.value * curvature.value)));
  });
  CHECK(count > 5 * test::multiplier());
}

TEST_CASE("totals: the total torsion is the negative angle to the Frenet frame") {
  RmfAngle angle(quintic, Reference::frenet);
  CHECK(agree(total_torsion(quintic).value, -angle.value(1)));
}

// What is known of these integrals beforehand, the argument of the bend and the part of τ² that is
// a derivative, must not change what the integrator finds by itself.
TEST_CASE("totals: law: the antiderivatives are those that the integrator finds without help") {
  for_samples(8, [](Random& random) {
    const Polynomial multiplier = random.nonzero_polynomial(2);
    const Curve curve(random_curve(random, 4).preimage(), multiplier);
    const CurveTotal torsion = total_torsion(curve);
    CHECK(torsion.antiderivative == integrate(torsion.rate));
    const auto energy = frenet_energy(curve);
    if (const auto* total = std::get_if<CurveTotal>(&energy))
      CHECK(total->antiderivative == integrate(total->rate));
  });
}

}  // namespace totals_test
