#include "phrame/ph/construct/cubic_interpolation.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/data.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

CubicInterpolation random_interpolation(Random& random, long count, SplineEnds ends) {
  CubicInterpolation data;
  data.ends = ends;
  Rational t = random.rational();
  for (long k = 0; k < count; ++k) {
    data.points.push_back({random.rational(), random.rational(), random.rational()});
    data.parameters.push_back(t);
    t += abs(random.rational()) + Rational(1, 5);
  }
  if (ends == SplineEnds::periodic) data.points.back() = data.points.front();
  if (ends == SplineEnds::clamped) {
    data.start_derivative = {random.rational(), 1, 2};
    data.end_derivative = {3, random.rational(), 4};
  }
  return data;
}

/// r″ at the start and end of a piece, by its control points.
Vector<Rational> second_at_start(const BezierPoints& b, const Rational& step) {
  return Rational(6 / (step * step)) * (b[0] - Rational(2) * b[1] + b[2]);
}
Vector<Rational> second_at_end(const BezierPoints& b, const Rational& step) {
  return Rational(6 / (step * step)) * (b[3] - Rational(2) * b[2] + b[1]);
}
Vector<Rational> first_at_start(const BezierPoints& b, const Rational& step) {
  return Rational(3 / step) * (b[1] - b[0]);
}
Vector<Rational> first_at_end(const BezierPoints& b, const Rational& step) {
  return Rational(3 / step) * (b[3] - b[2]);
}

/// What defines the spline: its points, C¹ exactly, and second derivatives off by what the error
/// allows: 4/h from each of the two derivatives and 2/h from each at the other end, on both sides.
void check_spline(const CubicInterpolation& data) {
  const auto derivatives = cubic_derivatives(data);
  const Rational error = error_of_derivatives(data, derivatives);
  const std::size_t n = data.points.size() - 1;
  std::vector<BezierPoints> pieces;
  for (std::size_t k = 0; k < n; ++k) pieces.push_back(cubic_piece(data, derivatives, k));
  const auto step = [&](std::size_t k) {
    return Rational(data.parameters[k + 1] - data.parameters[k]);
  };
  const auto check_second = [&](const Vector<Rational>& difference, const Rational& least_step) {
    CHECK(largest(difference) <= 12 * error / least_step);
  };
  for (std::size_t k = 0; k < n; ++k) {
    CHECK(pieces[k].front() == data.points[k]);
    CHECK(pieces[k].back() == data.points[k + 1]);
    if (k == 0) continue;
    CHECK(first_at_end(pieces[k - 1], step(k - 1)) == first_at_start(pieces[k], step(k)));
    check_second(second_at_end(pieces[k - 1], step(k - 1)) - second_at_start(pieces[k], step(k)),
                 std::min(step(k - 1), step(k)));
  }
  const Vector<Rational> first = second_at_start(pieces.front(), step(0));
  const Vector<Rational> last = second_at_end(pieces.back(), step(n - 1));
  switch (data.ends) {
    case SplineEnds::natural:  // exactly: next to 0 there would be any torsion
      CHECK(first == Vector<Rational>{});
      CHECK(last == Vector<Rational>{});
      break;
    case SplineEnds::clamped:
      CHECK(first_at_start(pieces.front(), step(0)) == data.start_derivative);
      CHECK(first_at_end(pieces.back(), step(n - 1)) == data.end_derivative);
      break;
    case SplineEnds::periodic:
      CHECK(first_at_start(pieces.front(), step(0)) == first_at_end(pieces.back(), step(n - 1)));
      check_second(first - last, std::min(step(0), step(n - 1)));
  }
}

constexpr SplineEnds all_ends[] = {SplineEnds::natural, SplineEnds::clamped, SplineEnds::periodic};

std::string refusal(const CubicInterpolation& data) {
  return test::refusal_of<DomainError>([&] { cubic_derivatives(data); });
}

}  // namespace

TEST_CASE("few points: the spline is C² and has its ends, exactly") {
  for_samples(12, [](Random& random) {
    for (const SplineEnds ends : all_ends) {
      const auto data = random_interpolation(
          random, random.integer(ends == SplineEnds::periodic ? 3 : 2, 12), ends);
      CHECK(error_of_derivatives(data, cubic_derivatives(data)) == 0);
      check_spline(data);
    }
  });
}

TEST_CASE("many points: C¹ exactly, short numbers, and near the C² spline") {
  Random random(19);
  for (const SplineEnds ends : all_ends) {
    const auto data = random_interpolation(random, exact_cubic_points + 20, ends);
    const auto derivatives = cubic_derivatives(data);
    const Rational error = error_of_derivatives(data, derivatives);
    const Rational size = largest(derivatives);
    CHECK(error > 0);
    CHECK(error < size * power_of_two(-100));
    for (std::size_t k = 1; k + 1 < derivatives.size(); ++k)
      CHECK(bit_length(numerator(derivatives[k][0])) < 300);
    check_spline(data);
  }
}

TEST_CASE("many points in a line or a plane: the spline stays in it, exactly") {
  for_samples(3, [](Random& random) {
    for (const SplineEnds ends : all_ends) {
      auto data = random_interpolation(random, exact_cubic_points + 10, ends);
      const Vector<Rational> v{random.rational(), 1, random.rational()};
      const Vector<Rational> w{1, random.rational(), random.rational()};
      for (const bool is_plane : {false, true}) {
        const auto in_span = [&](const Vector<Rational>& p) {
          return is_plane ? p[0] * v + p[1] * w : Rational(p[0] + 3 * p[1]) * v;
        };
        auto moved = data;
        for (Vector<Rational>& p : moved.points) p = in_span(p);
        moved.start_derivative = in_span(data.start_derivative);
        moved.end_derivative = in_span(data.end_derivative);
        for (const Vector<Rational>& d : cubic_derivatives(moved))
          CHECK((is_plane ? dot(cross(v, w), d) == 0 : largest(cross(v, d)) == 0));
        check_spline(moved);
      }
    }
  });
}

TEST_CASE("the derivatives are those of SciPy's CubicSpline") {
  std::ifstream file(test::data("/splines.json"));
  const auto document = nlohmann::json::parse(file);
  const auto vector = [](const nlohmann::json& x) {
    return Vector<Rational>{exact_rational(x[0].get<double>()), exact_rational(x[1].get<double>()),
                            exact_rational(x[2].get<double>())};
  };
  for (const auto& given : document["cubics"]) {
    CAPTURE(given["name"].get<std::string>());
    CubicInterpolation data;
    for (const auto& p : given["points"]) data.points.push_back(vector(p));
    for (const auto& t : given["parameters"])
      data.parameters.push_back(exact_rational(t.get<double>()));
    if (given["ends"] == "periodic") data.ends = SplineEnds::periodic;
    if (given["ends"] == "clamped") {
      data.ends = SplineEnds::clamped;
      data.start_derivative = vector(given["end_derivatives"][0]);
      data.end_derivative = vector(given["end_derivatives"][1]);
    }
    const auto derivatives = cubic_derivatives(data);
    for (std::size_t k = 0; k < derivatives.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(static_cast<double>(derivatives[k][c]) ==
              doctest::Approx(given["derivatives"][k][c].get<double>()).epsilon(1e-12));
  }
}

TEST_CASE("parameters: uniform, lengths of chords or their roots, in short fractions") {
  const std::vector<Vector<Rational>> points{{0, 0, 0}, {16, 0, 0}, {16, 0, 25}, {15, 2, 27}};
  CHECK(parameters_of(points, ParameterChoice::uniform) == std::vector<Rational>{0, 1, 2, 3});
  CHECK(parameters_of(points, ParameterChoice::chord_lengths) ==
        std::vector<Rational>{0, 16, 41, 44});
  const auto roots = parameters_of(points, ParameterChoice::centripetal);
  CHECK(roots[2] == 9);
  CHECK(static_cast<double>(Rational(roots[3] - roots[2])) ==
        doctest::Approx(1.7320508).epsilon(1e-3));
  CHECK(bit_length(numerator(roots[3])) < 20);
  const std::vector<Vector<Rational>> twice{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_AS(parameters_of(twice, ParameterChoice::centripetal), DomainError);
  CHECK(parameters_of(twice, ParameterChoice::uniform).back() == 2);
}

TEST_CASE("what has no cubic spline is refused") {
  const std::vector<Vector<Rational>> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(refusal({{{0, 0, 0}}, {0}}) == "a cubic spline has 2 points at least, not 1");
  CHECK(refusal({three, {0, 1}}) == "2 parameters for 3 points");
  CHECK(refusal({three, {0, 1, 1}}) == "the parameters do not increase: 1 after 1");
  CHECK(refusal({three, {0, 1, 2}, SplineEnds::periodic}) ==
        "a periodic spline ends at its first point, (0, 0, 0), not (0, 1, 0)");
  CHECK(refusal({{{0, 0, 0}, {0, 0, 0}}, {0, 1}, SplineEnds::periodic}) ==
        "a periodic cubic spline has 3 points at least, not 2");
}
