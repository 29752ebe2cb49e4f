#include "phrame/ph/offset/gauge.hpp"

#include "phrame/algebra/error.hpp"
#include "support/gauges.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace gauge_test {

using namespace phrame;
using namespace phrame::test;

TEST_CASE("gauge: ovals whose curvature is known to have no zero are taken, others are not") {
  for (const Rational& a : {Rational(1, 4), Rational(-33, 100), Rational(0)})
    CHECK(Gauge(oval(a)).degree() == (a == 0 ? 2 : 4));
  CHECK(Gauge(oval(Rational(1, 16), 2)).degree() == 8);
  for (const Rational& a : {Rational(34, 100), Rational(-1, 2)})
    CHECK(contains(refusal_of<DomainError>([&] { Gauge{oval(a)}; }),
                   "gauge: it is not strictly convex: U' x U'' = 0 at phi"));
  CHECK(contains(refusal_of<DomainError>([] { Gauge{oval(Rational(1, 14), 2)}; }), "U' x U''"));
  // With (4k² − 1)|a| = 1 the curvature is 0 in some points, without a change of sign.
  CHECK(contains(refusal_of<DomainError>([] { Gauge{oval(Rational(-1, 3))}; }),
                 "U' x U'' = 0 at phi = -1"));
  CHECK(contains(refusal_of<DomainError>([] { Gauge{oval(Rational(1, 3))}; }),
                 "U' x U'' = 0 at phi = 0"));
}

TEST_CASE("gauge: what is not closed, symmetric, convex, plane, or is traced several times") {
  const auto refused = [](const Path& path) {
    return refusal_of<DomainError>([&] { Gauge{path}; });
  };
  CHECK(contains(refused(plane_path({0, 1}, {0, 0, 1}, {1})),
                 "not closed: it goes to infinity at phi = infinity"));
  CHECK(contains(refused(plane_path({1, 0, 1}, {0, 2}, {4, 0, -1})),
                 "it goes to infinity at phi = -2"));
  CHECK(contains(refused(plane_path({2, 0, 0}, {0, 2}, {1, 0, 1})), "not symmetric about (0, 0)"));
  // A limaçon 2 + cos θ about its inside turns once, 1 + 2cos θ twice.
  const auto limacon = [](long a, long b) {
    const Polynomial r = Rational(a) * Polynomial{1, 0, 1} + Rational(b) * Polynomial{1, 0, -1};
    return plane_path(r * Polynomial{1, 0, -1}, r * Polynomial{0, 2}, pow(Polynomial{1, 0, 1}, 2));
  };
  CHECK(contains(refused(limacon(3, 1)), "not symmetric"));
  CHECK(contains(refused(limacon(1, 2)), "it turns 2 times"));
  // A segment there and back, and the circle of φ³ + φ.
  CHECK(contains(refused(plane_path({0, 2}, {0, 4}, {1, 0, 1})), "U' = 0 at phi"));
  const Polynomial g{0, 1, 0, 1};
  CHECK(contains(refused(plane_path(Polynomial{1} - g * g, Rational(2) * g, Polynomial{1} + g * g)),
                 "U' = 0 at phi = infinity"));
  // h = φ(φ² + 9)/(φ² + 3) increases from −∞ to ∞: h′ = (φ⁴ + 27)/(φ² + 3)².
  const Polynomial p{0, 9, 0, 1};
  const Polynomial q{3, 0, 1};
  CHECK(contains(refused(plane_path(q * q - p * p, Rational(2) * p * q, p * p + q * q)),
                 "traced 3 times"));
  CHECK(contains(
      refused(Path(Segment(RationalCurve({Polynomial{1, 0, -1}, {0, 2}, {1, 0, 1}}, {1, 0, 1})))),
      "not in the plane z = 0"));
}

TEST_CASE("gauge: segments are of one curve, whatever their parameters") {
  Path halves = ellipse(3, 0, 0, 2);
  halves.append(RationalCurve({Polynomial{0, -6}, {2, 0, -2}, {}}, {1, 0, 1}));
  CHECK(Gauge(halves).degree() == 2);
  Path other = ellipse(3, 0, 0, 2);
  other.append(RationalCurve({Polynomial{0, -4}, {2, 0, -2}, {}}, {1, 0, 1}));
  CHECK(contains(refusal_of<DomainError>([&] { Gauge{other}; }), "segment 2 is on another one"));
}

}  // namespace gauge_test
