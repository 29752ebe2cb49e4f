#include "phrame/ph/invariants.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
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

const Curve quintic({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                     from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});

}  // namespace

TEST_CASE("invariants: the quintic of Farouki 2003, section 4, as printed") {
  const auto& a = quintic.preimage();
  CHECK(triple_product(quintic) == Polynomial{-576, -6912, 32256, -66560, 74592, -49152, 16032});
  CHECK(sigma(a) == Polynomial{6, -12, 46, -72, 37});
  CHECK(rho(a) == Polynomial{720, -2976, 3376, -544, 80});
  const AngleSplit printed{{0, -8, 8}, {-96, -384, 416}};
  CHECK(closed_split(a) == printed);
  CHECK(split_by_linear_system(a) == printed);
  CHECK(segment_length(quintic) == Rational(71, 15));
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
    const auto split = split_by_linear_system(a);
    if (!split) return;
    ++solved;
    CHECK(*split == closed_split(a));
    CHECK(gcd(sigma(a), rho(a)).is_constant());
  });
  CHECK(solved > 10);
}

TEST_CASE("invariants: the length of a segment on which f changes sign is not ∫fσ") {
  const QuaternionPolynomial line{{1}, {}, {}, {}};
  CHECK(segment_length(Curve(line, {-3})) == 3);
  CHECK(segment_length(Curve(line, {-1, 2})) == std::nullopt);
  CHECK(segment_length(Curve(line, pow(Polynomial{-1, 2}, 2))) == Rational(1, 3));
}

TEST_CASE("invariants: n and b flip at the zeros of odd order of g, and only there") {
  const auto at = [](const Rational& t) { return std::vector<Interval>{closed(t, t)}; };
  // A = 1 + ck: g = c′.
  const auto flips = [](const Polynomial& c) {
    return normal_flips({{1}, {}, {}, c}, closed(0, 1));
  };
  CHECK(flips({0, 0, 1}) == at(0));
  CHECK(flips({0, -1, 1}) == at(Rational(1, 2)));
  CHECK(flips(pow(Polynomial{-1, 2}, 3)).empty());
  CHECK(flips(pow(Polynomial{-1, 2}, 4)) == at(Rational(1, 2)));
  CHECK(flips({0, -3, 1}).empty());  // at 3/2
  // A real factor of A is a double factor of g.
  const Polynomial c{-1, 3};
  CHECK(normal_flips({c, {}, {}, c * Polynomial{0, -1, 1}}, closed(0, 1)) == at(Rational(1, 2)));
  CHECK_THROWS_AS(normal_flips({{1, 1}, {}, {}, {}}, closed(0, 1)), DomainError);
}
