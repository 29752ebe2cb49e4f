#include "phrame/ph/curve/shape.hpp"

#include <tuple>

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RationalQuaternion small_quaternion(Random& random) {
  const auto c = [&] { return Rational(random.integer(-4, 4)); };
  return {c(), c(), c(), c()};
}

RationalQuaternion inverse_times(const RationalQuaternion& a, const RationalQuaternion& b) {
  return 1 / norm(a) * (conjugate(a) * b);
}

}  // namespace

TEST_CASE("shape: a line, a plane curve and a helix") {
  const QuaternionPolynomial line{{1, 2}, {0, 3}, {}, {}};  // v/u only: along (1, 0, 0)
  CHECK(line_direction(line) == Vector<Rational>{1, 0, 0});
  CHECK(plane_normal(line).has_value());
  CHECK_FALSE(helix(line).has_value());
  const QuaternionPolynomial backwards{{}, {}, {1, 2}, {0, 3}};
  CHECK(line_direction(backwards) == Vector<Rational>{-1, 0, 0});
  const QuaternionPolynomial plane{{1, 2}, {}, {}, {0, 3}};  // z = 2(vq − up) = 0
  CHECK_FALSE(line_direction(plane).has_value());
  CHECK(plane_normal(plane) == Vector<Rational>{0, 0, 1});
  CHECK_FALSE(helix(plane).has_value());
  // (u, v, p, q) = (1, t, t, 0): x = 1, y = 2t², z = −2t, σ = 1 + 2t²: y − σ = −x.
  const QuaternionPolynomial cubic{{1}, {0, 1}, {0, 1}, {}};
  CHECK_FALSE(plane_normal(cubic).has_value());
  CHECK(helix(cubic) == Helix{{{1, 1, 0}, 1, Rational(1, 2)}, 1, true});
}

TEST_CASE("shape: two curves that the slides on helices count wrongly") {
  // A₂ = A₀ + 2A₁ is dependent, but the curve is no plane one: a helix with tan²ψ = 1/2.
  const RationalQuaternion first{1, 0, 0, 0};
  const RationalQuaternion second{1, 2, 1, -1};
  const auto dependent = from_bernstein({first, second, {3, 4, 2, -2}});
  CHECK_FALSE(plane_normal(dependent).has_value());
  REQUIRE(helix(dependent).has_value());
  CHECK(helix(dependent)->cosine_squared == Rational(2, 3));
  CHECK(helix(dependent)->map_degree == 2);
  // A plane curve with a hodograph that is not primitive: (t² + 1)(1 − t², 2t, 0).
  const QuaternionPolynomial plane{{0, 1}, {-1}, {0, -1}, {0, 0, 1}};
  CHECK(plane_normal(plane) == Vector<Rational>{0, 0, 1});
  CHECK_FALSE(twist_numerator(plane).is_zero());
}

TEST_CASE("shape: law: every spatial PH cubic is a monotone helix with the angle of its polygon") {
  for_samples(60, [](Random& random) {
    const RationalQuaternion a0 = small_quaternion(random);
    const RationalQuaternion a1 = small_quaternion(random);
    const auto a = from_bernstein({a0, a1});
    if (norm(a0) == 0 || norm(a1) == 0 || a0 == a1) return;
    // Farouki's conditions: A₁ = A₀(α + βi + γj + δk).
    const auto [alpha, beta, gamma, delta] = inverse_times(a0, a1);
    const bool is_line = gamma == 0 && delta == 0;
    CHECK(line_direction(a).has_value() == is_line);
    CHECK(plane_normal(a).has_value() == (is_line || beta == 0));
    const auto found = helix(a);
    CHECK(found.has_value() == !plane_normal(a).has_value());
    if (!found) return;
    CHECK(found->map_degree == 1);
    CHECK(found->is_monotone);
    // The outer legs have the same angle to the middle one and the azimuth φ about it,
    // cos φ = 1 − 2·|L₁|²/(|L₀||L₂|); so they have to every leg the same angle to the axis.
    const auto points = control_points(Curve(a));
    const auto leg = [&](std::size_t k) {
      return Vector<Rational>{points[k + 1][0] - points[k][0], points[k + 1][1] - points[k][1],
                              points[k + 1][2] - points[k][2]};
    };
    const Rational length0 = norm(a0) / 3;
    const Rational length2 = norm(a1) / 3;
    CHECK(dot(leg(0), leg(1)) * length2 == dot(leg(2), leg(1)) * length0);
    const Rational middle = dot(leg(1), leg(1));
    if (middle == 0) return;
    const Rational along = dot(leg(0), leg(1)) * dot(leg(2), leg(1)) / middle;
    CHECK(dot(leg(0), leg(2)) - along ==
          (length0 * length2 - along) * (1 - 2 * middle / (length0 * length2)));
    CHECK(dot(found->axis, leg(0)) == found->constant * length0);
    CHECK(dot(found->axis, leg(2)) == found->constant * length2);
  });
}

TEST_CASE("shape: law: helical quintics are those of the conditions in α, β, γ, δ") {
  long general_ones = 0;
  long monotone_ones = 0;
  for_samples(300, [&](Random& random) {
    // A_r = A₀(α_r + β_r i + γ_r j + δ_r k) [Farouki, Giannelli, Sestini 2009].
    const RationalQuaternion a0 = small_quaternion(random);
    RationalQuaternion c1 = small_quaternion(random);
    RationalQuaternion c2 = small_quaternion(random);
    const Rational n = c1.p * c1.p + c1.q * c1.q;
    if (norm(a0) == 0 || n == 0) return;
    const auto r = [&] { return c1.p * c2.p + c1.q * c2.q; };
    const auto s = [&] { return c1.p * c2.q - c2.p * c1.q; };
    const auto monotone = [&]() -> std::pair<Rational, Rational> {
      return {(r() * c1.u + s() * c1.v) / n + (s() * s() - r() * r()) / (4 * n * n),
              (r() * c1.v - s() * c1.u) / n + 2 * r() * s() / (4 * n * n)};
    };
    switch (random.integer(0, 2)) {
      case 0: {
        const Rational factor = random.integer(-3, 3);
        c2 = {c2.u, factor * c1.v, factor * c1.p, factor * c1.q};
        break;
      }
      case 1:
        std::tie(c2.u, c2.v) = monotone();
        break;
      default:
        break;
    }
    const auto a = from_bernstein({a0, a0 * c1, a0 * c2});
    const bool is_general = s() == 0 && c1.v * r() == c2.v * n;
    const bool is_monotone = std::pair(c2.u, c2.v) == monotone();
    const auto found = helix(a);
    CHECK((found || plane_normal(a)) == (is_general || is_monotone));
    if (!found) return;
    CHECK(found->map_degree == (is_monotone ? 1 : 2));
    if (is_monotone) CHECK(found->is_monotone);
    ++(is_monotone ? monotone_ones : general_ones);
    CHECK(double_ph(a).has_value());
    // tan ψ = κ/τ (Lancret), so that sin²ψ·τ² = cos²ψ·κ².
    const Curve curve(a);
    const RationalFunction turn = torsion(curve);
    CHECK(RationalFunction({1 - found->cosine_squared}, {1}) * turn * turn ==
          RationalFunction({found->cosine_squared}, {1}) * squared_curvature(curve));
  });
  CHECK(general_ones > 20);
  CHECK(monotone_ones > 20);
}

TEST_CASE("shape: law: the relations hold; real factors and rotations leave the kind alone") {
  for_samples(40, [](Random& random) {
    // Every cubic is a helix, or plane.
    QuaternionPolynomial a = random.quaternion_polynomial(3);
    if (random.chance(2)) {
      const RationalQuaternion first = small_quaternion(random);
      const RationalQuaternion second = small_quaternion(random);
      if (norm(first) != 0) a = from_bernstein({first, second});
    }
    if (const auto n = plane_normal(a)) CHECK(dot(*n, rotated_i(a)).is_zero());
    if (const auto h = helix(a)) {
      CHECK(dot(h->axis, rotated_i(a)) == h->constant * sigma(a));
      CHECK(h->constant > 0);
      CHECK(h->cosine_squared * dot(h->axis, h->axis) == h->constant * h->constant);
    }
    const Polynomial f = random.nonzero_polynomial(2);
    const QuaternionPolynomial multiple{f * a.u, f * a.v, f * a.p, f * a.q};
    CHECK(helix(multiple) == helix(a));
    CHECK(plane_normal(multiple) == plane_normal(a));
    CHECK(line_direction(multiple) == line_direction(a));
    const RationalQuaternion turn{random.integer(1, 3), random.integer(-3, 3), 1, 0};
    const auto turned = QuaternionPolynomial{{turn.u}, {turn.v}, {turn.p}, {turn.q}} * a;
    CHECK(helix(turned).has_value() == helix(a).has_value());
    CHECK(plane_normal(turned).has_value() == plane_normal(a).has_value());
    if (const auto h = helix(turned)) CHECK(h->cosine_squared == helix(a)->cosine_squared);
  });
}

TEST_CASE("shape: of a path: one line, one plane, one angle for all segments") {
  using test::chain;
  const Curve line({{1}, {}, {}, {}});
  const Curve flat({{1}, {}, {}, {0, 1}});     // in the plane of x and y
  const Curve upright({{1}, {}, {0, 1}, {}});  // in that of x and z
  CHECK(line_direction(chain({line, line})) == Vector<Rational>{1, 0, 0});
  CHECK_FALSE(line_direction(chain({line, flat})));
  CHECK(plane_normal(chain({line, flat})) == Vector<Rational>{0, 0, 1});
  CHECK(plane_normal(test::closed_loop()) == Vector<Rational>{0, 0, 1});
  CHECK(plane_normal(chain({flat, rotated(flat, {1, 0, 0, 1})})) == Vector<Rational>{0, 0, 1});
  CHECK_FALSE(plane_normal(chain({reversed(rotated(flat, {0, 0, 0, 1})), upright})));
  // (x, y, z) = (1, 2t², −2t), σ = 1 + 2t²: x + y = σ.
  const Curve screw({{1}, {0, 1}, {0, 1}, {}});
  const auto angle = helix(test::cut(screw, {Rational(1, 3)}));
  REQUIRE(angle);
  CHECK(angle->axis == Vector<Rational>{1, 1, 0});
  CHECK(angle->cosine_squared == Rational(1, 2));
  CHECK(angle->axis == helix(screw.preimage())->axis);
  CHECK(angle->constant == helix(screw.preimage())->constant);
  CHECK(helix(chain({line, screw})));  // the line has the angle at which it meets the screw
  CHECK_FALSE(helix(chain({reversed(rotated(flat, {0, 0, 0, 1})), screw})));
  CHECK_FALSE(helix(test::closed_loop()));
}
