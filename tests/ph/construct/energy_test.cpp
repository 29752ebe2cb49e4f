#include "phrame/ph/construct/energy.hpp"

#include <numbers>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/totals.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// Without cusps: |A| ≥ 2 for its first part is ≥ 2.
QuaternionPolynomial smooth_preimage(Random& random, long degree) {
  const auto part = [&](long first) {
    std::vector<Rational> c{first};
    for (long k = 1; k <= degree; ++k) c.emplace_back(random.integer(0, 9), 10);
    return Polynomial(c);
  };
  return {part(2), part(-1), part(1), part(0)};
}

std::vector<Quaternion<double>> in_doubles(const QuaternionPolynomial& a, long degree) {
  std::vector<Quaternion<double>> list;
  for (const RationalQuaternion& b : to_bernstein(a, degree))
    list.push_back({static_cast<double>(b.u), static_cast<double>(b.v), static_cast<double>(b.p),
                    static_cast<double>(b.q)});
  return list;
}

}  // namespace

// bending_energy() is the integral in closed form.
TEST_CASE("energy: law: the quadrature agrees with the certified integral") {
  for_samples(20, [](Random& random) {
    const Curve curve(smooth_preimage(random, random.integer(1, 3)));
    const auto exact = bending_energy(curve);
    const double energy = round_to_double(std::get<CurveTotal>(exact).value);
    CHECK(approximate_energy(in_doubles(curve.preimage(), 3)) ==
          doctest::Approx(energy).epsilon(1e-7));
  });
}

// The closed form at 60 digits is in the ball of the quadrature, near cusps too: for ε → 0 the
// preimage 1 + … has a zero next to t = 1/2.
TEST_CASE("energy: law: the ball has the closed form in it, and 26 bits") {
  const auto check = [](const Curve& curve) {
    const auto exact = bending_energy(curve);
    const auto found = proved_energy(curve);
    REQUIRE(found);
    CHECK(found->overlaps(std::get<CurveTotal>(exact).value.enclose(200)));
    CHECK(found->accuracy_bits() >= 26);
  };
  for_samples(10, [&](Random& random) {
    check(Curve(smooth_preimage(random, random.integer(1, 3)), Polynomial{random.integer(1, 9)}));
  });
  for (const long places : {1L, 3L, 6L})
    check(Curve({Polynomial{-1, 2}, Polynomial{power_of_ten(-places)}, {}, {0, 1, -1}}));
  check(Curve({Polynomial{1, 1}, {}, {}, {0, 1}}, Polynomial{power_of_ten(-40)}));
  // A straight line has none, and a cusp infinitely much.
  CHECK(proved_energy(Curve({Polynomial{1, 1}, {}, {}, {}}))->is_zero());
  CHECK_FALSE(proved_energy(Curve({Polynomial{-1, 2}, {}, {}, {0, -1, 2}})));
}

TEST_CASE("energy: law: a square in the multiplier is one in the preimage") {
  for_samples(20, [](Random& random) {
    const QuaternionPolynomial a = smooth_preimage(random, random.integer(0, 3));
    const Polynomial p{1, Rational(random.integer(1, 9), 10)};
    std::vector<double> f;
    for (const Rational& b : to_bernstein(p * p, 2)) f.push_back(static_cast<double>(b));
    CHECK(approximate_energy(in_doubles(a, 3), f) ==
          doctest::Approx(approximate_energy(in_doubles({p * a.u, p * a.v, p * a.p, p * a.q}, 4)))
              .epsilon(1e-9));
  });
}

// r times c has 1/c of the energy.
TEST_CASE("energy: curves of any size have one") {
  Random random(3);
  const QuaternionPolynomial a = smooth_preimage(random, 2);
  const Rational energy = proved_energy(Curve(a))->midpoint();
  for (const long exponent : {-120L, -7L, 90L}) {
    const Rational c = power_of_ten(exponent);
    const Rational of_size = proved_energy(Curve(a, Polynomial{c}))->midpoint();
    CHECK(abs(of_size * c - energy) < energy * power_of_two(-25));
  }
}

// x′ + iy′ = (1 + ti)², of which the argument goes from 0 to 2 atan 1.
TEST_CASE("energy: the turning is the angle of the tangents of a plane curve") {
  const QuaternionPolynomial a{Polynomial{1}, {}, {}, Polynomial{0, 1}};
  CHECK(approximate_turning(in_doubles(a, 1)) ==
        doctest::Approx(std::numbers::pi / 2).epsilon(1e-12));
}
