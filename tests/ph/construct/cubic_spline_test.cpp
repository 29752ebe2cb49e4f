#include "phrame/ph/construct/cubic_spline.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Deviation tolerance(const char* text) { return {parse_rational(text), parse_rational(text)}; }

/// A cubic with small coefficients, tangents not parallel.
Curve random_cubic(Random& random) {
  const auto linear = [&] {
    return Polynomial{Rational(random.integer(-5, 5)), Rational(random.integer(-5, 5), 3)};
  };
  for (;;) {
    const QuaternionPolynomial a{linear(), linear(), linear(), linear()};
    const Vector<Rational> d0 = rotated_i(evaluate(a, 0));
    const Vector<Rational> d1 = rotated_i(evaluate(a, 1));
    const Rational cross_x = d0[1] * d1[2] - d0[2] * d1[1];
    if (cross_x != 0 && degree(a) == 1) return Curve(a, Polynomial{1}, {1, 2, 3});
  }
}

HermiteSpline data_of(const Curve& cubic) {
  return {{cubic.start(), evaluate(position(cubic), 1)},
          {evaluate(hodograph(cubic), 0), evaluate(hodograph(cubic), 1)},
          {0, 1}};
}

Rational distance(const Curve& a, const Curve& b) {
  const auto p = control_points(a);
  const auto q = control_points(b);
  Rational most;
  for (std::size_t k = 0; k < p.size(); ++k)
    for (std::size_t j = 0; j < 3; ++j) most = std::max(most, abs(p[k][j] - q[k][j]));
  return most;
}

}  // namespace

TEST_CASE("PH cubics: one that is known comes back, first or second") {
  for_samples(30, [](Random& random) {
    const Curve cubic = random_cubic(random);
    const HermiteSpline data = data_of(cubic);
    Rational least = 1;
    for (long solution = 1; solution <= cubic_solutions; ++solution) try {
        const Construction found = cubic_spline(data, solution, tolerance("1e-20"));
        CHECK(found.deviation.points <= parse_rational("1e-20"));
        const Curve& curve = found.path.segments().front();
        CHECK(degree(curve) == 3);
        least = std::min(least, distance(curve, cubic));
      } catch (const DomainError& error) {
        CHECK(std::string(error.what()) ==
              "segment 1: there is only one PH cubic with these ends and tangents");
      }
    CHECK(least < parse_rational("1e-14"));
  });
}

TEST_CASE("PH cubics: of a spline the joints are exact, and the data met as proved") {
  // Two cubics of a helix-like path: known ones, the second rotated to where the first one ends.
  for_samples(10, [](Random& random) {
    const Curve first = random_cubic(random);
    const HermiteSpline start = data_of(first);
    const QuaternionPolynomial a{compose(first.preimage().u, Polynomial{1, 1}),
                                 compose(first.preimage().v, Polynomial{1, 1}),
                                 compose(first.preimage().p, Polynomial{1, 1}),
                                 compose(first.preimage().q, Polynomial{1, 1})};
    const Curve second(a, Polynomial{2}, start.points[1]);
    const HermiteSpline next = data_of(second);
    const HermiteSpline data{{start.points[0], start.points[1], next.points[1]},
                             {start.derivatives[0], start.derivatives[1], next.derivatives[1]},
                             {0, 1, 2}};
    std::optional<Construction> found;
    try {
      found = cubic_spline(data, 1, tolerance("1e-15"));
    } catch (const DomainError&) {
      return;  // tangents of the second that are parallel
    }
    const auto& segments = found->path.segments();
    REQUIRE(segments.size() == 2);
    CHECK(evaluate(position(segments[0]), 1) == segments[1].start());
    for (std::size_t k = 0; k < 2; ++k)
      for (const bool at_end : {false, true}) {
        const Curve& curve = segments[k];
        const Vector<Rational> r = at_end ? evaluate(position(curve), 1) : curve.start();
        const Vector<Rational> t = evaluate(hodograph(curve), at_end ? 1 : 0);
        const Vector<Rational>& d = data.derivatives[k + (at_end ? 1 : 0)];
        Rational off, tt, dd, td;
        for (std::size_t j = 0; j < 3; ++j) {
          const Rational x = r[j] - data.points[k + (at_end ? 1 : 0)][j];
          off += x * x;
          tt += t[j] * t[j];
          dd += d[j] * d[j];
          td += t[j] * d[j];
        }
        CHECK(off <= found->deviation.points * found->deviation.points);
        CHECK(td > 0);
        CHECK(1 - td * td / (tt * dd) <=
              found->deviation.derivatives * found->deviation.derivatives);
      }
  });
}

TEST_CASE("PH cubics: straight data have a line, others with parallel tangents none") {
  const HermiteSpline line{{{0, 0, 0}, {2, 4, -4}}, {{1, 2, -2}, {2, 4, -4}}, {0, 1}};
  const Construction found = cubic_spline(line, 1, tolerance("1e-15"));
  CHECK(found.deviation.points <= parse_rational("1e-15"));
  const auto refusal = [](const HermiteSpline& data) -> std::string {
    return test::refusal_of<DomainError>([&] { cubic_spline(data, 1, tolerance("1e-15")); });
  };
  CHECK(refusal({{{0, 0, 0}, {1, 1, 0}}, {{1, 0, 0}, {1, 0, 0}}, {0, 1}}) ==
        "segment 1: there is no PH cubic with these ends and tangents");
  CHECK(refusal({{{0, 0, 0}, {1, 1, 0}}, {{1, 0, 0}, {0, 0, 0}}, {0, 1}}) ==
        "the derivative at point 2 is 0: it has no direction");
}

// Their derivatives are rounded, and along the line all the same. (1, 2, 3) has no rational length.
TEST_CASE("PH cubics: points on a line have it, whatever its direction") {
  for (const Vector<Rational>& d :
       {Vector<Rational>{1, 2, 3}, Vector<Rational>{1, 2, 2}, Vector<Rational>{-3, 0, 4},
        Vector<Rational>{0, Rational(1, 7), -1}}) {
    GivenPoints given;
    for (const long s : {0, 1, 2, 4, 7, 12})
      given.points.push_back(Vector<Rational>{1, 2, 3} + Rational(s) * d);
    for (const char* size : {"1e-15", "1e-40"}) {
      const Construction found = cubic_spline(hermite_spline(given, false), 1, tolerance(size));
      CHECK(found.path.segments().size() == 5);
      CHECK(found.deviation.points <= parse_rational(size));
      for (const Curve& curve : found.path.segments()) CHECK(degree(curve) == 1);
    }
  }
}

// The angle between the tangents is more or less than what is rounded.
TEST_CASE("PH cubics: tangents that are nearly parallel are no line, but for the tolerance") {
  for (const char* angle : {"1e-8", "1e-12", "1e-14", "1e-17", "1e-30"}) {
    CAPTURE(angle);
    const Rational e = parse_rational(angle);
    // A slow turn and unlike speeds: a PH cubic that is nearly straight.
    const Curve cubic({{1, 1}, {}, {0, e}, {0, Rational(2 * e)}}, Polynomial{1}, {1, 2, 3});
    for (const char* size : {"1e-15", "1e-40"}) {
      CAPTURE(size);
      const Construction found = cubic_spline(data_of(cubic), 1, tolerance(size));
      CHECK(found.deviation.points <= parse_rational(size));
      CHECK(found.deviation.derivatives <= parse_rational(size));
    }
  }
  // The way is off by 10⁻⁹ beside tangents with an angle of 10⁻¹³: none, and none is found.
  const HermiteSpline off{
      {{0, 0, 0}, {1, power_of_ten(-9), 0}}, {{1, 0, 0}, {1, 0, power_of_ten(-13)}}, {0, 1}};
  CHECK_THROWS_WITH_AS(cubic_spline(off, 1, tolerance("1e-15")),
                       "segment 1: there is no PH cubic with these ends and tangents", DomainError);
  CHECK(cubic_spline(off, 1, tolerance("1e-8")).deviation.points < power_of_ten(-8));
}
