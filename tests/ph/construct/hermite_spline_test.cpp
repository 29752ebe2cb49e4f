#include "phrame/ph/construct/hermite_spline.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

GivenPoints points(const std::vector<Vector<Rational>>& list) {
  GivenPoints given;
  given.points = list;
  return given;
}

std::string refusal(const GivenPoints& given, bool is_closed) {
  return test::refusal_of<DomainError>([&] { hermite_spline(given, is_closed); });
}

/// Second derivative of the cubic with these Hermite data, at 0 or at 1 of a step h.
Rational second_derivative(const HermiteSpline& data, std::size_t k, std::size_t coordinate,
                           bool at_end) {
  const Rational h = data.parameters[k + 1] - data.parameters[k];
  const Rational step = data.points[k + 1][coordinate] - data.points[k][coordinate];
  const Rational d0 = data.derivatives[k][coordinate];
  const Rational d1 = data.derivatives[k + 1][coordinate];
  return at_end ? Rational((4 * d1 + 2 * d0) / h - 6 * step / (h * h))
                : Rational(6 * step / (h * h) - (4 * d0 + 2 * d1) / h);
}

bool is_small(const Rational& x) { return abs(x) < power_of_two(-30); }

}  // namespace

TEST_CASE("hermite data: derivatives not given are those of the C² cubic spline") {
  for_samples(20, [](Random& random) {
    GivenPoints given;
    given.parameters = {0};
    const long n = random.integer(2, 7);
    for (long k = 0; k <= n; ++k) {
      given.points.push_back({random.integer(-9, 9), random.integer(-9, 9), 2 * k});
      if (k > 0)
        given.parameters.push_back(given.parameters.back() + Rational(random.integer(1, 5), 2));
    }
    const HermiteSpline natural = hermite_spline(given, false);
    const auto last = static_cast<std::size_t>(n) - 1;
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(is_small(second_derivative(natural, 0, c, false)));
      CHECK(is_small(second_derivative(natural, last, c, true)));
      for (std::size_t k = 0; k < last; ++k)
        CHECK(is_small(second_derivative(natural, k, c, true) -
                       second_derivative(natural, k + 1, c, false)));
    }
    given.parameters.push_back(given.parameters.back() + 1);
    const HermiteSpline periodic = hermite_spline(given, true);
    REQUIRE(periodic.segments() == given.points.size());
    CHECK(periodic.points.back() == periodic.points.front());
    CHECK(periodic.derivatives.back() == periodic.derivatives.front());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < periodic.segments(); ++k)
        CHECK(is_small(second_derivative(periodic, k, c, true) -
                       second_derivative(periodic, (k + 1) % periodic.segments(), c, false)));
  });
}

TEST_CASE("hermite data: a closed spline of two points goes to the other one and back") {
  const HermiteSpline data = hermite_spline(points({{0, 0, 0}, {1, 0, 0}}), true);
  CHECK(data.segments() == 2);
  CHECK(data.derivatives[0] == Vector<Rational>{0, 0, 0});  // by symmetry
}

TEST_CASE("hermite data: parameters are chord lengths of 12 bits, or 0, 1, … beside derivatives") {
  GivenPoints given = points({{0, 0, 0}, {3, 4, 0}, {3, 4, 1}, {4, 5, 2}});
  const HermiteSpline chords = hermite_spline(given, false);
  CHECK(parameter_source(given) == ParameterSource::chord_lengths);
  CHECK(chords.parameters[1] == 5);
  CHECK(chords.parameters[2] == 6);
  const Rational third = chords.parameters[3] - 6;  // √3
  CHECK(abs(third * third - 3) < Rational(1, 500));
  CHECK(bit_length(numerator(third)) <= 12);
  given.derivatives = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const HermiteSpline whole = hermite_spline(given, false);
  CHECK(whole.parameters == std::vector<Rational>{0, 1, 2, 3});
  CHECK(whole.derivatives == given.derivatives);
  given.parameters = {0, Rational(1, 2), 7, 8};
  CHECK(hermite_spline(given, false).parameters == given.parameters);
}

TEST_CASE("hermite data: tangents keep their directions and get the speed of the chords") {
  GivenPoints given = points({{0, 0, 0}, {3, 4, 0}, {3, 4, 1}});
  given.tangents = {{0, 0, 700}, {1, 1, 0}, {-1, -2, -2}};
  const HermiteSpline data = hermite_spline(given, false);
  CHECK(derivative_source(given, false) == DerivativeSource::tangents);
  CHECK(data.derivatives[0][0] == 0);
  CHECK(abs(data.derivatives[0][2] - 1) < Rational(1, 500));
  CHECK(data.derivatives[1][0] == data.derivatives[1][1]);
  CHECK(data.derivatives[2][1] == 2 * data.derivatives[2][0]);
  CHECK(abs(data.derivatives[2][2] + Rational(2, 3)) < Rational(1, 500));
  given.parameters = {0, 1, 2};  // speeds 5 and 1
  CHECK(abs(hermite_spline(given, false).derivatives[0][2] - 5) < Rational(1, 100));
}

// Chords of 4, 8 and √80 ≈ 8.94, the last by the step 2: the mean of the first one and the last
// is 4.236 at the first point and at the end, which are one.
TEST_CASE("hermite data: of a closed curve the first tangent has the chords before and after it") {
  GivenPoints given = points({{0, 0, 0}, {4, 0, 0}, {4, 8, 0}});
  given.tangents = {{3, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  given.parameters = {0, 1, 2, 4};
  const HermiteSpline data = hermite_spline(given, true);
  CHECK(data.derivatives.front() == data.derivatives.back());
  CHECK(abs(data.derivatives[0][0] - parse_rational("4.236")) < parse_rational("0.002"));
  CHECK(abs(data.derivatives[1][1] - 6) < parse_rational("0.002"));
}

TEST_CASE("hermite data: points on a line have derivatives along it, exactly") {
  const Vector<Rational> way{1, Rational(-2, 7), 3};
  for (const bool is_closed : {false, true}) {
    GivenPoints given;
    for (const long s : {0, 2, 3, 7, 5})
      given.points.push_back(Vector<Rational>{1, 1, 1} + Rational(s) * way);
    for (const Vector<Rational>& d : hermite_spline(given, is_closed).derivatives)
      CHECK(d == Rational(d[0]) * way);
  }
}

TEST_CASE("hermite data: a closed one ends at its first point, given there or not") {
  GivenPoints open = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  GivenPoints closed = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
  CHECK(hermite_spline(open, true).derivatives == hermite_spline(closed, true).derivatives);
  CHECK(derivative_source(open, true) == DerivativeSource::periodic_spline);
  open.derivatives = {{1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  CHECK(hermite_spline(open, true).derivatives.back() == Vector<Rational>{1, 0, 0});
}

TEST_CASE("hermite data: sizes are those of what is wanted") {
  GivenPoints given = points({{100, 0, 0}, {103, 4, 0}});
  given.derivatives = {{1, -7, 0}, {2, 0, 0}};
  const HermiteSpline data = hermite_spline(given, false);
  CHECK(size_of_points(data) == 4);
  CHECK(size_of_derivatives(data) == 7);
  given.points[1] = given.points[0];
  CHECK(size_of_points(hermite_spline(given, false)) == 7);
}

TEST_CASE("hermite data: what has no meaning is refused, with its place") {
  CHECK(refusal(points({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}), false) ==
        "the points 2 and 3 of 3 are equal: only with derivatives and parameters is it known how a "
        "curve goes from one to the other");
  GivenPoints given = points({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
  given.derivatives = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(refusal(given, true) ==
        "the closed curve ends with another derivative than it starts with, at the same point");
  given = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  given.parameters = {0, 1, 2};
  CHECK(refusal(given, true) ==
        "3 parameters for 4 points, of which the last is the first: the last parameter is that of "
        "the end");
  CHECK(refusal(given, false).empty());
}

TEST_CASE("hermite_spline: accelerations come along, the first once more at the end of a ring") {
  GivenPoints given;
  given.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  given.accelerations = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  CHECK(hermite_spline(given, false).accelerations == given.accelerations);
  const HermiteSpline ring = hermite_spline(given, true);
  REQUIRE(ring.accelerations.size() == 4);
  CHECK(ring.accelerations.back() == given.accelerations.front());
  CHECK(size_of_accelerations(ring) == 9);
  given.points.push_back(given.points.front());
  given.accelerations.push_back({1, 2, 4});
  CHECK_THROWS_WITH_AS(hermite_spline(given, true),
                       "the closed curve ends with another acceleration than it starts with, at "
                       "the same point",
                       DomainError);
}

TEST_CASE("parameter_steps: multiples of one number, as great as can be") {
  HermiteSpline data;
  data.points.assign(4, {});
  data.parameters = {Rational(1, 2), Rational(5, 6), Rational(3, 2), Rational(19, 6)};
  const ParameterSteps steps = parameter_steps(data);
  CHECK(steps.unit == Rational(1, 3));
  CHECK(steps.counts == std::vector<Integer>{1, 2, 5});
}
