#include "phrame/ph/construct/spline_builder.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "support/hermite.hpp"

using namespace phrame;

namespace {

/// Its end is about that of the curve below.
HermiteSpline spatial_data() {
  return test::one_segment({Rational(1, 3), Rational(1, 5), Rational(-7, 5)}, {1, 0, 0},
                           {0, 0, -2});
}

}  // namespace

TEST_CASE("spline builder: deviations are not less than the greatest, and hardly more") {
  const Rational tolerance(1, 1024);
  for (const bool is_rounded : {false, true}) {
    DeviationMeter meter;
    if (is_rounded) meter = DeviationMeter(Deviation{tolerance, tolerance, tolerance});
    meter.point({3, 4, 0});
    meter.point({0, 1, 1});
    meter.derivative({0, 0, Rational(-1, 7)});
    const Deviation found = meter.deviation();
    const Rational more = tolerance * power_of_two(-18) + power_of_two(-27);
    CHECK(found.points >= 5);
    CHECK(found.points < 5 + more);
    CHECK(found.derivatives >= Rational(1, 7));
    CHECK(found.derivatives < Rational(1, 7) + more);
    CHECK(found.accelerations == 0);
  }
  DeviationMeter angles;
  angles.direction({1, 0, 0}, {5, 0, 0});
  CHECK(angles.deviation().derivatives == 0);
  angles.direction({4, 0, 0}, {4, 3, 0});  // atan(3/4) = 0.6435…
  CHECK(angles.deviation().derivatives > Rational(6435, 10'000));
  CHECK(angles.deviation().derivatives < Rational(13, 10));
}

TEST_CASE("spline builder: a curve meets its point as the rule asks, or is not added") {
  const BernsteinPreimage a{{1, 0, 0, 0}, {1, 0, Rational(1, 2), 0}, {0, 0, 1, 1}};
  HermiteSpline data = spatial_data();
  const Vector<Rational> end = end_point(Curve(from_bernstein(a)));
  data.points[1] = {end[0] + power_of_two(-40), end[1], end[2] - power_of_two(-41)};
  SplineBuilder near(data, PointRule::near);
  REQUIRE(near.add(a, {1}, MultiplierFreedom::all));
  CHECK(near.end() == end);
  CHECK(near.meter().deviation().points > power_of_two(-40));
  SplineBuilder exact(data, PointRule::exact);
  REQUIRE(exact.add(a, {1}, MultiplierFreedom::all));
  CHECK(exact.end() == data.points[1]);
  const Construction found = exact.finished(whole_parameters(data), 7);
  CHECK(end_point(found.path.segments().front()) == data.points[1]);
  CHECK(found.deviation.points == 0);
  CHECK(found.parameters == std::vector<Rational>{0, 1});
  // A line goes along itself only.
  SplineBuilder unmet(data, PointRule::exact);
  CHECK_FALSE(unmet.add({{1, 0, 0, 0}}, {1}, MultiplierFreedom::all));
  CHECK(unmet.is_unmet());
  CHECK(unmet.next() == 0);
}

TEST_CASE("spline builder: attempts have 8 bits more each time until one is within the tolerance") {
  std::vector<long> tried;
  const auto attempt = [&](long bits) -> std::optional<Construction> {
    tried.push_back(bits);
    if (bits == 28) return std::nullopt;
    return Construction{Curve({{1}, {}, {}, {}}), {0, 1}, {}, bits, {power_of_two(-bits), 0}};
  };
  const auto found = first_within({power_of_two(-40), 0}, 20, 9, attempt);
  REQUIRE(found);
  CHECK(found->bits == 44);
  CHECK(tried == std::vector<long>{20, 28, 36, 44});
  CHECK_FALSE(first_within({power_of_two(-40), 0}, 20, 3, attempt));
  CHECK_THROWS_WITH_AS(first_built(
                           spatial_data(), PointRule::near, {1, 1}, 20, 2,
                           [](SplineBuilder&, long) { return std::nullopt; }, "none"),
                       "none", Undecided);
}
