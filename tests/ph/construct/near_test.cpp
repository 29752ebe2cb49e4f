#include "phrame/ph/construct/near.hpp"

#include <doctest/doctest.h>

#include <random>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/bezier_points.hpp"
#include "phrame/ph/curve/quaternion.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace near_test {

using namespace phrame;
using namespace phrame::test;

namespace {

using Points = BezierPoints;

/// Bernstein coefficients like those that programs have: normally distributed.
class Gauss {
 public:
  explicit Gauss(long seed) : engine_(static_cast<unsigned long>(seed)) {}
  Rational number() { return exact_rational(distribution_(engine_)); }
  Polynomial polynomial(long m) {
    std::vector<Rational> b;
    for (long k = 0; k <= m; ++k) b.push_back(number());
    return from_bernstein(b);
  }
  QuaternionPolynomial preimage(long m) {
    return {polynomial(m), polynomial(m), polynomial(m), polynomial(m)};
  }
  Curve curve(long m) { return Curve(preimage(m), Polynomial{1}, {number(), number(), number()}); }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> distribution_;
};

Rational greatest(const Points& points) {
  Rational size = 0;
  for (const auto& p : points)
    for (const Rational& x : p) size = std::max(size, Rational(abs(x)));
  return size;
}

template <class T>
Points rounded_to(Points points) {
  for (auto& p : points)
    for (Rational& x : p)
      x = exact_rational(static_cast<double>(static_cast<T>(static_cast<double>(x))));
  return points;
}

/// The control points, in a higher degree.
Points elevated(Points points) {
  const Rational n(static_cast<long>(points.size()));
  Points result{points[0]};
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Rational share = Rational(static_cast<long>(k)) / n;
    auto& p = result.emplace_back();
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = share * points[k - 1][c] + (1 - share) * points[k][c];
  }
  result.push_back(points.back());
  return result;
}

std::variant<NearCurve, NotNear> near_points(const Points& points, const Rational& epsilon) {
  return near_curve(bezier_hodograph(points), points.front(), epsilon);
}

/// The distance of corresponding control points, computed anew.
Rational squared_distance(const Points& a, const Points& b) {
  REQUIRE(a.size() == b.size());
  Rational result = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Rational square = 0;
    for (std::size_t c = 0; c < 3; ++c) square += (a[k][c] - b[k][c]) * (a[k][c] - b[k][c]);
    result = std::max(result, square);
  }
  return result;
}

/// Finds the curve, checks all that is claimed of it but the bound of frames, and returns it.
NearCurve check_found(const Points& points, const Rational& epsilon) {
  const auto found = near_points(points, epsilon);
  if (const auto* none = std::get_if<NotNear>(&found)) {
    CAPTURE(static_cast<double>(none->distance.value_or(0)));
    REQUIRE_FALSE(none);
  }
  const auto& near = std::get<NearCurve>(found);
  Points reached = control_points(near.curve);
  while (reached.size() < points.size()) reached = elevated(reached);
  CHECK(reached.front() == points.front());
  CHECK(near.nearness.distance <= epsilon);
  CHECK(squared_distance(reached, points) <= near.nearness.distance * near.nearness.distance);
  const Rational unit = power_of_two(-near.nearness.bits);
  const auto& a = near.curve.preimage();
  for (const Polynomial* part : {&a.u, &a.v, &a.p, &a.q})
    for (const Rational& b : to_bernstein(*part, degree(a)))
      CHECK(denominator(Rational(b / unit)) == 1);
  return near;
}

Rational number(const char* text) { return parse_rational(text); }

}  // namespace

TEST_CASE("near: control points of PH curves, rounded to doubles, give the curve") {
  // PHRAME_TEST_MULTIPLIER=34 makes them 2040.
  const std::vector<long> degrees{1, 2, 3, 4, 5, 6, 7, 9, 12, 15, 18, 20};
  for (long k = 0; k < 60 * multiplier(); ++k) {
    CAPTURE(k);
    const long m = degrees[static_cast<std::size_t>(k) % degrees.size()];
    const Points exact = control_points(Gauss(k).curve(m));
    const Points points = rounded_to<double>(exact);
    const Rational size = greatest(points);
    const Rational epsilon = power_of_two(-48) * size;
    const NearCurve near = check_found(points, epsilon);
    CHECK(preimage_degree(near.curve) == m);
    CHECK(near.nearness.unrounded_distance <= power_of_two(-52) * size);
    // It is the curve that was rounded, up to both distances.
    CHECK(squared_distance(control_points(near.curve), exact) <=
          (epsilon + power_of_two(-50) * size) * (epsilon + power_of_two(-50) * size));
    REQUIRE(near.nearness.rmf_difference);
    CHECK(*near.nearness.rmf_difference < Rational(1, 1000));
  }
}

TEST_CASE("near: so do points of degree ≤ 21 rounded to floats") {
  for (long k = 0; k < 20 * multiplier(); ++k) {
    CAPTURE(k);
    const long m = 1 + k % 10;
    const Points points = rounded_to<float>(control_points(Gauss(1000 + k).curve(m)));
    const Rational size = greatest(points);
    const NearCurve near = check_found(points, power_of_two(-20) * size);
    CHECK(preimage_degree(near.curve) == m);
    CHECK(near.nearness.unrounded_distance <= power_of_two(-23) * size);
  }
}

TEST_CASE("near: a preimage with a complex factor is found without it") {
  Gauss gauss(1);
  const QuaternionPolynomial z{gauss.polynomial(1), gauss.polynomial(1), {}, {}};
  for (const QuaternionPolynomial& factor : {z, z * z}) {
    const Points points = rounded_to<double>(control_points(Curve(gauss.preimage(1) * factor)));
    const NearCurve near = check_found(points, power_of_two(-44));
    CHECK(preimage_degree(near.curve) == 1);
    CHECK(near.curve.multiplier().degree() == 2 * degree(factor));
    CHECK(near.nearness.unrounded_distance < power_of_two(-48) * greatest(points));
  }
}

TEST_CASE("near: a preimage is found that has a complex factor but for a little") {
  for (long k = 9; k < 15 + 60 * (multiplier() - 1); ++k) {
    CAPTURE(k);
    Gauss gauss(2000 + k);
    const long m = 2 + k % 19;
    const QuaternionPolynomial z{gauss.polynomial(1), gauss.polynomial(1), {}, {}};
    const Rational little = power_of_two(-14 - 4 * (k % 5));
    const QuaternionPolynomial rest = gauss.preimage(m);
    const QuaternionPolynomial a = gauss.preimage(m - 1) * z + Polynomial{little} * rest;
    const Points points = rounded_to<double>(control_points(Curve(a)));
    const NearCurve near = check_found(points, power_of_two(-44) * greatest(points));
    CHECK(preimage_degree(near.curve) == m);
  }
}

TEST_CASE("near: corners of the preimage") {
  const auto from = [](const std::vector<RationalQuaternion>& b) {
    Quaternion<std::vector<Rational>> lists;
    for (const auto& a : b) {
      lists.u.push_back(a.u);
      lists.v.push_back(a.v);
      lists.p.push_back(a.p);
      lists.q.push_back(a.q);
    }
    return QuaternionPolynomial{from_bernstein(lists.u), from_bernstein(lists.v),
                                from_bernstein(lists.p), from_bernstein(lists.q)};
  };
  const Rational epsilon = power_of_two(-46);
  const auto points = [](const QuaternionPolynomial& a, const Polynomial& f) {
    return rounded_to<double>(control_points(Curve(a, f)));
  };
  const QuaternionPolynomial spatial =
      from({{1, number(".3"), number("-.4"), number(".2")},
            {number(".7"), number("-1.1"), number(".4"), number(".8")},
            {number("-.3"), number(".1"), number(".4"), number("-.8")}});

  SUBCASE("the tangent starts along −x") {
    check_found(points(from({{0, 0, 0, 1},
                             {number(".1"), number(".2"), number(".3"), 1},
                             {number(".5"), number(".1"), 0, number("1.2")}}),
                       {1}),
                epsilon);
  }
  SUBCASE("a curve in the plane of x and y stays there") {
    const NearCurve near = check_found(
        points(from({{1, 0, 0, number(".2")}, {number(".3"), 0, 0, number(".9")}, {-1, 0, 0, 1}}),
               {1}),
        epsilon);
    CHECK(hodograph(near.curve)[2].is_zero());
  }
  SUBCASE("a straight line is one, exactly") {
    const RationalQuaternion a{1, number(".5"), number(".2"), number(".3")};
    const Polynomial square = from_bernstein({1, number("1.7"), number(".6")});
    const NearCurve near = check_found(points(from({a}), square * square), epsilon);
    CHECK(preimage_degree(near.curve) == 0);
    CHECK(near.curve.multiplier().degree() == 4);
  }
  SUBCASE("numbers of very different size") {
    check_found(points(from({{1000, 0, 0, 0},
                             {1, 1, number(".1"), 0},
                             {number(".001"), 0, number(".002"), 0}}),
                       {1}),
                number("1e-9"));
  }
  SUBCASE("a multiplier with one sign, of even and of odd degree, and a negative one") {
    for (const Polynomial& f : {from_bernstein({1, number("2.2")}), Polynomial{-3},
                                from_bernstein({1, number("-.2"), number(".7")})}) {
      const NearCurve near = check_found(points(spatial, f), epsilon);
      CHECK(degree(near.curve) == 5 + f.degree());
      CHECK(near.nearness.rmf_difference);
      CHECK(sign_after_zero(near.curve.multiplier()) > 0);
    }
  }
  SUBCASE("a multiplier that changes its sign, once and twice: the frame has no bound") {
    for (const Polynomial& f : {from_bernstein({1, number(".2"), number("-.5")}),
                                from_bernstein({1, number("-.6"), number("-.6"), 1})}) {
      const NearCurve near = check_found(points(spatial, f), epsilon);
      CHECK(preimage_degree(near.curve) == 2);
      CHECK_FALSE(near.nearness.rmf_difference);
    }
  }
  SUBCASE("a cusp at the start: the frame has no bound") {
    const NearCurve near =
        check_found(points(spatial * QuaternionPolynomial{{0, 1}, {}, {}, {}}, {1}), epsilon);
    CHECK_FALSE(near.nearness.rmf_difference);
  }
  SUBCASE("a higher degree than needed") {
    Points higher = control_points(Curve(spatial));
    for (int k = 1; k <= 4; ++k) {
      higher = elevated(higher);
      const NearCurve near = check_found(rounded_to<double>(higher), epsilon);
      CHECK(preimage_degree(near.curve) == 2);
    }
  }
  SUBCASE("very large and very small units") {
    for (const long e : {-1200L, 900L}) {
      Points scaled = rounded_to<double>(control_points(Curve(spatial)));
      for (auto& p : scaled)
        for (Rational& x : p) x *= power_of_two(e);
      const NearCurve near = check_found(scaled, power_of_two(e) * epsilon);
      CHECK(near.nearness.unrounded_distance < power_of_two(e - 50));
    }
  }
}

TEST_CASE("near: what is known to 40 decimals is met to 39") {
  Points points = control_points(Gauss(5).curve(2));
  for (auto& p : points)
    for (Rational& x : p) x = parse_rational(round_to_decimal(x, 40).value);
  const NearCurve near = check_found(points, number("1e-38"));
  CHECK(near.nearness.unrounded_distance < number("1e-39"));
  CHECK(near.nearness.rmf_difference);
  CHECK(*near.nearness.rmf_difference < number("1e-36"));
}

TEST_CASE("near: a greater ε takes fewer bits") {
  const Points points = rounded_to<double>(control_points(quintic));
  long bits = 1000;
  for (const char* epsilon : {"1e-15", "1e-12", "1e-9", "1e-6"}) {
    const NearCurve near = check_found(points, number(epsilon));
    CHECK(near.nearness.bits < bits);
    bits = near.nearness.bits;
  }
  CHECK(bits <= 22);
}

TEST_CASE("near: what is found of a curve is found of its points again") {
  for (long k = 0; k < 10; ++k) {
    const Points points = rounded_to<double>(control_points(Gauss(2000 + k).curve(1 + k % 4)));
    const Rational epsilon = power_of_two(-40);
    const Points first = control_points(check_found(points, epsilon).curve);
    const NearCurve again = check_found(first, epsilon);
    CHECK(again.nearness.unrounded_distance < power_of_two(-60));
  }
}

TEST_CASE("near: what is no PH curve is refused with a distance") {
  // A cubic is PH where its legs L₀, L₁, L₂ have L₁² = L₀L₂ and equal angles (Farouki, Sakkalis
  // 1990); (1, 0, 0), (1, 1, 0), (1, 0, 0) do not.
  const Points cubic{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}};
  const auto found = near_points(cubic, number("1e-3"));
  REQUIRE(std::holds_alternative<NotNear>(found));
  const Rational distance = std::get<NotNear>(found).distance.value();
  CHECK(distance > number("0.01"));
  CHECK(distance < 1);
  // It is refused below that distance, and not above it.
  CHECK(std::holds_alternative<NotNear>(near_points(cubic, number("0.99") * distance)));
  check_found(cubic, number("1.01") * distance);
}

TEST_CASE("near: what is suggested is found, and nothing is where all is far") {
  for (long k = 0; k < 12; ++k) {
    CAPTURE(k);
    const Points exact = control_points(Gauss(3000 + k).curve(1 + k % 5));
    const Points points = k % 2 == 0 ? rounded_to<double>(exact) : rounded_to<float>(exact);
    const auto suggestion = near_suggestion(bezier_hodograph(points), points.front());
    REQUIRE(suggestion);
    CHECK(suggestion->distance < suggestion->epsilon);
    CHECK(suggestion->epsilon < (k % 2 == 0 ? number("1e-13") : number("1e-4")));
    check_found(points, suggestion->epsilon);
  }
  // (1, 1, 0) is the direction of no rational A, but of some as near as one likes.
  const auto irrational = near_suggestion({Polynomial{1}, Polynomial{1}, {}}, {});
  REQUIRE(irrational);
  CHECK(irrational->epsilon == number("1e-30"));
  check_found({{0, 0, 0}, {1, 1, 0}}, irrational->epsilon);
  CHECK_FALSE(near_suggestion(bezier_hodograph({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}}), {}));
}

TEST_CASE("near: what is a 4000th of its size away is not held for far") {
  for (long k = 0; k < 12; ++k) {
    CAPTURE(k);
    Gauss gauss(3300 + k);
    Points points = control_points(gauss.curve(1 + k % 3));
    Rational size = 0;
    for (const auto& p : points) size = std::max(size, greatest({p - points.front()}));
    // Each way by turns, as the speed bends most.
    const Vector<Rational> aside = Rational(size / 2000 / 3) * points.back();
    for (std::size_t j = 1; j < points.size(); ++j)
      points[j] = points[j] + Rational(j % 2 == 0 ? 1 : -1) / greatest({points.back()}) * aside;
    CHECK(near_suggestion(bezier_hodograph(points), points.front()));
  }
}

// The same curve in other units: 0.95·10⁻¹² from a PH curve, then 0.85·10⁻¹².
TEST_CASE("near: an ε that is suggested leaves room to round") {
  const Points points = rounded_to<double>(control_points(Gauss(3100).curve(2)));
  const auto first = near_suggestion(bezier_hodograph(points), points.front());
  REQUIRE(first);
  for (const auto& [share, epsilon] : {std::pair("0.95e-12", "1e-11"), {"0.85e-12", "1e-12"}}) {
    Points other = points;
    for (auto& p : other) p = Rational(number(share) / first->distance) * p;
    const auto suggestion = near_suggestion(bezier_hodograph(other), other.front());
    REQUIRE(suggestion);
    CHECK(abs(suggestion->distance / number(share) - 1) < number("0.02"));
    CHECK(suggestion->epsilon == number(epsilon));
    check_found(other, suggestion->epsilon);
  }
}

TEST_CASE("near: what cannot be is an error") {
  CHECK_THROWS_AS(near_curve({}, {}, 1), DomainError);
  CHECK_THROWS_AS(near_curve(hodograph(quintic), {}, 0), DomainError);
  CHECK_THROWS_AS(near_curve(hodograph(quintic), {}, -1), DomainError);
  const Vector<Polynomial> high{Polynomial::monomial(1, max_near_degree), {1}, {}};
  CHECK_THROWS_AS(near_curve(high, {}, 1), DomainError);
}

}  // namespace near_test
