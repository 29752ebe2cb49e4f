#include "phrame/ph/curve/invariants.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/curves.hpp"
#include "support/linear_system.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

Vector<Polynomial> cross(const Vector<Polynomial>& a, const Vector<Polynomial>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const Vector<Polynomial>& a, const Vector<Polynomial>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector<Polynomial> derivative(const Vector<Polynomial>& a) {
  return {differentiate(a[0]), differentiate(a[1]), differentiate(a[2])};
}

}  // namespace

TEST_CASE("invariants: the quintic of Farouki 2003, section 4, as printed") {
  const auto& a = quintic.preimage();
  CHECK(triple_product(quintic) == Polynomial{-576, -6912, 32256, -66560, 74592, -49152, 16032});
  CHECK(sigma(a) == Polynomial{6, -12, 46, -72, 37});
  CHECK(rho(a) == Polynomial{720, -2976, 3376, -544, 80});
  const AngleSplit printed{{0, -8, 8}, {-96, -384, 416}};
  CHECK(closed_split(a) == printed);
  CHECK(test::split_by_linear_system(a) == printed);
  CHECK(evaluate(position(quintic), 1) ==
        Vector<Rational>{Rational(1, 15), Rational(38, 15), Rational(17, 5)});
}

TEST_CASE("invariants: law: |r′ × r″|² = f⁴σ²ρ and (r′ × r″)·r‴ from the hodograph itself") {
  for_samples(60, [](Random& random) {
    const Curve curve = random.curve(3);
    const auto& a = curve.preimage();
    const auto r1 = hodograph(curve);
    const auto r2 = derivative(r1);
    const auto r3 = derivative(r2);
    const auto normal = cross(r1, r2);
    CHECK(dot(normal, normal) == pow(curve.multiplier(), 4) * pow(sigma(a), 2) * rho(a));
    CHECK(dot(normal, r3) == triple_product(curve));
    CHECK(squared_curvature(curve) == RationalFunction(dot(normal, normal), pow(dot(r1, r1), 3)));
    if (rho(a).is_zero())
      CHECK_THROWS_AS(torsion(curve), DomainError);
    else
      CHECK(torsion(curve) == RationalFunction(dot(normal, r3), dot(normal, normal)));
    CHECK(differentiate(arc_length(curve)) == curve.multiplier() * sigma(a));
  });
}

TEST_CASE("invariants: law: 2h/σ is e₂′·e₃, the rate at which the ERF turns about its tangent") {
  for_samples(60, [](Random& random) {
    const auto a = random.quaternion_polynomial(3);
    const Polynomial s = sigma(a);
    // e₂ = (A j A*)/σ: e₂′·e₃ = (A j A*)′·(A k A*)/σ², because (A j A*)·(A k A*) = 0.
    CHECK(RationalFunction(dot(derivative(rotated_j(a)), rotated_k(a)), s * s) ==
          RationalFunction(Rational(2) * twist_numerator(a), s));
  });
}

TEST_CASE("invariants: law: σ, h, ρ do not change under a rotation of the curve") {
  for_samples(40, [](Random& random) {
    const auto a = random.quaternion_polynomial(3);
    const QuaternionPolynomial unit{{Rational(1, 5)},
                                    {Rational(-2, 5)},
                                    {Rational(4, 5)},
                                    {Rational(2, 5)}};  // 1 + 4 + 16 + 4 = 25
    const auto rotated = unit * a;
    CHECK(sigma(rotated) == sigma(a));
    CHECK(twist_numerator(rotated) == twist_numerator(a));
    CHECK(rho(rotated) == rho(a));
  });
}

TEST_CASE("invariants: law: the linear system gives the closed split, wherever it has a solution") {
  long solved = 0;
  for_samples(60, [&](Random& random) {
    const auto a = random.quaternion_polynomial(3);
    const auto split = test::split_by_linear_system(a);
    if (!split) return;
    ++solved;
    CHECK(*split == closed_split(a));
    CHECK(gcd(sigma(a), rho(a)).is_constant());
  });
  CHECK(solved > 10);
}

TEST_CASE(
    "invariants: law: signed curvature of a plane curve: its square is κ², its sign the turn") {
  for_samples(60, [](Random& random) {
    // A = u + qk lies in the xy-plane; a unit quaternion with norm 9/9 turns the plane.
    const Polynomial u = random.polynomial(3);
    const Polynomial q = random.nonzero_polynomial(3);
    const Curve flat({u, {}, {}, q}, {random.integer(1, 3)});
    const RationalFunction kappa = signed_curvature(flat);
    CHECK(kappa * kappa == squared_curvature(flat));
    const auto r1 = hodograph(flat);
    const auto r2 = derivative(r1);
    const Rational t(random.integer(-9, 9), 7);
    const Rational turn = (r1[0] * r2[1] - r1[1] * r2[0])(t);
    if (turn != 0) CHECK((kappa(t) > 0) == (turn > 0));
    const QuaternionPolynomial unit{{Rational(2, 3)}, {Rational(1, 3)}, {}, {Rational(2, 3)}};
    const Curve tilted(unit * flat.preimage(), flat.multiplier());
    const RationalFunction other = signed_curvature(tilted);
    CHECK((other == kappa || other == -kappa));
    CHECK(other * other == squared_curvature(tilted));
    CHECK(signed_curvature(Curve(flat.preimage(), -flat.multiplier())) == kappa);
  });
}

TEST_CASE("invariants: signed curvature by hand: 2/(1 + t²)², to the left and to the right") {
  const RationalFunction kappa({2}, {1, 0, 2, 0, 1});
  CHECK(signed_curvature(Curve({{1}, {}, {}, {0, 1}})) == kappa);
  CHECK(signed_curvature(Curve({{1}, {}, {}, {0, -1}})) == -kappa);
  CHECK(signed_curvature(Curve({{1, 1}, {}, {}, {}})) == RationalFunction());
  CHECK_THROWS_WITH_AS(signed_curvature(quintic), doctest::Contains("not plane"), DomainError);
  CHECK_THROWS_WITH_AS(signed_curvature(Curve({{1}, {}, {}, {0, 1}}, {-1, 2})),
                       doctest::Contains("changes sign"), DomainError);
  // r′ in the plane of (1, 0, 0) and (0, 1, 1): A = 1 + t(j − k)·…, of a normal (0, −1, 1)/√2.
  CHECK_THROWS_WITH_AS(signed_curvature(Curve({{1}, {}, {0, -1}, {0, 1}})),
                       doctest::Contains("not rational"), DomainError);
}

TEST_CASE("invariants: law: ω² = κ² + τ² is at least κ², and κ² where the curve is plane") {
  for_samples(40, [](Random& random) {
    const Curve curve = random.curve(3);
    if (rho(curve.preimage()).is_zero()) {
      CHECK_THROWS_AS(squared_frenet_rate(curve), DomainError);
      return;
    }
    const RationalFunction tau = torsion(curve);
    CHECK(squared_frenet_rate(curve) - squared_curvature(curve) == tau * tau);
  });
  const Curve flat({{1, 2}, {}, {}, {3, 0, 1}});
  CHECK(squared_frenet_rate(flat) == squared_curvature(flat));
}
