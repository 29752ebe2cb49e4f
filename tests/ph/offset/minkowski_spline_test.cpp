#include "phrame/ph/offset/minkowski_spline.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace minkowski_spline_test {

using namespace phrame;
using namespace phrame::test;

namespace {

const Deviation fine{Rational(1, 1000000000000), Rational(1, 1000000000000)};

Vector<Rational> end_of(const MinkowskiCurve& curve, long t) {
  return evaluate(position(curve), t);
}
Vector<Rational> rate_at(const MinkowskiCurve& curve, const Rational& t) {
  return evaluate(differentiate(position(curve)), t);
}
Rational squared(const Vector<Rational>& v) { return dot(v, v); }

/// A helix-like curve of discs, spacelike, by rational functions: (t, t²/2, 1 + t/3 + t³/9).
HermiteSpline sampled(const Rational& from, const Rational& to, long segments) {
  const auto r = [](const Rational& t) -> Vector<Rational> {
    return {t, t * t / 2, 1 + t / 3 + t * t * t / 9};
  };
  const auto d = [](const Rational& t) -> Vector<Rational> {
    return {1, t, Rational(1, 3) + t * t / 3};
  };
  HermiteSpline data;
  for (long k = 0; k <= segments; ++k) {
    const Rational t = from + (to - from) * Rational(k, segments);
    data.points.push_back(r(t));
    data.derivatives.push_back(d(t));
    data.parameters.push_back(t);
  }
  return data;
}

}  // namespace

TEST_CASE(
    "minkowski spline: law: within the tolerance of the data, C1 at the joints exactly, and MPH") {
  for_samples(8, [](Random& random) {
    HermiteSpline data;
    Rational t;
    for (long k = 0; k < 4; ++k) {
      const auto small = [&](long d) { return Rational(random.integer(-9, 9), d); };
      data.points.push_back({k + small(40), small(20), 3 + small(40)});
      data.derivatives.push_back({1 + small(30), small(20), small(30)});
      data.parameters.push_back(t);
      t += 1 + small(40);
    }
    const MinkowskiSpline found = minkowski_spline(data, fine);
    CHECK(is_within(found.deviation, fine));
    REQUIRE(found.axis.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const MinkowskiCurve& curve = found.axis[k];
      const auto hodograph = differentiate(position(curve));
      const Polynomial s = curve.multiplier * spacelike_root(curve);
      CHECK(hodograph[0] * hodograph[0] + hodograph[1] * hodograph[1] -
                hodograph[2] * hodograph[2] ==
            s * s);
      for (const Polynomial& x : hodograph) CHECK(x.degree() <= 4);
      CHECK(squared(end_of(curve, 1) - data.points[k + 1]) <=
            found.deviation.points * found.deviation.points);
      const Rational per_step = 1 / data.step(k);
      for (const long end : {0, 1}) {
        const auto off =
            per_step * rate_at(curve, end) - data.derivatives[k + static_cast<std::size_t>(end)];
        CHECK(squared(off) <= found.deviation.derivatives * found.deviation.derivatives);
      }
      if (k == 0) continue;
      CHECK(end_of(found.axis[k - 1], 1) == curve.start);
      CHECK(1 / data.step(k - 1) * rate_at(found.axis[k - 1], 1) == per_step * rate_at(curve, 0));
    }
  });
}

TEST_CASE("minkowski spline: of smooth data the error falls as the fourth power of the step") {
  // Of the middle of [1/2, 1/2 + h], in units of h⁴: the quotients of errors tend to 16.
  const auto error = [](long parts) {
    const Rational to = Rational(1, 2) + Rational(1, parts);
    const MinkowskiSpline found = minkowski_spline(sampled(Rational(1, 2), to, 1), fine);
    const HermiteSpline middle = sampled(Rational(1, 2), to, 2);
    const Vector<Rational> off =
        evaluate(position(found.axis[0]), Rational(1, 2)) - middle.points[1];
    return std::sqrt(static_cast<double>(squared(off)));
  };
  CHECK(error(8) / error(16) == doctest::Approx(16).epsilon(0.1));
  CHECK(error(16) < 1e-6);
}

TEST_CASE(
    "minkowski spline: a constant radius stays constant, and backwards it is the same curve") {
  HermiteSpline flat{
      {{0, 0, 2}, {3, 1, 2}, {4, 3, 2}}, {{2, 1, 0}, {1, 2, 0}, {-1, 2, 0}}, {0, 1, 3}};
  for (const MinkowskiCurve& curve : minkowski_spline(flat, fine).axis)
    CHECK(position(curve)[2] == Polynomial{2});
  HermiteSpline data = sampled(0, Rational(1, 2), 1);
  const MinkowskiCurve there = minkowski_spline(data, fine).axis[0];
  std::ranges::reverse(data.points);
  std::ranges::reverse(data.derivatives);
  for (auto& d : data.derivatives) d = Rational(-1) * d;
  const MinkowskiCurve back = minkowski_spline(data, fine).axis[0];
  for (const Rational& t : {Rational(1, 4), Rational(1, 2), Rational(3, 4)}) {
    const auto off = evaluate(position(there), t) - evaluate(position(back), 1 - t);
    CHECK(squared(off) < Rational(1, 10000000000));  // λ and μ have 20 bits
  }
}

TEST_CASE("minkowski spline: exact where the square roots are rational") {
  const HermiteSpline line{{{0, 0, 1}, {5, 0, 4}}, {{5, 0, 3}, {5, 0, 3}}, {0, 1}};
  const MinkowskiSpline found = minkowski_spline(line, fine);
  CHECK(found.deviation == Deviation{0, 0});
  CHECK((position(found.axis[0]) == Vector<Polynomial>{Polynomial{0, 5}, {}, {1, 3}}));
  // The plane PH cubic with a = d = 1 + t, b = c = 1, and its image under a Lorentz transformation.
  const Polynomial x{0, 1, Rational(1, 2)};
  const Polynomial y{0, 0, Rational(1, 2), Rational(1, 6)};
  const Rational cosh(5, 4), sinh(3, 4);
  for (const Vector<Polynomial>& r : {Vector<Polynomial>{x, y, {}}, {cosh * x, y, sinh * x}}) {
    const auto d = differentiate(r);
    const HermiteSpline data{
        {evaluate(r, 0), evaluate(r, 1)}, {evaluate(d, 0), evaluate(d, 1)}, {0, 1}};
    const MinkowskiSpline cubic = minkowski_spline(data, fine);
    CHECK(cubic.deviation == Deviation{0, 0});
    CHECK(position(cubic.axis[0]) == r);
  }
}

TEST_CASE("minkowski spline: data of any size, to any tolerance") {
  for (const long e : {-30, 0, 30}) {
    const Rational c = power_of_ten(e);
    HermiteSpline data = sampled(0, 1, 2);
    for (auto& p : data.points) p = c * p;
    for (auto& d : data.derivatives) d = c * d;
    const Deviation tolerance{c * power_of_ten(-60), c * power_of_ten(-60)};
    CHECK(is_within(minkowski_spline(data, tolerance).deviation, tolerance));
  }
}

TEST_CASE("minkowski spline: what has none is refused, with the point or the segment") {
  const auto refused = [](const HermiteSpline& data) {
    return refusal_of<DomainError>([&] { minkowski_spline(data, fine); });
  };
  CHECK(contains(refused({{{0, 0, 1}, {1, 0, 1}}, {{1, 0, 0}, {1, 1, 2}}, {0, 1}}),
                 "the derivative at point 2 has x'^2 + y'^2 < r'^2"));
  CHECK(contains(refused({{{0, 0, 1}, {1, 0, 1}}, {{0, 0, 0}, {1, 1, 1}}, {0, 1}}), "point 1"));
  CHECK(contains(refused({{{0, 0, 1}, {1, 0, 9}}, {{1, 0, 0}, {1, 0, 0}}, {0, 1}}),
                 "segment 1 has no such Minkowski PH quintic"));
}

}  // namespace minkowski_spline_test
