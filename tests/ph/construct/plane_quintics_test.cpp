#include "phrame/ph/construct/plane_quintics.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "support/energy.hpp"
#include "support/random.hpp"

namespace plane_quintics_test {

using namespace phrame;

namespace {

const Deviation tolerance{Rational(1, 1'000'000'000'000), Rational(1, 1'000'000'000'000)};

double rotation_index(const Construction& found) {
  const auto index = absolute_rotation_index(Path(found.path));
  REQUIRE(index.has_value());
  return round_to_double(*index);
}

}  // namespace

// An arch: Δp = 1, r′ = 1 ± i as complex numbers. A program in Python has these rotation indices.
TEST_CASE("plane quintics: the four of an arch, by how much they turn") {
  const HermiteSpline arch{{{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {1, -1, 0}}, {0, 1}};
  const std::array<double, 4> indices{0.25, 1.0712, 1.0712, 1.75};
  std::vector<FreeAngles> angles;
  for (long solution = 1; solution <= plane_solutions; ++solution) {
    const Construction found = plane_quintics(arch, solution, tolerance);
    CHECK(rotation_index(found) ==
          doctest::Approx(indices[static_cast<std::size_t>(solution - 1)]).epsilon(1e-4));
    CHECK(hodograph(found.path.segments().front())[2] == Polynomial());
    angles.push_back(found.angles.front());
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) CHECK(angles[k] != angles.back());
  }
  // It turns by the angle between its tangents, and no more.
  CHECK(angles.front() == FreeAngles{});
}

TEST_CASE("plane quintics: a closed spline of them is closed, and in the plane") {
  const HermiteSpline circle{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}},
                             {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}},
                             {0, 2, 4, 6, 8},
                             true};
  const Construction found = plane_quintics(circle, 1, tolerance);
  CHECK(found.path.closing_turn().has_value());
  for (const Curve& curve : found.path.segments()) CHECK(hodograph(curve)[2] == Polynomial());
  CHECK(rotation_index(found) == doctest::Approx(1).epsilon(1e-9));
}

// With A₂ = −A₀ the sum that φ is measured from is 0. From mpmath by complex numbers, r′ = w²,
// w = w₀((1 − t)² − t²) ± 2t(1 − t)√c/4, w₀² = d, c = 120Δp − 40d.
TEST_CASE("plane quintics: equal derivatives at both ends have four, two of them mirrored") {
  const Vector<Rational> d{Rational(1, 2), -1, 0};
  const HermiteSpline data{{{2, Rational(667, 1000), 0}, {3, 1, 0}}, {d, d}, {0, 1}};
  std::vector<Curve> curves;
  for (const long solution : {2, 3}) {
    const Construction found = plane_quintics(data, solution, tolerance);
    curves.push_back(found.path.segments().front());
    CHECK(hodograph(curves.back())[2] == Polynomial());
    CHECK(round_to_double(arc_length(curves.back())(1)) == doctest::Approx(1.43965716922175));
    CHECK(test::energy_of(curves.back()) == doctest::Approx(117.875653899642));
    CHECK(rotation_index(found) == doctest::Approx(1));
  }
  CHECK(curves.front() != curves.back());
}

TEST_CASE("plane quintics: data outside the plane are refused by their place") {
  const HermiteSpline data{{{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {1, -1, Rational(1, 3)}}, {0, 1}};
  CHECK_THROWS_WITH_AS(
      plane_quintics(data, 1, tolerance),
      "the derivative at point 2 has z = 1/3, but a plane curve is wanted, in z = 0", DomainError);
}

}  // namespace plane_quintics_test
