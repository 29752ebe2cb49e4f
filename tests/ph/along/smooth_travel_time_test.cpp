#include "phrame/ph/along/smooth_travel_time.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/travel_time.hpp"
#include "support/random.hpp"

namespace smooth_travel_time_test {

using namespace phrame;
using test::for_samples;
using test::Random;

/// (t, t², t³)·k: the arc length is an elliptic integral.
TEST_CASE("smooth travel time: what rounds to the same double as the total is the end") {
  long beyond = 0;
  for_samples(12, [&](Random& random) {
    const Rational k(random.integer(1, 50), random.integer(1, 20));
    const Path path(
        Segment(RationalCurve({Polynomial{0, k}, Polynomial{0, 0, k}, Polynomial{0, 0, 0, k}})));
    const Polynomial speed =
        random.chance(2) ? Polynomial{k + 1} : Polynomial{k, random.integer(1, 9)};
    const SmoothTravelTime time(path, {RationalFunction(speed), Feedrate::Of::arc_length});
    const Rational near = exact_rational(round_to_double(time.total()));
    if (compare_time(near, time.total(), "") > 0) {
      ++beyond;
      CHECK(time.at_time(near).at.t.exact() == Rational(1));
    }
    CHECK_THROWS_AS(time.at_time(near * (1 + power_of_two(-51))), DomainError);
  });
  CHECK(beyond > 0);
}

}  // namespace smooth_travel_time_test
