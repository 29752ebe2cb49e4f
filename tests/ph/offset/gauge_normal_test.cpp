#include "phrame/ph/offset/gauge_normal.hpp"

#include "phrame/ph/curve/identify.hpp"
#include "support/gauges.hpp"

namespace gauge_normal_test {

using namespace phrame;
using namespace phrame::test;

namespace {

Polynomial moebius(const Polynomial& p, long n) {  // (2 + φ)/(1 − 3φ)
  Polynomial sum;
  for (long k = 0; k <= n; ++k)
    sum += p.coefficient(k) * pow(Polynomial{2, 1}, k) * pow(Polynomial{1, -3}, n - k);
  return sum;
}

}  // namespace

TEST_CASE(
    "gauge normal: law: under the unit circle there is a rational normal where the curve is PH, "
    "and it is "
    "the normal") {
  const Gauge circle(unit_circle());
  long of_ph = 0;
  for_samples(40, [&](Random& random) {
    const GaussianPolynomial w = random.gaussian_polynomial(2);
    const bool is_ph = random.chance(2);
    const Polynomial x = is_ph ? w.re * w.re - w.im * w.im : random.polynomial(4);
    const Polynomial y = is_ph ? Rational(2) * w.re * w.im : random.polynomial(4);
    if (x.is_zero() && y.is_zero()) return;
    const RationalCurve curve({antiderivative(x), antiderivative(y), {}});
    const auto found = right_parameter(circle, curve);
    const auto* phi = std::get_if<GaugeParameter>(&found);
    const auto& [hx, hy, hz] = curve.direction();
    CHECK((phi != nullptr) == is_pythagorean(curve.direction()));
    if (phi == nullptr) {
      CHECK(std::get<NoGaugeParameter>(found).degrees == std::vector<long>{2});
      return;
    }
    ++of_ph;
    const GaugeVector u = vector_at(circle, *phi);
    CHECK(u.x * hx + u.y * hy == Polynomial());
    CHECK(hx(0) * u.y(0) * u.weight(0) <= hy(0) * u.x(0) * u.weight(0));
  });
  CHECK(of_ph > 10);
}

TEST_CASE("gauge normal: it does not depend on the parameter of the gauge") {
  const Path path = oval(Rational(1, 5));
  const RationalCurve u = std::get<RationalCurve>(path.segments().front());
  const Gauge gauge(path);
  const Gauge other(plane_path(moebius(u.numerator()[0], 4), moebius(u.numerator()[1], 4),
                               moebius(u.weight(), 4)));
  for_samples(6, [&](Random& random) {
    const GaugeParameter along{random.polynomial(2), random.nonzero_polynomial(1)};
    if (along.p.degree() < 1) return;
    const auto form = [&](const Polynomial& c) {
      Polynomial sum;
      const long e = std::max(gauge.direction()[0].degree(), gauge.direction()[1].degree());
      for (long k = 0; k <= e; ++k) sum += c.coefficient(k) * pow(along.p, k) * pow(along.q, e - k);
      return antiderivative(sum);
    };
    const RationalCurve curve({form(gauge.direction()[0]), form(gauge.direction()[1]), {}});
    const auto a = right_parameter(gauge, curve);
    const auto b = right_parameter(other, curve);
    REQUIRE(a.index() == 0);
    REQUIRE(b.index() == 0);
    const GaugeVector at_a = vector_at(gauge, std::get<GaugeParameter>(a));
    const GaugeVector at_b = vector_at(other, std::get<GaugeParameter>(b));
    CHECK(at_a.x * at_b.weight == at_b.x * at_a.weight);
    CHECK(at_a.y * at_b.weight == at_b.y * at_a.weight);
  });
}

TEST_CASE("gauge normal: a line has a rational normal or the degrees of why not") {
  const auto line = [](long x, long y) { return RationalCurve({Polynomial{0, x}, {0, y}, {}}); };
  const Gauge gauge(ellipse(3, 0, 0, 2));
  CHECK(right_parameter(gauge, line(1, 0)).index() == 0);
  CHECK(right_parameter(gauge, line(0, 1)).index() == 0);
  CHECK(right_parameter(gauge, line(0, -1)).index() == 0);
  // (−3 sin θ, 2 cos θ) is along (9, 8) for (cos θ, sin θ) = (4, −3)/5, and along (1, 1) for (3,
  // −2)/√13.
  CHECK(right_parameter(gauge, line(9, 8)).index() == 0);
  CHECK(std::get<NoGaugeParameter>(right_parameter(gauge, line(1, 1))).degrees ==
        std::vector<long>{2});
}

}  // namespace gauge_normal_test
