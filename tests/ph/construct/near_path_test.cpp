#include <doctest/doctest.h>

#include <random>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_fit.hpp"
#include "phrame/ph/construct/near.hpp"

using namespace phrame;

namespace {

/// Random splines as other programs have them: Bézier points in doubles, with a phase of A that is
/// another in each segment.
class RandomSpline {
 public:
  explicit RandomSpline(unsigned long seed) : engine_(seed) {}

  /// A segment with a preimage of degree m, whose derivative at the start is `ratio`² times that at
  /// the end of the one before.
  void add(std::size_t m, double ratio = 1) {
    std::vector<RationalQuaternion> a;
    for (std::size_t k = 0; k <= m; ++k) a.push_back({number(), number(), number(), number()});
    if (!curves.empty()) {
      const Rational r = exact_rational(ratio);
      a[0] = {r * end_.u, r * end_.v, r * end_.p, r * end_.q};
    }
    end_ = a.back();
    const Rational t = number();  // 1 + t² is the norm of 1 + ti
    const RationalQuaternion turn{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), 0, 0};
    for (auto& x : a) x = x * turn;
    const ExactFit fit{a, {1}};
    const Vector<Rational> start =
        curves.empty() ? Vector<Rational>{1, 2, 3} : curves.back().back();
    auto& points = curves.emplace_back(control_points(curve_of(fit, start)));
    for (std::size_t k = 1; k < points.size(); ++k)
      for (Rational& x : points[k]) x = exact_rational(static_cast<double>(x));
  }

  std::vector<BezierPoints> curves;

 private:
  Rational number() { return exact_rational(gauss_(engine_)); }

  std::mt19937_64 engine_;
  std::normal_distribution<double> gauss_;
  RationalQuaternion end_{};
};

NearPath check_found(const std::vector<BezierPoints>& curves, const Rational& epsilon) {
  auto found = near_path(curves, epsilon);
  if (const auto* none = std::get_if<NotNear>(&found)) {
    CAPTURE(static_cast<double>(none->distance.value_or(0)));
    REQUIRE_FALSE(none);
  }
  auto& near = std::get<NearPath>(found);
  const auto& segments = near.path.segments();
  REQUIRE(segments.size() == curves.size());
  CHECK(near.nearness.distance <= epsilon);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const BezierPoints reached = control_points_in_degree(segments[k], curves[k].size() - 1);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      Rational square = 0;
      for (std::size_t c = 0; c < 3; ++c)
        square += (reached[i][c] - curves[k][i][c]) * (reached[i][c] - curves[k][i][c]);
      CHECK(square <= near.nearness.distance * near.nearness.distance);
    }
  }
  return std::move(near);
}

/// r′ at the end of segment k, and at the start of the next.
std::pair<Vector<Rational>, Vector<Rational>> derivatives_at_joint(const PhPath& path,
                                                                   std::size_t k) {
  return {evaluate(hodograph(path.segments()[k]), 1),
          evaluate(hodograph(path.segments()[k + 1]), 0)};
}

const Rational epsilon = power_of_two(-44);

}  // namespace

TEST_CASE("near_path: C1 splines in doubles become C1 splines, exactly") {
  for (const std::size_t m : {2UL, 3UL, 5UL}) {
    RandomSpline spline(m);
    for (int k = 0; k < 8; ++k) spline.add(m);
    const NearPath near = check_found(spline.curves, epsilon);
    for (std::size_t k = 0; k < 7; ++k) {
      const auto [before, after] = derivatives_at_joint(near.path, k);
      CHECK(before == after);
    }
    CHECK(near.nearness.rmf_difference);
  }
}

TEST_CASE("near_path: G1 splines of several degrees stay G1, their speeds jump as they did") {
  RandomSpline spline(7);
  spline.add(1);
  for (const std::size_t m : {2UL, 1UL, 4UL, 0UL, 3UL, 0UL, 0UL, 2UL}) spline.add(m, 1.5);
  // That PhPath takes it says that positions and tangents agree.
  const NearPath near = check_found(spline.curves, epsilon);
  for (std::size_t k = 0; k < 8; ++k) {
    const auto [before, after] = derivatives_at_joint(near.path, k);
    for (std::size_t c = 0; c < 3; ++c)
      if (before[c] != 0)
        CHECK(static_cast<double>(Rational(after[c] / before[c])) == doctest::Approx(2.25));
  }
}

TEST_CASE("near_path: distances do not add up: 150 segments are about as near as 5") {
  RandomSpline spline(3);
  const auto with_segments = [&](std::size_t count) {
    while (spline.curves.size() < count) spline.add(2);
    std::vector<BezierPoints> curves = spline.curves;
    for (auto& points : curves)
      for (auto& p : points)
        for (Rational& x : p)
          x = Rational(floor(x * power_of_two(20))) * power_of_two(-20);  // all to the same side
    return check_found(curves, power_of_two(-10)).nearness.unrounded_distance;
  };
  const double few = static_cast<double>(with_segments(5));
  const double many = static_cast<double>(with_segments(150));
  CHECK(many <= 2 * few);
}

TEST_CASE("near_path: of splines in floats, bits are as few as ε allows") {
  RandomSpline spline(4);
  for (int k = 0; k < 4; ++k) spline.add(2);
  for (auto& points : spline.curves)
    for (auto& p : points)
      for (Rational& x : p)
        x = exact_rational(static_cast<double>(static_cast<float>(static_cast<double>(x))));
  const NearPath near = check_found(spline.curves, Rational(1, 100'000));
  CHECK(near.nearness.bits < 26);
}

TEST_CASE("near_path: what is no spline near a PH one is refused") {
  RandomSpline spline(5);
  spline.add(2);
  spline.add(2);
  SUBCASE("a tangent that breaks") {
    auto other = RandomSpline(6);
    other.add(2);
    BezierPoints last = other.curves[0];
    for (auto& p : last)
      for (std::size_t c = 0; c < 3; ++c)
        p[c] += spline.curves.back().back()[c] - other.curves[0][0][c];
    spline.curves.push_back(last);
    CHECK_THROWS_AS(near_path(spline.curves, epsilon), DomainError);
  }
  SUBCASE("a curve that is not PH") {
    spline.curves[1][2][1] += Rational(1, 10);
    const auto found = near_path(spline.curves, epsilon);
    REQUIRE(std::holds_alternative<NotNear>(found));
    CHECK(std::get<NotNear>(found).distance.value() > Rational(1, 1000));
  }
  SUBCASE("a gap") {
    for (auto& p : spline.curves[1]) p[0] += Rational(1, 10);
    CHECK(std::holds_alternative<NotNear>(near_path(spline.curves, epsilon)));
  }
  SUBCASE("a distance that is none") { CHECK_THROWS_AS(near_path(spline.curves, 0), DomainError); }
}
