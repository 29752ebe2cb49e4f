#include "phrame/ph/curve/spline_slopes.hpp"

#include "phrame/ph/construct/bezier_points.hpp"
#include "support/random.hpp"

namespace spline_slopes_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

struct Chords {
  std::vector<Rational> h;
  std::vector<Vector<Rational>> slopes;
};

Chords random_chords(Random& random, long steps, bool is_closed) {
  Chords result;
  Vector<Rational> sum{0, 0, 0};
  for (long k = 0; k < steps; ++k) {
    result.h.emplace_back(random.integer(1, 30), random.integer(1, 9));
    Vector<Rational> chord{random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)};
    if (is_closed && k + 1 == steps) chord = Rational(-1) * sum;
    sum = sum + chord;
    result.slopes.push_back(Rational(1) / result.h.back() * chord);
  }
  return result;
}

/// Of the cubic with these slopes of its chord and at its ends, at its start and end.
Vector<Rational> second_at_start(const Rational& h, const Vector<Rational>& chord,
                                 const Vector<Rational>& a, const Vector<Rational>& b) {
  return Rational(2) / h * (Rational(3) * chord - Rational(2) * a - b);
}
Vector<Rational> second_at_end(const Rational& h, const Vector<Rational>& chord,
                               const Vector<Rational>& a, const Vector<Rational>& b) {
  return Rational(2) / h * (a + Rational(2) * b - Rational(3) * chord);
}

}  // namespace

TEST_CASE("spline slopes: law: second derivatives agree at the joints, and the ends are as asked") {
  for_samples(40, [](Random& random) {
    const long n = random.integer(1, 7);
    for (const SplineEnds ends : {SplineEnds::natural, SplineEnds::clamped, SplineEnds::periodic}) {
      const bool is_closed = ends == SplineEnds::periodic;
      if (is_closed && n == 1) continue;
      const Chords chords = random_chords(random, n, is_closed);
      const auto& h = chords.h;
      const auto& slopes = chords.slopes;
      const Vector<Rational> first{1, 2, random.integer(-5, 5)};
      const Vector<Rational> last{random.integer(-5, 5), 0, 3};
      const auto x = cubic_spline_slopes(h, slopes, ends, {first, last});
      const auto count = static_cast<std::size_t>(n);
      REQUIRE(x.size() == count + 1);
      const auto start_of = [&](std::size_t k) {
        return second_at_start(h[k], slopes[k], x[k], x[k + 1]);
      };
      const auto end_of = [&](std::size_t k) {
        return second_at_end(h[k], slopes[k], x[k], x[k + 1]);
      };
      for (std::size_t k = 0; k + 1 < count; ++k) CHECK(end_of(k) == start_of(k + 1));
      if (ends == SplineEnds::natural) {
        CHECK(start_of(0) == Vector<Rational>{0, 0, 0});
        CHECK(end_of(count - 1) == Vector<Rational>{0, 0, 0});
      } else if (ends == SplineEnds::clamped) {
        CHECK(x.front() == first);
        CHECK(x.back() == last);
      } else {
        CHECK(x.front() == x.back());
        CHECK(end_of(count - 1) == start_of(0));
      }
    }
  });
}

TEST_CASE("Bézier points: those of a hodograph, in this degree and in higher ones") {
  // A = 1 + tk: r′ = (1 − t², 2t, 0), r = (t − t³/3, t², 0) from (1, 1, 1).
  const Curve curve({{1}, {}, {}, {0, 1}});
  const Vector<Rational> start{1, 1, 1};
  const BezierPoints points = bezier_points(hodograph(curve), start);
  const Rational third(1, 3);
  CHECK(points ==
        BezierPoints{
            {1, 1, 1}, {1 + third, 1, 1}, {1 + 2 * third, 1 + third, 1}, {1 + 2 * third, 2, 1}});
  // 3ΔP are the Bernstein coefficients of r′: 1 − t² is (1, 1, 0), 2t is (0, 1, 2).
  CHECK(bezier_derivatives(points) ==
        std::vector<Vector<Rational>>{{1, 0, 0}, {1, 1, 0}, {0, 2, 0}});
  // In degree 5 the points are on the same curve: B₀, …, B₅ of t and t² are k/5 and k(k − 1)/20.
  const BezierPoints raised = control_points_in_degree(curve, 5);
  REQUIRE(raised.size() == 6);
  for (long k = 0; k <= 5; ++k) {
    const Rational cube(k * (k - 1) * (k - 2), 60);
    CHECK(raised[static_cast<std::size_t>(k)] - raised[0] ==
          Vector<Rational>{Rational(k, 5) - cube / 3, Rational(k * (k - 1), 20), 0});
  }
}

}  // namespace spline_slopes_test
