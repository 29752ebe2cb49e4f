#include "phrame/ph/construct/length_spline.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/hermite.hpp"

namespace length_spline_test {

using namespace phrame;
using test::for_samples;
using test::is_within;
using test::one_segment;
using test::Random;
using test::random_spline;

namespace {

const Deviation fine{power_of_two(-60), power_of_two(-50), 0, power_of_two(-60)};

double size(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

/// What is claimed, from integrals of the hodographs.
void check_claims(const HermiteSpline& data, const std::vector<Rational>& lengths) {
  const Construction found = length_spline(data, lengths, fine);
  CHECK(is_within(found.deviation, fine));
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Curve& curve = found.path.segments()[k];
    CHECK(is_within(evaluate(position(curve), 1) - data.points[k + 1], found.deviation.points));
    CHECK(abs(Rational(arc_length(curve)(1) - lengths[k])) <= found.deviation.lengths);
    for (const long end : {0, 1}) {
      const Vector<double> d = scaled_to_doubles(1, evaluate(hodograph(curve), end));
      const Vector<double> t =
          scaled_to_doubles(1, data.derivatives[k + static_cast<std::size_t>(end)]);
      CHECK(dot(d, t) > 0);
      CHECK(size(cross(d, t)) <= 1e-14 * size(d) * size(t));
      // The same speed at both ends, the step of the parameter.
      CHECK(std::abs(size(d) / static_cast<double>(
                                   Rational(found.parameters[k + 1] - found.parameters[k])) -
                     1) < 1e-14);
    }
  }
}

}  // namespace

TEST_CASE("length spline: law: points, tangents and lengths are met within what is claimed") {
  for_samples(6, [](Random& random) {
    const HermiteSpline data = random_spline(random, 3);
    std::vector<Rational> lengths;
    for (std::size_t k = 0; k < data.segments(); ++k)
      lengths.push_back(rounded_length(data.points[k + 1] - data.points[k], 20) *
                        Rational(1000 + random.integer(1, random.chance(2) ? 20 : 9000), 1000));
    check_claims(data, lengths);
  });
}

// QuinticFamily has the length by another formula, that for given derivatives.
TEST_CASE("length spline: the quintic with these speeds at its ends has that length") {
  const HermiteSpline data = one_segment({1, 2, 2}, {1, 1, -3}, {-2, 1, 1});
  for (const long L : {4, 7, 30}) {
    const Construction found = length_spline(data, {Rational(L)}, fine);
    const double w = static_cast<double>(Rational(found.parameters[1] - found.parameters[0]));
    const QuinticFamily family({{1, 2, 2},
                                w / std::sqrt(11.0) * Vector<double>{1, 1, -3},
                                w / std::sqrt(6.0) * Vector<double>{-2, 1, 1}});
    const double delta = round_to_double(to_real(found.angles[0].delta));
    CHECK(std::abs(family.length(delta) / static_cast<double>(L) - 1) < 1e-13);
  }
}

TEST_CASE("length spline: opposite tangents, lines and loops are possible, shorter ways are not") {
  check_claims(one_segment({1, 0, 0}, {1, 0, 0}, {-1, 0, 0}), {Rational(5, 4)});
  check_claims(one_segment({1, 0, 0}, {1, 0, 0}, {1, 0, 0}), {Rational(5, 4)});
  check_claims(one_segment({1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}), {Rational(2)});
  check_claims(one_segment({0, 0, 3}, {0, 1, 0}, {0, 1, 0}), {Rational(301, 100)});
  const HermiteSpline data = one_segment({3, 0, 4}, {0, 1, 0}, {1, 0, 0});
  for (const long L : {-6, 0, 4, 5})
    CHECK_THROWS_WITH_AS(length_spline(data, {Rational(L)}, fine),
                         doctest::Contains("segment 1: the length"), DomainError);
}

TEST_CASE("length spline: one length of the whole is shared in proportion to the chords") {
  HermiteSpline data = one_segment({3, 0, 4}, {0, 1, 0}, {1, 0, 0});
  data.points.push_back({3, 0, 14});
  data.derivatives.push_back({1, 0, 0});
  data.parameters.push_back(data.parameters.back() + 1);
  CHECK(segment_lengths(data, {Rational(30)}) == std::vector<Rational>{10, 20});
  CHECK(segment_lengths(data, {Rational(6), Rational(11)}) == std::vector<Rational>{6, 11});
  CHECK_THROWS_WITH_AS(segment_lengths(data, {1, 2, 3}),
                       doctest::Contains("3 lengths for 2 segments"), DomainError);
}

}  // namespace length_spline_test
