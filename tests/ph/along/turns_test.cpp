#include "phrame/ph/along/turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"

using namespace phrame;
using test::expression_curve;

namespace turns_test {
namespace {

std::vector<double> places(const Turns& turns, Plotted quantity) {
  std::vector<double> at;
  for (const Turn& turn : turns.list)
    if (turn.quantity == quantity) at.push_back(approximate(RealBall(turn.at, 64)));
  std::sort(at.begin(), at.end());
  return at;
}

double greatest(const Turns& turns, Plotted quantity) {
  double most = 0;
  for (const Turn& turn : turns.list)
    if (turn.quantity == quantity) most = std::max(most, turn.about);
  return most;
}

/// Where the values of f on a fine grid turn round.
template <class Function>
std::vector<double> turns_of_values(Function f, int count) {
  std::vector<double> at;
  for (int k = 1; k < count; ++k) {
    const double t = static_cast<double>(k) / count;
    const double step = 1.0 / count;
    const double before = f(t) - f(t - step);
    const double after = f(t + step) - f(t);
    if (before * after < 0) at.push_back(t);
  }
  return at;
}

void check_near(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) CHECK(std::abs(found[k] - expected[k]) < 1e-3);
}

/// κ of polynomials x, y, z by differences of the position.
double curvature(const std::array<std::function<double(double)>, 3>& r, double t) {
  constexpr double h = 1e-4;
  std::array<double, 3> a{};
  std::array<double, 3> b{};
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = (r[k](t + h) - r[k](t - h)) / (2 * h);
    b[k] = (r[k](t + h) - 2 * r[k](t) + r[k](t - h)) / (h * h);
  }
  const double x = a[1] * b[2] - a[2] * b[1];
  const double y = a[2] * b[0] - a[0] * b[2];
  const double z = a[0] * b[1] - a[1] * b[0];
  return std::hypot(x, y, z) / std::pow(std::hypot(a[0], a[1], a[2]), 3);
}

}  // namespace

// The quintic of [Farouki 2003]: σ = 37t⁴ − 72t³ + 46t² − 12t + 6, θ′ = −8t(t − 1)/σ.
TEST_CASE("turns: those of the quintic of 2003 are where its values on a grid turn") {
  const Turns found = turns(test::quintic);
  CHECK(found.are_all);
  CHECK(found.slack == 0);
  CHECK(found.infinite.empty());
  const auto sigma = [](double t) { return (((37 * t - 72) * t + 46) * t - 12) * t + 6; };
  check_near(places(found, Plotted::theta), {0, 1});
  check_near(places(found, Plotted::speed), turns_of_values(sigma, 2000));
  const auto rate = [&](double t) { return 8 * t * (1 - t) / sigma(t); };
  check_near(places(found, Plotted::theta_rate), turns_of_values(rate, 2000));
  std::array<std::function<double(double)>, 3> r;
  const Vector<Polynomial> p = position(test::quintic);
  for (std::size_t k = 0; k < 3; ++k)
    r[k] = [c = p[k]](double t) {
      double value = 0;
      for (long n = c.degree(); n >= 0; --n) value = value * t + round_to_double(c.coefficient(n));
      return value;
    };
  check_near(places(found, Plotted::curvature),
             turns_of_values([&](double t) { return curvature(r, t); }, 500));
}

TEST_CASE("turns: a zero of the multiplier is a pole of the curvature, and one of the speed") {
  const Turns found = turns(Curve(test::quintic.preimage(), Polynomial{Rational(-1, 3), 1}));
  CHECK(found.infinite == std::vector{Plotted::curvature, Plotted::torsion});
  const std::vector<double> slow = places(found, Plotted::speed);
  CHECK(std::any_of(slow.begin(), slow.end(),
                    [](double t) { return std::abs(t - 1.0 / 3) < 1e-15; }));
}

TEST_CASE("turns: a peak of width 10⁻⁹ next to a cusp is found") {
  const Rational epsilon(1, 1'000'000'000);
  const Curve curve(QuaternionPolynomial{{Rational(-1, 3), 1}, {}, {epsilon}, {0, epsilon}});
  const Turns found = turns(curve);
  // α = u + iv = t − 1/3, β = q + ip = ε(t + i), so that |αβ′ − α′β| = ε√(10/9), and σ = ε²·10/9 at
  // t = 1/3: κ = 2|αβ′ − α′β|/σ² = 2ε√(10/9)/(ε⁴(10/9)²).
  const double expected = 2 / (1e-27 * std::pow(10.0 / 9, 1.5));
  CHECK(std::sqrt(greatest(found, Plotted::curvature)) == doctest::Approx(expected).epsilon(1e-6));
}

// κ = ab/(a²sin² + b²cos²)^{3/2} on an ellipse: a/b² = 2 at its ends, b/a² = 1/4 between.
TEST_CASE("turns: an ellipse by formulas is followed to its greatest and its least curvature") {
  const Turns found = turns(Segment(expression_curve({"2*cos(s)", "sin(s)", "0"}, "1/10", "3")));
  CHECK(found.are_all);
  double least = 9;
  for (const Turn& turn : found.list) least = std::min(least, turn.about);
  CHECK(std::sqrt(least) == doctest::Approx(0.25).epsilon(1e-2));
  const Turns round = turns(Segment(expression_curve({"2*cos(s)", "sin(s)", "0"}, "1", "4")));
  CHECK(round.are_all);
  CHECK(std::sqrt(greatest(round, Plotted::curvature)) ==
        doctest::Approx(2).epsilon(2 * round.slack));
}

}  // namespace turns_test
