#include "phrame/ph/construct/solution_curve.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace phrame;

namespace {

using Plane = std::array<double, 2>;

/// Of the circle x² + y² = 4, whose points have x = 2 cos φ, y = 2 sin φ.
std::array<double, 1> off_circle(const Plane& z) { return {z[0] * z[0] + z[1] * z[1] - 4}; }

std::vector<double> step(const Plane& z, const std::array<double, 1>& off) {
  const double size = z[0] * z[0] + z[1] * z[1];
  return {off[0] * z[0] / (2 * size), off[0] * z[1] / (2 * size)};
}

}  // namespace

TEST_CASE("solution curve: Newton's damped steps go to the nearest solution") {
  for (const Plane& start : {Plane{0.1, 0}, {30, 40}, {-1, 1e-3}}) {
    Plane z = start;
    CHECK(damped_newton(z, off_circle, step, 40, 1e-14, 1e-3) < 1e-14);
    CHECK(std::atan2(z[1], z[0]) == doctest::Approx(std::atan2(start[1], start[0])));
  }
  Plane stuck{3, 0};  // a step away from it helps in no part
  const auto away = [](const Plane&, const std::array<double, 1>&) {
    return std::vector<double>{-1, 0};
  };
  CHECK(damped_newton(stuck, off_circle, away, 40, 1e-14, 1e-3) == 5);
  CHECK(stuck == Plane{3, 0});
}

TEST_CASE("solution curve: the slide ends where the energy is least") {
  Plane z{2, 0};
  const auto energy = [](const Plane& at) { return (at[0] + 3) * (at[0] + 3) + at[1] * at[1]; };
  const double least = slide_downhill(
      z, 0.5, 1e-9,
      [](const Plane& at) {
        return std::vector<double>{-at[1] / 2, at[0] / 2};
      },
      [](Plane& at) { return damped_newton(at, off_circle, step, 12, 1e-14, 1e-3) < 1e-12; },
      energy);
  CHECK(least == doctest::Approx(1));  // at (−2, 0), 1 from (−3, 0)
  CHECK(z[0] == doctest::Approx(-2));
}
