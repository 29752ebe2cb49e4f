#include "phrame/ph/proof/classify.hpp"

#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

TEST_CASE("classify: the double PH curve of degree 7 that is no helix") {
  // 3r′ = B i B* with B = (3t − t³) − 3t²i + 3k [Beltran, Monterde 2007].
  const Curve curve({{0, 3, 0, -1}, {0, 0, -3}, {}, {3}}, Polynomial{Rational(1, 3)});
  const auto [x, y, z] = position(curve);
  CHECK(x == Polynomial{0, -3, 0, 1, 0, Rational(1, 5), 0, Rational(1, 21)});
  CHECK(y == Polynomial{0, 0, 3, 0, Rational(-1, 2)});
  CHECK(z == Polynomial{0, 0, 0, -2});
  const Classification c = classify(curve);
  CHECK_FALSE(c.helix.has_value());
  CHECK_FALSE(c.normal.has_value());
  REQUIRE(c.double_ph.has_value());
  CHECK(c.double_ph->omega == Polynomial{1, 0, 1});
  // |r′ × r″| = 2(t² + 1)(t⁶ + 3t⁴ + 9t² + 9) = f²σ·√(constant)·ω, and |r′| = fσ.
  const Polynomial speed{9, 0, 9, 0, 3, 0, 1};
  CHECK(curve.multiplier() * sigma(curve.preimage()) == Rational(1, 3) * speed);
  CHECK(pow(curve.multiplier(), 4) * pow(sigma(curve.preimage()), 2) *
            Polynomial{c.double_ph->constant} ==
        Rational(4) * pow(speed, 2));
  CHECK(c.cusps.empty());
  CHECK(c.content.is_constant());
}

TEST_CASE("classify: cusps and inflections with their orders, also at the ends") {
  // f = t(1 − 2t)², A with the real factor (1 − 3t) and g = 3(β′) with a real zero.
  const Polynomial c{1, -3};
  const QuaternionPolynomial a{c, {}, {}, c * Polynomial{0, 0, 1}};  // α = c, β = c·t²
  const Curve curve(a, Polynomial{0, 1} * pow(Polynomial{1, -2}, 2));
  const std::vector<RealRoot> cusps = {{Rational(0), 1}, {Rational(1, 3), 2}, {Rational(1, 2), 2}};
  CHECK(phrame::cusps(curve) == cusps);
  // g = c²·2t.
  CHECK(inflections(a) == std::vector<RealRoot>{{Rational(0), 1}});
  const Classification all = classify(curve);
  CHECK(all.cusps == cusps);
  CHECK(all.normal == Vector<Rational>{0, 0, 1});
  CHECK(all.erf_is_rotation_minimizing);
}

TEST_CASE("classify: a straight line is many things") {
  const Classification c = classify(Curve({{1, 2}, {0, 3}, {}, {}}));
  CHECK(c.line == Vector<Rational>{1, 0, 0});
  CHECK(c.normal.has_value());
  CHECK_FALSE(c.helix.has_value());
  CHECK(c.double_ph == DoublePh{0, {1}});
  CHECK(c.inflections.empty());
  CHECK(std::holds_alternative<RationalFrame>(c.rational_frame));
  CHECK(c.content == primitive_part(sigma({{1, 2}, {0, 3}, {}, {}})));
}

TEST_CASE("classify: law: the witnesses stand, and real factors do not matter") {
  for_samples(25, [](Random& random) {
    const Curve curve = random.curve(3);
    const Classification c = classify(curve);  // checks its witnesses itself
    const QuaternionPolynomial& a = curve.preimage();
    // By independent means: the number of cusps, h = 0, primitivity.
    const auto r = hodograph(curve);
    Polynomial common = gcd(gcd(r[0], r[1]), r[2]);
    CHECK(common == c.content);
    CHECK(static_cast<long>(c.cusps.size()) ==
          count_real_roots(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], closed_interval(0, 1)));
    CHECK(c.erf_is_rotation_minimizing == rate_to_erf(a).is_zero());
    if (c.helix || c.normal) CHECK((c.double_ph.has_value() || c.normal.has_value()));
    if (c.helix) CHECK(c.double_ph.has_value());
    const Polynomial f{random.integer(1, 3), random.integer(-5, 5)};
    const QuaternionPolynomial multiple{f * a.u, f * a.v, f * a.p, f * a.q};
    CHECK(inflections(multiple) == c.inflections);
    CHECK(erf_turning(Curve(multiple)).zeros == c.erf_turning.zeros);
    CHECK(rational_frame(multiple).index() == c.rational_frame.index());
    CHECK(double_ph(multiple).has_value() == c.double_ph.has_value());
  });
}
