#include "phrame/ph/offset/plane_gap.hpp"

#include <cmath>

#include "support/random.hpp"

namespace plane_gap_test {

using namespace phrame;

namespace {

/// Cubics that go on where the one before ends, perhaps far from 0, as in maps.
PlaneParts random_parts(test::Random& random, const Rational& far, long unit) {
  PlaneParts made{{}, {}, 0};
  std::array<Rational, 2> last{far, -far};
  for (long k = random.integer(1, 4); k > 0; --k) {
    CubicPart part{{}, 0, 1};
    part.cubic[0] = last;
    for (std::size_t j = 1; j < 4; ++j)
      part.cubic[j] = {far + Rational(random.integer(-9, 9), unit),
                       Rational(random.integer(-9, 9), unit) - far};
    last = part.cubic[3];
    made.curves.push_back(made.parts.size());
    made.parts.push_back(part);
  }
  return made;
}

std::array<double, 2> at(const PlaneCubic& c, double t, const Rational& far) {
  std::array<double, 2> p{};
  const std::array<double, 4> b{(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t),
                                3 * t * t * (1 - t), t * t * t};
  for (std::size_t k = 0; k < 4; ++k) {
    p[0] += b[k] * static_cast<double>(c[k][0] - far);
    p[1] += b[k] * static_cast<double>(c[k][1] + far);
  }
  return p;
}

/// By many points of both.
double sampled_gap(const PlaneParts& a, const PlaneParts& b, const Rational& far) {
  constexpr int count = 200;
  std::vector<std::array<double, 2>> points;
  for (const CubicPart& part : b.parts)
    for (int k = 0; k <= count; ++k) points.push_back(at(part.cubic, double(k) / count, far));
  double most = 0;
  for (const CubicPart& part : a.parts)
    for (int k = 0; k <= count / 4; ++k) {
      const auto p = at(part.cubic, 4.0 * k / count, far);
      double least = 1e300;
      for (const auto& q : points) least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1]));
      most = std::max(most, least);
    }
  return most;
}

}  // namespace

TEST_CASE("plane_gap: it is what many points of both show, to three percent") {
  test::Random random(20261);
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    const Rational far(round % 3 == 0 ? 4'500'000 : 0);
    const PlaneParts a = random_parts(random, far, 1);
    const PlaneParts b = random_parts(random, far, 2);
    const double sampled = sampled_gap(a, b, far);
    const PlaneGap gap = greatest_gap(a, b, Rational(1, 100));
    // Points of b are up to 0.3 from one another.
    CHECK(static_cast<double>(gap.lower) <= sampled * 1.02 + 0.02);
    CHECK(static_cast<double>(gap.upper) >= sampled - 0.05);
    CHECK(static_cast<double>(gap.upper) <= static_cast<double>(gap.lower) * 1.04 + 1e-6);
    const PlaneGap none = greatest_gap(a, a, Rational(1, 100'000));
    CHECK(none.lower == 0);
    CHECK(none.stretches.empty());
  }
}

TEST_CASE("plane_gap: of parallel lines, by any little, with the part that is too far") {
  const auto line = [](const Rational& from, const Rational& to, const Rational& y) {
    return CubicPart{
        {{{from, y}, {(2 * from + to) / 3, y}, {(from + 2 * to) / 3, y}, {to, y}}}, from, to};
  };
  const Rational e(1, 1'000'000'000);
  const PlaneParts whole{{line(0, 1, 0)}, {0}, 0};
  const PlaneParts two{{line(0, Rational(1, 2), e), line(Rational(3, 4), 1, e)}, {0, 0}, 0};
  const PlaneGap to = greatest_gap(two, whole, 2 * e);
  CHECK(to.lower <= e);
  CHECK(to.upper >= e);
  CHECK(to.upper - to.lower < e / 20);
  CHECK(to.stretches.empty());
  // 5/8 is farthest from both, by √(1/64 + e²).
  const PlaneGap from = greatest_gap(whole, two, 2 * e);
  CHECK(from.lower <= Rational(1, 8) + e);
  CHECK(from.upper >= Rational(1, 8));
  CHECK(from.upper < Rational(131, 1000));
  REQUIRE(from.stretches.size() == 1);
  const GapStretch& x = from.stretches.front();
  CHECK(x.is_proved);
  CHECK(parameter(whole, x.from) <= Rational(1, 2) + 2 * e);
  CHECK(parameter(whole, x.from) > Rational(48, 100));
  CHECK(parameter(whole, x.to) >= Rational(3, 4) - 2 * e);
  CHECK(parameter(whole, x.to) < Rational(77, 100));
  CHECK(abs(parameter(whole, x.farthest) - Rational(5, 8)) < Rational(1, 100));
}

}  // namespace plane_gap_test
