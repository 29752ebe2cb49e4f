#include "phrame/ph/along/rational_rates.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

using namespace phrame;

// Everything is compared with the formulas of κ and τ in r′, r″, r‴, which are differentiated here
// from X/W by themselves, in fractions: of a number with a square root its square and its sign.

namespace {

/// r′, r″ and r‴ at t.
struct Derivatives {
  Vector<Rational> first;
  Vector<Rational> second;
  Vector<Rational> third;
};

Derivatives derivatives_at(const RationalCurve& curve, const Rational& t) {
  Derivatives result;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalFunction first =
        differentiate(RationalFunction(curve.numerator()[k], curve.weight()));
    const RationalFunction second = differentiate(first);
    result.first[k] = first(t);
    result.second[k] = second(t);
    result.third[k] = differentiate(second)(t);
  }
  return result;
}

/// The square of x, with its sign.
Rational signed_square(const Rational& x) { return x < 0 ? Rational(-x * x) : Rational(x * x); }

/// Of N/(D√S).
Rational signed_square(const RootQuotient& f, const Rational& t) {
  return signed_square(Rational(f.numerator(t) / f.denominator(t))) / f.radicand(t);
}

Rational squared_size(const Vector<Rational>& v) { return dot(v, v); }

int sign(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

std::optional<RationalCurve> random_curve(test::Random& random) {
  try {
    return RationalCurve({random.polynomial(4), random.polynomial(4), random.polynomial(3)},
                         random.chance(2) ? Polynomial{1} : Polynomial{3, 1, 1});
  } catch (const DomainError&) {  // a point
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("rational rates: law: those of the formulas with r', r'', r'''") {
  test::for_samples(60, [](test::Random& random) {
    const auto curve = random_curve(random);
    if (!curve) return;
    const Rational t = random.rational();
    const auto [d1, d2, d3] = derivatives_at(*curve, t);
    const Rational speed2 = squared_size(d1);
    if (speed2 == 0) return;
    const int forward = sign(curve->multiplier()(t));
    CHECK(signed_square(length_rate(*curve), t) == forward * speed2);

    // κ² = |r′ × r″|²/|r′|⁶.
    const Rational bend2 = squared_size(cross(d1, d2));
    const Rational kappa2 = bend2 / (speed2 * speed2 * speed2);
    CHECK(signed_square(bending_rate(*curve), t) == forward * kappa2 * kappa2 * speed2);
    CHECK(abs(signed_square(curvature_rate(*curve), t)) == kappa2 * speed2);
    if (bend2 == 0) return;

    // τ = det(r′, r″, r‴)/|r′ × r″|²; to the Frenet frame the angle falls by τ ds, and e₁ ds is
    // r′ dt for either sign of p.
    const Rational torsion = dot(cross(d1, d2), d3) / bend2;
    CHECK(signed_square(frenet_turning(*curve), t) == -signed_square(torsion) * speed2);
    const Rational energy = kappa2 + torsion * torsion;
    CHECK(signed_square(frenet_energy_rate(*curve), t) == forward * energy * energy * speed2);
  });
}

TEST_CASE("rational rates: law: the frame of v turns by -e2'.e3") {
  test::for_samples(60, [](test::Random& random) {
    const auto curve = random_curve(random);
    if (!curve) return;
    const Rational t = random.rational();
    const auto [d1, d2, d3] = derivatives_at(*curve, t);
    const Vector<Rational> v{random.rational(), random.rational(), random.rational()};
    // With a = v × r′ along ±e₂ and b = r′ × a along e₃, −e₂′·e₃ is −a′·b/(|a|·|b|) up to the sign
    // of e₁, for which a and b together do not change but b does: e₃ = e₁ × e₂.
    const Vector<Rational> a = cross(v, d1);
    if (squared_size(a) == 0) return;
    const Rational across = -dot(cross(v, d2), cross(d1, a));
    const Rational square =
        signed_square(across) / (squared_size(a) * squared_size(a) * squared_size(d1));
    CHECK(signed_square(up_frame_turning(*curve, v), t) == sign(curve->multiplier()(t)) * square);
  });
}

TEST_CASE("rational rates: a straight line has no Frenet frame, and bends nowhere") {
  const RationalCurve line({Polynomial{0, 1, 1}, Polynomial{0, 2, 2}, {}});
  CHECK_THROWS_AS(frenet_turning(line), DomainError);
  CHECK_THROWS_AS(frenet_energy_rate(line), DomainError);
  CHECK(curvature_rate(line).numerator.is_zero());
  CHECK(bending_rate(line).numerator.is_zero());
}

TEST_CASE(
    "rational rates: the curvature is not |.| but goes on with its sign through inflections") {
  // (t, t³, 0): κ ds/dt = 6t/(1 + 9t⁴), which changes its sign at 0.
  const RootQuotient rate =
      curvature_rate(RationalCurve({Polynomial{0, 1}, Polynomial::monomial(1, 3), {}}));
  CHECK(signed_square(rate, Rational(1, 2)) == -signed_square(rate, Rational(-1, 2)));
  CHECK(signed_square(rate, Rational(1)) == Rational(36, 100));
}
